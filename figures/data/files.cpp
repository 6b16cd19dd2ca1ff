#include "figures/data/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace rotor {
namespace {

std::filesystem::path draft_of(std::filesystem::path file) { return file += ".part"; }

[[noreturn]] void fail(const std::filesystem::path& file, std::string_view reason) {
  throw std::runtime_error(fmt::format("{}: cannot be written: {}", file.string(), reason));
}

}  // namespace

FileTransaction::~FileTransaction() {
  std::error_code ignored;
  for (const auto& file : files_) std::filesystem::remove(draft_of(file), ignored);
  for (const auto& folder : folders_) std::filesystem::remove(folder, ignored);  // if empty
}

void FileTransaction::write(const std::filesystem::path& file, std::string_view content) {
  std::error_code error;
  for (auto folder = file.parent_path(); !folder.empty() && !std::filesystem::exists(folder);
       folder = folder.parent_path())
    folders_.push_back(folder);
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
  if (error) fail(file, error.message());
  if (std::filesystem::is_directory(file)) fail(file, "it is a directory");
  if (std::ranges::find(files_, file) != files_.end()) fail(file, "it is asked for twice");
  files_.push_back(file);
  std::ofstream stream(draft_of(file), std::ios::binary);
  stream << content << std::flush;
  if (!stream) fail(file, std::strerror(errno));
}

void FileTransaction::commit() {
  for (const auto& file : files_) {
    std::error_code error;
    std::filesystem::rename(draft_of(file), file, error);
    if (error) fail(file, error.message());
  }
  files_.clear();
  folders_.clear();
}

}  // namespace rotor
