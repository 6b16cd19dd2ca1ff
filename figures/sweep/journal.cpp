#include "figures/sweep/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "figures/data/files.hpp"

namespace rotor {
namespace {

/// Reads a file on, in pieces.
template <class Take>
bool read_all(int descriptor, const Take& take) {
  std::array<char, 65536> piece{};
  for (;;) {
    const ssize_t size = ::read(descriptor, piece.data(), piece.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) return false;
    if (size == 0) return true;
    take(std::string_view(piece.data(), static_cast<std::size_t>(size)));
  }
}

}  // namespace

Journal::Journal(const std::filesystem::path& file, std::string_view head)
    : file_(file), path_(file.string() + ".journal") {
  std::error_code ignored;  // what cannot be made is said below
  std::filesystem::create_directories(std::filesystem::absolute(path_).parent_path(), ignored);
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail_by_errno();
  try {
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) fail("another sweep is writing it");
    take_up(head);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

Journal::~Journal() { ::close(descriptor_); }

/// A row that was cut short is cut off; in a head that was, everything is.
void Journal::take_up(std::string_view head) {
  std::string beginning;
  off_t size = 0, whole = 0;
  const bool is_read = read_all(descriptor_, [&](std::string_view piece) {
    beginning += piece.substr(0, head.size() - std::min(head.size(), beginning.size()));
    for (const char c : piece) {
      if (++size <= static_cast<off_t>(head.size()) || c != '\n') continue;
      whole = size;
      ++rows_;
    }
  });
  if (!is_read) fail_by_errno();
  if (!head.starts_with(beginning))
    fail("is of another sweep file or another version; go on with that one, or remove it");
  if (beginning.size() < head.size()) {
    if (::ftruncate(descriptor_, 0) != 0 || ::lseek(descriptor_, 0, SEEK_SET) < 0) fail_by_errno();
    write(head);
    return;
  }
  whole = std::max(whole, static_cast<off_t>(head.size()));
  if (::ftruncate(descriptor_, whole) != 0 || ::lseek(descriptor_, whole, SEEK_SET) < 0)
    fail_by_errno();
}

void Journal::write(std::string_view rows) {
  while (!rows.empty()) {
    const ssize_t size = ::write(descriptor_, rows.data(), rows.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) fail_by_errno();
    rows.remove_prefix(static_cast<std::size_t>(size));
  }
}

void Journal::finish() {
  if (::lseek(descriptor_, 0, SEEK_SET) < 0) fail_by_errno();
  FileTransaction files;
  OutputFile& results = files.open(file_);
  if (!read_all(descriptor_, [&](std::string_view piece) { results.write(piece); }))
    fail_by_errno();
  files.commit();
  std::filesystem::remove(path_);
}

void Journal::fail(std::string_view reason) const {
  throw std::runtime_error(fmt::format("{}: {}", path_.string(), reason));
}

void Journal::fail_by_errno() const {
  fail(fmt::format("cannot be written: {}", std::strerror(errno)));
}

}  // namespace rotor
