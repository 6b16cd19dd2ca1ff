#include "figures/data/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "figures/data/interruption.hpp"
#include "figures/data/text.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

/// Where a link leads, by one step.
fs::path followed(const fs::path& link) {
  std::error_code error;
  const fs::path to = fs::read_symlink(link, error);
  return to.is_absolute() ? to : link.parent_path() / to;
}
constexpr int most_links = 40;

/// A file, or link, in the folder that it is in, however that is called.
fs::path place(const fs::path& file) {
  std::error_code error;
  const fs::path absolute = fs::absolute(file, error);  // behind a link, .. is not its parent
  return fs::weakly_canonical(absolute.parent_path(), error) / absolute.filename();
}

/// What a path leads to, through links, whether it exists or not.
fs::path resolved(fs::path file) {
  std::error_code error;
  for (int links = 0; links < most_links && fs::is_symlink(file, error); ++links)
    file = followed(file);
  return place(file);
}

/// The open descriptor that a path stands for, such as /dev/stdout or /dev/fd/3, if it does.
std::optional<int> descriptor_behind(fs::path file) {
  const std::string descriptors = fmt::format("/proc/{}/fd/", ::getpid());
  std::error_code error;
  for (int links = 0; links < most_links; ++links) {
    const std::string name = place(file).string();
    if (name.starts_with(descriptors)) {
      int number = -1;
      std::from_chars(name.data() + descriptors.size(), name.data() + name.size(), number);
      return number;
    }
    if (!fs::is_symlink(file, error)) break;
    file = followed(file);
  }
  return std::nullopt;
}

/// Whether a file is written in its place: no regular file, or one that stands for a descriptor.
bool is_written_in_place(const fs::path& file) {
  struct stat status {};
  const std::string name = place(file).string();
  const bool is_of_devices = name.starts_with("/dev/") && !name.starts_with("/dev/shm/");
  if (is_of_devices || name.starts_with("/proc/") || descriptor_behind(file)) return true;
  return ::stat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

/// What tells files apart however they are called; empty for a device, which any number may share.
std::string identity(const fs::path& file) {
  struct stat status {};
  const bool is_output = is_standard_output(file);
  const bool exists =
      is_output ? ::fstat(STDOUT_FILENO, &status) == 0 : ::stat(file.c_str(), &status) == 0;
  if (!exists) return resolved(file).string();
  if (S_ISCHR(status.st_mode) && !is_output) return "";
  return fmt::format("{}:{}", status.st_dev, status.st_ino);
}

/// So that a name in it survives a power cut; some file systems need and know no such thing.
void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  static_cast<void>(::fsync(descriptor));
  ::close(descriptor);
}

}  // namespace

bool is_standard_output(const fs::path& file) {
  if (file == "-" || descriptor_behind(file) == STDOUT_FILENO) return true;
  struct stat its {
  }, of_output{};
  const bool is_same = ::stat(file.c_str(), &its) == 0 && ::fstat(STDOUT_FILENO, &of_output) == 0 &&
                       its.st_dev == of_output.st_dev && its.st_ino == of_output.st_ino;
  return is_same && (!S_ISCHR(its.st_mode) || ::isatty(STDOUT_FILENO) == 1);
}

OutputFile::OutputFile(const fs::path& file) : named_(file), target_(file) {
  if (file.empty()) fail("its name is empty");
  if (file == "-") {
    descriptor_ = ::dup(STDOUT_FILENO);
    if (descriptor_ < 0) fail_by_errno();
    return;
  }
  std::error_code error;
  if (fs::is_directory(file, error)) fail("it is a folder");
  if (error == std::errc::too_many_symbolic_link_levels) fail(error.message());
  is_written_in_place(file) ? open_in_place() : open_draft();
}

/// What stands for a descriptor is written to as that is: behind what it has got already.
void OutputFile::open_in_place() {
  if (const auto open = descriptor_behind(target_)) {
    const int flags = ::fcntl(*open, F_GETFL);
    if (flags < 0) fail_by_errno();
    if ((flags & O_ACCMODE) == O_RDONLY) fail("it is open for reading alone");
    descriptor_ = ::fcntl(*open, F_DUPFD_CLOEXEC, 0);
  } else {
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  }
  if (descriptor_ < 0) fail_by_errno();
}

void OutputFile::open_draft() {
  target_ = resolved(named_);
  struct stat status {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (exists && status.st_nlink > 1)
    fail("it has several hard links, which replacing it would cut; remove it, or write elsewhere");
  if (exists && ::access(target_.c_str(), W_OK) != 0) fail_by_errno();
  require_folder();
  remove_stale_drafts();
  const mode_t mode = exists ? status.st_mode & 07777U : 0666U;
  for (int attempt = 0; descriptor_ < 0; ++attempt) {
    draft_ = target_.parent_path() /
             fmt::format(".{}.{}-{}.part", target_.filename().string(), ::getpid(), attempt);
    descriptor_ = ::open(draft_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (descriptor_ < 0 && errno != EEXIST) {
      draft_.clear();
      fail_by_errno();
    }
  }
  if (exists && (::fchown(descriptor_, status.st_uid, status.st_gid) != 0 ||
                 ::fchmod(descriptor_, mode) != 0)) {
    const int reason = errno;
    ::close(descriptor_);
    ::unlink(draft_.c_str());
    fail(fmt::format("its owner and mode cannot be kept: {}", std::strerror(reason)));
  }
}

/// What a process has left that was killed: its name tells which one.
void OutputFile::remove_stale_drafts() const {
  const std::string start = fmt::format(".{}.", target_.filename().string());
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(target_.parent_path(), ignored)) {
    const std::string name = entry.path().filename();
    if (!name.starts_with(start) || !name.ends_with(".part")) continue;
    pid_t process = 0;
    const char* const end = name.data() + name.size();
    const auto number = std::from_chars(name.data() + start.size(), end, process);
    const bool is_ours = number.ec == std::errc() && number.ptr != end && *number.ptr == '-';
    if (is_ours && process > 0 && ::kill(process, 0) != 0 && errno == ESRCH)
      fs::remove(entry, ignored);
  }
}

void OutputFile::require_folder() const {
  std::error_code error;
  fs::path missing;
  for (fs::path folder = (fs::is_symlink(named_, error) ? target_ : named_).parent_path();
       !folder.empty() && !fs::exists(folder, error); folder = folder.parent_path())
    missing = folder;
  if (!missing.empty()) fail(fmt::format("there is no folder {}", shown(missing.string())));
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  std::error_code ignored;
  if (!draft_.empty()) fs::remove(draft_, ignored);
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
    if (!left.empty() && is_interrupted()) throw Interrupted();  // nobody takes the rest
  }
  buffer_.clear();
}

void OutputFile::sync() {
  flush();
  if (::fsync(descriptor_) != 0) fail_by_errno();
  is_synced_ = true;
}

void OutputFile::commit() {
  flush();
  if (::close(std::exchange(descriptor_, -1)) != 0) fail_by_errno();
  if (!draft_.empty() && ::rename(draft_.c_str(), target_.c_str()) != 0) fail_by_errno();
  if (is_synced_) sync_folder(target_.parent_path());
  draft_.clear();
}

void OutputFile::fail(std::string_view reason) const {
  throw std::runtime_error(fmt::format(
      "{}: cannot be written: {}", named_ == "-" ? "standard output" : named_.string(), reason));
}

void OutputFile::fail_by_errno() const {
  if (errno == EINTR && is_interrupted()) throw Interrupted();
  fail(std::strerror(errno));
}

void FileTransaction::require_distinct(const std::vector<fs::path>& files, const fs::path& source) {
  std::vector<std::string> identities;
  const std::string of_source = source.empty() ? "" : identity(source);
  for (const fs::path& file : files) {
    const std::string its = identity(file);
    if (!its.empty() && its == of_source)
      throw std::runtime_error(fmt::format(
          "{}: cannot be written: it is what the runs are read from", shown(file.string())));
    if (!its.empty() && std::find(identities.begin(), identities.end(), its) != identities.end())
      throw std::runtime_error(
          fmt::format("{}: cannot be written: it is asked for twice", shown(file.string())));
    identities.push_back(its);
  }
}

OutputFile& FileTransaction::open(const fs::path& file) {
  return *files_.emplace_back(std::make_unique<OutputFile>(file));
}

void FileTransaction::write_to_all(std::string_view text) {
  for (const auto& file : files_) file->write(text);
}

void FileTransaction::commit() {
  for (const auto& file : files_) file->flush();  // what fails does so before any takes its place
  for (const auto& file : files_) file->commit();
  files_.clear();
}

}  // namespace rotor
