#include "figures/sweep/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "figures/data/files.hpp"

namespace rotor {

std::filesystem::path journal_of(const std::filesystem::path& file) {
  return file.string() + ".journal";
}

Journal::Journal(const std::filesystem::path& file, ResultHeads heads, long points)
    : file_(file), path_(journal_of(file)), heads_(std::move(heads)), points_(points) {
  try {
    // The sweep that held the lock may have finished, and removed the file that was opened here.
    do open();
    while (!is_at(descriptor_, path_));
    const off_t end = read_rows({});
    dropped_ = ::lseek(descriptor_, 0, SEEK_END) - end;
    if (::ftruncate(descriptor_, end) != 0 || ::lseek(descriptor_, end, SEEK_SET) < 0)
      fail_by_errno();
    if (end == 0) write_all(own_head());
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

/// The head with the name of the check sums.
std::string Journal::own_head() const {
  return heads_.results.substr(0, heads_.results.size() - 1) + ",crc32\n";
}

/// Reads the head and the rows that are good. Returns where they end: 0 if the head is incomplete.
off_t Journal::read_rows(const std::function<void(std::string_view line)>& see) {
  rows_ = 0;
  sum_ = {};
  sum_.add(heads_.results);
  const std::string wanted = own_head(), head = read_file(path_, wanted.size());
  if (!wanted.starts_with(head)) fail(difference(head, wanted, "resume with that, or remove it"));
  if (head != wanted) return 0;
  std::ifstream stream(path_, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(head.size()));
  auto end = static_cast<off_t>(head.size());
  for (std::string line; rows_ < points_ && std::getline(stream, line) && !stream.eof(); ++rows_) {
    const std::string row = line.substr(0, line.rfind(','));
    CheckSum sum = sum_;
    sum.add(row + '\n');
    if (line != row + ',' + sum.text()) break;
    sum_ = sum;
    end += static_cast<off_t>(line.size() + 1);
    if (see) see(row);
  }
  if (!stream.is_open() || stream.bad()) fail_by_errno("cannot be read");
  return end;
}

void Journal::write(std::string_view line) {
  sum_.add(line);
  sum_.add("\n");
  write_all(fmt::format("{},{}\n", line, sum_.text()));
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
void Journal::write_results(const std::function<void(std::string_view line)>& see) {
  PointsWriter results(file_, heads_);
  read_rows([&](std::string_view line) {
    results.write(line);
    if (see) see(line);
  });
  if (rows_ != points_) fail("was changed by another program");
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
