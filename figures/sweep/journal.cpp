#include "figures/sweep/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "figures/data/files.hpp"
#include "figures/data/text.hpp"

namespace rotor {
namespace {

/// The check sum after a further text (FNV-1a, from Fowler, Noll and Vo).
constexpr std::uint64_t first_sum = 0xcbf29ce484222325U;
std::uint64_t sum_with(std::uint64_t sum, std::string_view text) {
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return sum;
}

std::string line_of(std::uint64_t sum, std::string_view entry) {
  return fmt::format("{:016x} {}", sum, entry);
}

}  // namespace

std::string difference(std::string_view head, std::string_view wanted, std::string_view advice) {
  if (head.starts_with("\xef\xbb\xbf"))
    return "starts with a byte-order mark, which another program has added: remove the mark";
  std::istringstream has{std::string(head)}, needs{std::string(wanted)};
  std::string its, other;
  do {
    std::getline(has, its);
    std::getline(needs, other);
  } while (its == other && has && needs);
  if (its == other + '\r')
    return "has lines that end in CR LF, as another program has written them: change them to LF";
  return fmt::format(
      R"(is of another sweep file or version of rotor: has "{}" instead of "{}"; {})", shown(its),
      shown(other), advice);
}

Journal::Journal(const std::filesystem::path& file, std::string head, long points)
    : file_(file), path_(file.string() + ".journal"), head_(std::move(head)), points_(points) {
  try {
    // The sweep that held the lock may have finished, and removed the file that was opened here.
    do open();
    while (!is_at(descriptor_, path_));
    resume();
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

void Journal::open() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK | O_NOCTTY, 0666);
  struct stat status {};
  if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0) fail_by_errno();
  if (!S_ISREG(status.st_mode)) fail("must be a regular file: the sweep resumes from it");
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  if (errno == EWOULDBLOCK) fail("another sweep is writing it");
  fail_by_errno("cannot be locked");
}

Journal::~Journal() { ::close(descriptor_); }

/// Reads the head and the rows up to the first that is damaged or of no further point. Returns
/// where they end: 0 if the head is incomplete.
template <class Take>
off_t Journal::read_rows(const Take& take) {
  std::ifstream stream(path_, std::ios::binary);
  std::string head(head_.size(), '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  if (!stream.is_open() || stream.bad()) fail_by_errno("cannot be read");
  if (!head_.starts_with(head)) fail(difference(head, head_, "resume with that, or remove it"));
  if (head != head_) return 0;
  sum_ = sum_with(first_sum, head);
  auto end = static_cast<off_t>(head.size());
  std::string line;
  for (DonePoints done; std::getline(stream, line) && !stream.eof();) {
    const std::size_t mark = line.find(' ');
    const std::string entry = line.substr(mark == std::string::npos ? line.size() : mark + 1);
    const std::uint64_t sum = sum_with(sum_, entry);
    long point = points_;
    const auto [row, error] = std::from_chars(entry.data(), entry.data() + entry.size(), point);
    if (line != line_of(sum, entry) || *row != ' ' || point >= points_ || done.has(point)) break;
    sum_ = sum;
    end += static_cast<off_t>(line.size() + 1);
    done.add(point);
    take(point, std::string(row + 1));
  }
  if (stream.bad()) fail_by_errno("cannot be read");
  return end;
}

/// Cuts off the first damaged row and all that follows; everything, if the head is incomplete.
void Journal::resume() {
  const off_t end = read_rows([&](long point, const std::string& /*row*/) { done_.add(point); });
  dropped_ = ::lseek(descriptor_, 0, SEEK_END) - end;
  if (::ftruncate(descriptor_, end) != 0 || ::lseek(descriptor_, end, SEEK_SET) < 0)
    fail_by_errno();
  if (end > 0) return;
  sum_ = sum_with(first_sum, head_);
  write_all(head_);
}

void Journal::write(long point, std::string_view row) {
  const std::string entry = fmt::format("{} {}", point, row.substr(0, row.find('\n')));
  sum_ = sum_with(sum_, entry);
  done_.add(point);
  write_all(line_of(sum_, entry) + '\n');
}

void Journal::write_all(std::string_view text) {
  while (!text.empty()) {
    const ssize_t size = ::write(descriptor_, text.data(), text.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) fail_by_errno();
    text.remove_prefix(static_cast<std::size_t>(size));
  }
}

/// The results are on the disk before the journal is removed.
void Journal::finish(const std::function<void(std::string_view row)>& see) {
  OutputFile results(file_);
  results.write(head_);
  DonePoints written;
  std::map<long, std::string> early;
  read_rows([&](long point, std::string read) {
    written.add(point);
    early.emplace(point, std::move(read));
    for (; !early.empty() && early.begin()->first < written.first_missing();
         early.erase(early.begin())) {
      const std::string& row = early.begin()->second;
      results.write(row + '\n');
      if (see) see(row);
    }
  });
  if (written.first_missing() != points_) fail("was changed by another program");
  results.sync();
  results.commit();
  std::filesystem::remove(path_);
}

void Journal::fail(std::string_view reason) const {
  throw std::runtime_error(fmt::format("{}: {}", path_.string(), reason));
}

void Journal::fail_by_errno(std::string_view what) const {
  fail(fmt::format("{}: {}", what, std::strerror(errno)));
}

}  // namespace rotor
