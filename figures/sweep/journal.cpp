#include "figures/sweep/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "figures/data/files.hpp"
#include "figures/data/text.hpp"

namespace rotor {

std::string difference(std::string_view head, std::string_view wanted, std::string_view advice) {
  if (head.starts_with("\xef\xbb\xbf"))
    return "starts with a byte-order mark, which another program has added: remove the mark";
  std::istringstream has{std::string(head)}, needs{std::string(wanted)};
  std::string line, other;
  do {
    std::getline(has, line);
    std::getline(needs, other);
  } while (line == other && has && needs);
  if (line == other + '\r')
    return "has lines that end in CR LF, as another program has written them: change them to LF";
  return fmt::format(
      R"(is of another sweep file or version of rotor: has "{}" instead of "{}"; {})", shown(line),
      shown(other), advice);
}

Journal::Journal(const std::filesystem::path& file, std::string head, long points,
                 IsRowOf is_row_of)
    : file_(file),
      path_(file.string() + ".journal"),
      head_(std::move(head)),
      is_row_of_(std::move(is_row_of)),
      points_(points) {
  try {
    // The sweep that held the lock may have finished, and removed the file that was opened here.
    do open();
    while (!is_at(descriptor_, path_));
    const off_t end = read_rows({});
    dropped_ = ::lseek(descriptor_, 0, SEEK_END) - end;
    if (::ftruncate(descriptor_, end) != 0 || ::lseek(descriptor_, end, SEEK_SET) < 0)
      fail_by_errno();
    if (end == 0) write_all(head_);
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

/// Reads the head and the rows that are good. Returns where they end: 0 if the head is incomplete.
off_t Journal::read_rows(const std::function<void(std::string_view row)>& see) {
  std::ifstream stream(path_, std::ios::binary);
  std::string line(head_.size(), '\0');
  stream.read(line.data(), static_cast<std::streamsize>(line.size()));
  line.resize(static_cast<std::size_t>(stream.gcount()));
  if (!stream.is_open() || stream.bad()) fail_by_errno("cannot be read");
  if (!head_.starts_with(line)) fail(difference(line, head_, "resume with that, or remove it"));
  if (line != head_) return 0;
  auto end = static_cast<off_t>(line.size());
  for (rows_ = 0; rows_ < points_ && std::getline(stream, line) && !stream.eof(); ++rows_) {
    if (!is_row_of_(rows_, line)) break;
    end += static_cast<off_t>(line.size() + 1);
    if (see) see(line);
  }
  if (stream.bad()) fail_by_errno("cannot be read");
  return end;
}

void Journal::write(std::string_view row) {
  write_all(row);
  ++rows_;
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
  const long written = rows_;
  read_rows([&](std::string_view row) {
    results.write(row);
    results.write("\n");
    if (see) see(row);
  });
  if (rows_ != written || rows_ != points_) fail("was changed by another program");
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
