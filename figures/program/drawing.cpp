#include "figures/program/drawing.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <system_error>
#include <thread>

#include "figures/data/files.hpp"
#include "figures/data/interruption.hpp"
#include "figures/data/text.hpp"
#include "figures/input/names.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

/// Runs a program in a folder, silently but for its errors, and returns its status. It is a process
/// group, so that what it has started ends with it. Throws if it cannot be started.
int status_of(const std::vector<std::string>& command, const fs::path& drafts) {
  std::vector<char*> arguments;
  for (const std::string& argument : command)
    arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addchdir_np(&actions, drafts.c_str());
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t group;
  ::posix_spawnattr_init(&group);
  ::posix_spawnattr_setflags(&group, POSIX_SPAWN_SETPGROUP);
  pid_t child = 0;
  int status =
      ::posix_spawnp(&child, arguments.front(), &actions, &group, arguments.data(), environ);
  ::posix_spawnattr_destroy(&group);
  ::posix_spawn_file_actions_destroy(&actions);
  if (status != 0) throw std::system_error(status, std::generic_category());
  constexpr std::chrono::milliseconds pause(5);
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (is_interrupted()) ::kill(-child, SIGKILL);
    std::this_thread::sleep_for(pause);
  }
  if (is_interrupted()) throw Interrupted();
  return status;
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

fs::path figures_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error),
                 installed = program.parent_path().parent_path() / "share/rotor/figures";
  return fs::exists(installed, error) ? installed : fs::path(ROTOR_SCENES).parent_path();
}

void require_picture(const fs::path& out, const std::string& scene) {
  const fs::path extension = out.extension();
  if (extension != ".svg" && extension != ".pdf" && extension != ".png")
    throw InputError("--out {}: must end in .svg, .pdf or .png", shown(out.string()));
  FileTransaction(scene).open(out);
}

void write_drafts(const fs::path& folder, const Drafts& drafts) {
  FileTransaction files;
  for (const auto& [name, text] : drafts) files.write(folder / name, text);
  files.commit();
}

void Items::add(const std::string& item) {
  constexpr std::size_t most = 140;  // letters of a line
  const std::size_t line = text_.size() - (text_.rfind('\n') + 1);
  text_ += (text_.empty() ? "" : line + item.size() > most ? ",\n" : ", ") + item;
}

std::string with_indices(std::string title) {
  constexpr std::string_view typed = "F_n", drawn = "Fₙ";
  for (std::size_t at = 0; (at = title.find(typed, at)) != std::string::npos;)
    title.replace(at, typed.size(), drawn);
  return title;
}

std::string unit_in_words(const Quantity& quantity) {
  return quantity.unit == "m"        ? "mm"
         : quantity.unit == "kg m^2" ? "kg m²"
                                     : std::string(quantity.unit);
}

double unit_of(const Quantity& quantity) { return quantity.unit == "m" ? 1e-3 : 1; }

std::string with_unit(const Quantity& quantity, double value) {
  const std::string unit = unit_in_words(quantity);
  return fmt::format("{} = {:.6g}{}{}", name_in_words(quantity.name), value / unit_of(quantity),
                     unit.empty() ? "" : " ", unit);
}

void print_before_messages() {
  if (std::fflush(stdout) != 0)
    throw std::system_error(errno, std::generic_category(), "standard output cannot be written");
}

void draw(const fs::path& out, const std::string& script, const Drafts& drafts) {
  const Draft folder = new_folder();
  const auto remove = [](const Draft* draft) {
    std::error_code ignored;
    fs::remove_all(draft->path, ignored);  // while it is locked
    ::close(draft->descriptor);
  };
  const std::unique_ptr<const Draft, decltype(remove)> removed_at_the_end(&folder, remove);
  write_drafts(folder.path, drafts);
  const fs::path picture = fs::path("picture").replace_extension(out.extension());
  const std::string figures = figures_folder().string();
  int status = 0;
  try {
    status = status_of(
        {figures + "/draw.sh", picture.string(), "load 'settings.gp'", figures + '/' + script},
        folder.path);
  } catch (const std::system_error& error) {
    throw std::runtime_error(
        fmt::format("{}/draw.sh cannot be started: {}", figures, error.what()));
  }
  constexpr int not_found = 127;  // of a shell
  if (WIFEXITED(status) && WEXITSTATUS(status) == not_found)
    throw std::runtime_error("gnuplot cannot be started");
  if (status != 0) throw std::runtime_error("gnuplot did not draw the picture");
  FileTransaction result;
  result.write(out, read_file(folder.path / picture, fs::file_size(folder.path / picture)));
  result.commit();
  fmt::print("{}\n", one_line(out.string()));
  print_before_messages();
}

}  // namespace rotor
