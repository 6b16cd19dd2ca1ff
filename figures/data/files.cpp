#include "figures/data/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "figures/data/interruption.hpp"
#include "figures/data/text.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

/// The target of a path through links, whether it exists or not.
fs::path resolved(fs::path file) {
  std::error_code error;
  constexpr int most_links = 40;
  for (int links = 0; links < most_links && fs::is_symlink(file, error); ++links) {
    const fs::path to = fs::read_symlink(file, error);
    file = to.is_absolute() ? to : file.parent_path() / to;
  }
  const fs::path absolute = fs::absolute(file, error);  // after a link, .. is not its parent
  return fs::weakly_canonical(absolute.parent_path(), error) / absolute.filename();
}

/// Identifies a file, whatever path leads to it; empty for a device, which may be used many times.
std::string identity(const fs::path& file) {
  if (is_standard_output(file)) return "-";
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return resolved(file).string();
  return S_ISCHR(status.st_mode) ? "" : fmt::format("{}:{}", status.st_dev, status.st_ino);
}

/// Removes a draft that no process has locked. Others' drafts stay, even if they could be removed.
void remove_if_abandoned(const fs::path& draft) {
  const int descriptor =
      ::open(draft.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (descriptor < 0) return;
  struct stat status {};
  std::error_code ignored;
  if (::fstat(descriptor, &status) == 0 && status.st_uid == ::geteuid() &&
      ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && is_at(descriptor, draft))
    fs::remove_all(draft, ignored);
  ::close(descriptor);
}

}  // namespace

std::string read_file(const fs::path& file, std::size_t most) {
  // A stream of C++ would wait for a pipe's writer even if it is interrupted.
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rbe"),
                                                               std::fclose);
  std::string text(most, '\0');
  if (stream) text.resize(std::fread(text.data(), 1, most, stream.get()));
  if (stream && std::ferror(stream.get()) == 0) return text;
  if (is_interrupted()) throw Interrupted();
  throw std::runtime_error(
      fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
}

std::string name_made_from(const fs::path& file, std::string_view ending) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  const std::string absolute = fs::absolute(file, error).string();
  if ((fs::exists(status) && !fs::is_regular_file(status)) || absolute.starts_with("/dev/") ||
      absolute.starts_with("/proc/"))
    throw std::runtime_error(
        fmt::format("--out: must be stated, because {} has no name of its own", shown(absolute)));
  return file.stem().string().append(ending);
}

bool is_at(int descriptor, const fs::path& path) {
  struct stat opened {
  }, there{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &there) == 0 &&
         opened.st_dev == there.st_dev && opened.st_ino == there.st_ino;
}

Draft::Draft(const fs::path& of, Kind kind) {
  const bool is_folder = kind == Kind::folder;
  for (int number = 0;; ++number) {
    path = of.parent_path() / fmt::format(".{}.{}.part", of.filename().string(), number);
    remove_if_abandoned(path);
    const bool is_there = is_folder && ::mkdir(path.c_str(), 0700) == 0;
    if (is_there || !is_folder)
      descriptor = ::open(
          path.c_str(),
          O_CLOEXEC | (is_folder ? O_RDONLY | O_DIRECTORY : O_WRONLY | O_CREAT | O_EXCL), 0666);
    // Another process is writing it, or has taken it for abandoned before it was locked.
    if (descriptor < 0 && errno == (is_there ? ENOENT : EEXIST)) continue;
    if (descriptor < 0) throw std::system_error(errno, std::generic_category());
    static_cast<void>(::flock(descriptor, LOCK_EX));  // some file systems have no locks
    if (is_at(descriptor, path)) return;
    ::close(std::exchange(descriptor, -1));
  }
}

bool is_standard_output(const fs::path& file) {
  std::error_code error;
  return file == "-" || (is_at(STDOUT_FILENO, file) &&
                         (!fs::is_character_file(file, error) || ::isatty(STDOUT_FILENO) == 1));
}

OutputFile::OutputFile(const fs::path& file) : named_(file), target_(file) {
  if (file.empty()) fail("its name is empty");
  if (is_standard_output(file)) {
    descriptor_ = ::dup(STDOUT_FILENO);  // appends to what has been printed
    if (descriptor_ < 0) fail_by_errno();
    return;
  }
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status)) fail("it is a folder");
  if (error == std::errc::too_many_symbolic_link_levels) fail(error.message());
  if (fs::exists(status) && !fs::is_regular_file(status)) {  // a device, a pipe
    descriptor_ = ::open(file.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
    if (descriptor_ < 0) fail_by_errno();
    return;
  }
  open_draft();
}

void OutputFile::open_draft() {
  const std::string absolute = fs::absolute(named_).string();
  if (absolute.starts_with("/dev/fd/") || absolute.starts_with("/proc/"))
    fail("name a file, or - for standard output");
  target_ = resolved(named_);
  struct stat status {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (exists && ::access(target_.c_str(), W_OK) != 0) fail_by_errno();
  require_folder();
  try {
    const Draft draft(target_, Draft::Kind::file);
    descriptor_ = draft.descriptor;
    draft_ = draft.path;
  } catch (const std::system_error& error) {
    fail(error.code().message());
  }
  if (exists) static_cast<void>(::fchmod(descriptor_, status.st_mode & 07777U));
}

void OutputFile::require_folder() const {
  std::error_code error;
  fs::path missing;
  for (fs::path folder = (fs::is_symlink(named_, error) ? target_ : named_).parent_path();
       !folder.empty() && !fs::is_directory(folder, error); folder = folder.parent_path())
    missing = folder;
  if (!missing.empty()) fail(fmt::format("there is no folder {}", shown(missing.string())));
}

OutputFile::~OutputFile() {
  if (!draft_.empty()) ::unlink(draft_.c_str());  // while it is locked
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::write(std::string_view text) {
  constexpr std::size_t enough = 1U << 16U;
  buffer_ += text;
  if (buffer_.size() >= enough) flush();
}

void OutputFile::flush() {
  for (std::string_view left = buffer_; !left.empty();) {
    const ssize_t written = ::write(descriptor_, left.data(), left.size());
    if (written < 0 && errno == EINTR && !is_interrupted()) continue;
    if (written < 0) fail_by_errno();
    left.remove_prefix(static_cast<std::size_t>(written));
    if (!left.empty() && is_interrupted()) throw Interrupted();  // nobody reads the rest
  }
  buffer_.clear();
}

void OutputFile::sync() {
  flush();
  if (::fsync(descriptor_) != 0) fail_by_errno();
}

void OutputFile::commit() {
  flush();
  const int copy = ::dup(descriptor_);  // closing it reports late errors; the lock remains
  if (copy >= 0 && ::close(copy) != 0) fail_by_errno();
  if (!draft_.empty() && ::rename(draft_.c_str(), target_.c_str()) != 0) fail_by_errno();
  draft_.clear();
}

void OutputFile::fail(std::string_view reason) const {
  throw std::runtime_error(fmt::format(
      "{}: cannot be written: {}", named_ == "-" ? "standard output" : named_.string(), reason));
}

void OutputFile::fail_by_errno() const {
  if (errno == EINTR && is_interrupted()) throw Interrupted();
  if (errno == EPIPE && is_standard_output(named_)) throw ReaderGone();
  fail(std::strerror(errno));
}

FileTransaction::FileTransaction(const fs::path& source)
    : source_(source.empty() ? "" : identity(source)) {}

OutputFile& FileTransaction::open(const fs::path& file) {
  const std::string file_id = identity(file);
  const bool is_source = file_id == source_, is_open = contains(identities_, file_id);
  if (!file_id.empty() && (is_source || is_open))
    throw std::runtime_error(fmt::format(
        "{}: cannot be written: {}", shown(file.string()),
        is_source ? "the runs are read from this file" : "it is the file of two outputs"));
  identities_.push_back(file_id);
  return *files_.emplace_back(std::make_unique<OutputFile>(file));
}

void FileTransaction::commit() {
  for (const auto& file : files_) file->flush();  // errors occur before any file is replaced
  for (const auto& file : files_) file->commit();
  files_.clear();
}

}  // namespace rotor
