#include "figures/program/drawing.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>
#include <vector>

#include "figures/data/interruption.hpp"
#include "figures/input/names.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

/// A format: the extension of its files, and how their contents end.
struct Format {
  std::string_view extension, end;
};
constexpr std::array<Format, 3> formats = {
    {{".svg", "</svg>"}, {".pdf", "%%EOF"}, {".png", "IEND"}}};

const Format& format_of(const fs::path& out) {
  const std::string extension = out.extension().string();
  for (const Format& format : formats)
    if (format.extension == extension) return format;
  throw InputError("--out {}: must end in .svg, .pdf or .png", shown(out.string()));
}

/// Runs a program in a folder and returns its status. Throws if it cannot be started.
int status_of(const std::vector<std::string>& command, const fs::path& drafts) {
  std::vector<char*> arguments;
  for (const std::string& argument : command)
    arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addchdir_np(&actions, drafts.c_str());
  pid_t child = 0;
  int status =
      ::posix_spawnp(&child, arguments.front(), &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (status != 0) throw std::system_error(status, std::generic_category());
  constexpr std::chrono::milliseconds pause(5);
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (is_interrupted()) ::kill(child, SIGKILL);
    std::this_thread::sleep_for(pause);
  }
  if (is_interrupted()) throw Interrupted();
  return status;
}

/// What gnuplot has drawn. Its status is 0 even if the disk was full, it does not escape "]]>", and
/// browsers would blend the cells of its maps.
std::string read_picture(const fs::path& path, const Format& format) {
  std::string picture = read_file(path);
  const std::size_t after_end = 4;  // a line's end, or a png's check sum
  const std::size_t at = picture.rfind(format.end);
  if (at == std::string::npos || picture.size() - at > format.end.size() + after_end)
    throw std::runtime_error("gnuplot did not draw the whole picture");
  if (format.extension == ".svg") {
    boost::replace_all(picture, "]]>", "]]&gt;");
    boost::replace_all(picture, "<image ", "<image style='image-rendering:pixelated' ");
  }
  return picture;
}

/// The picture's file, if it can be written: errors are reported before any work.
fs::path checked(const fs::path& out, const std::string& source) {
  static_cast<void>(format_of(out));
  FileTransaction::require_distinct({out}, source);
  FileTransaction().open(out);
  return out;
}

Draft new_folder() {
  std::error_code error;
  const fs::path parent = fs::temp_directory_path(error);
  if (error) throw InputError("TMPDIR: must be an existing folder for gnuplot's files");
  try {
    return {fs::absolute(parent) / "rotor-plot", Draft::Kind::folder};
  } catch (const std::system_error& failure) {
    throw std::runtime_error(
        fmt::format("{}: cannot be written: {}", parent.string(), failure.code().message()));
  }
}

}  // namespace

std::string numbered(std::string_view text) {
  std::string numbers;
  for (const char c : text) numbers += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
  return '"' + numbers + '"';
}

Drawing::Drawing(const std::string& file, const std::string& out)
    : name_(fs::path(file).stem().string()),
      out_(checked(
          out.empty() ? fs::path(file).filename().replace_extension(".svg") : fs::path(out), file)),
      extension_(format_of(out_).extension),
      folder_(new_folder()) {}

Drawing::~Drawing() {
  std::error_code ignored;
  fs::remove_all(folder_.path, ignored);  // while it is locked
  ::close(folder_.descriptor);
}

std::string Drawing::heading(const std::string& title) const {
  return title.empty() ? one_line(name_) : title;
}

void Drawing::write(const std::string& name, std::string_view text) const {
  FileTransaction draft;
  draft.write(file(name), text);
  draft.commit();
}

/// Without the user's settings, and in a locale with all letters.
void Drawing::finish(const std::string& settings, const std::string& script) const {
  write("settings.gp",
        settings + fmt::format("output = 'picture'; format = '{}'\n", extension_.substr(1)));
  ::setenv("LC_ALL", "C.UTF-8", 1);
  const std::string scenes = ROTOR_SCENES;
  int status = 0;
  try {
    status = status_of({"gnuplot", "--default-settings", "settings.gp", scenes + "/style.gp",
                        scenes + "/../program/" + script},
                       folder_.path);
  } catch (const std::system_error& error) {
    throw std::runtime_error(fmt::format("gnuplot cannot be started: {}", error.what()));
  }
  if (!(WIFEXITED(status) && WEXITSTATUS(status) == 0))
    throw std::runtime_error("gnuplot did not draw the picture");
  FileTransaction files;
  files.write(out_, read_picture(file("picture"), format_of(out_)));
  files.commit();
  fmt::print("{}\n", one_line(out_.string()));
}

}  // namespace rotor
