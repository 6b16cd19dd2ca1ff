#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "figures/data/files.hpp"
#include "figures/data/interruption.hpp"
#include "figures/data/text.hpp"
#include "figures/program/commands.hpp"
#include "figures/program/scene_tables.hpp"
#include "figures/results/provenance.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for what gnuplot reads and draws, which is gone in the end.
class DraftFolder {
 public:
  DraftFolder() : path_((parent() / "rotor-plot-XXXXXX").string()) {
    if (!::mkdtemp(path_.data()))
      throw std::runtime_error(
          fmt::format("{}: cannot be written: {}", parent().string(), std::strerror(errno)));
  }
  ~DraftFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  DraftFolder(const DraftFolder&) = delete;
  DraftFolder& operator=(const DraftFolder&) = delete;

  const std::string& path() const { return path_; }
  fs::path file(const std::string& name) const { return fs::path(path_) / name; }

 private:
  static fs::path parent() {
    std::error_code error;
    fs::path path = fs::temp_directory_path(error);
    if (error)
      throw InputError("TMPDIR: must be a folder that exists, where gnuplot reads and draws");
    return path;
  }

  std::string path_;
};

/// A text for gnuplot, by the numbers of its bytes: nothing in it can be taken for a command.
std::string numbered(std::string_view text) {
  std::string numbers;
  for (const char c : text) numbers += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
  return '"' + numbers + '"';
}

/// A format by how names of its pictures end, and what the pictures themselves end with.
struct Format {
  std::string_view extension, end;
};
constexpr std::array<Format, 3> formats = {
    {{".svg", "</svg>"}, {".pdf", "%%EOF"}, {".png", "IEND"}}};

/// The letters of a text beyond ASCII, as hexadecimal numbers.
std::set<std::string> letters_beyond_ascii(std::string_view text) {
  std::set<std::string> letters;
  std::uint32_t letter = 0;
  int more = 0;  // bytes of UTF-8
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const int leading = std::countl_one(byte);
    if (leading == 1) {
      letter = letter << 6U | (byte & 0x3fU);
      if (--more == 0) letters.insert(fmt::format("{:x}", letter));
    } else {
      more = leading - 1;
      letter = byte & (0x7fU >> static_cast<unsigned>(leading));
    }
  }
  return letters;
}

/// The status of a program that works among the drafts; its output may go to a file there. Throws
/// where it cannot be started.
int status_of(const std::vector<std::string>& command, const DraftFolder& drafts,
              const char* output = nullptr) {
  std::vector<char*> arguments;
  for (const std::string& argument : command)
    arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addchdir_np(&actions, drafts.path().c_str());
  if (output)
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output,
                                       O_WRONLY | O_CREAT | O_TRUNC, S_IRUSR | S_IWUSR);
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

/// Whether a font has all of the letters, as far as fontconfig tells.
bool has_font_with(const std::string& letters, const DraftFolder& drafts) {
  try {
    return status_of({"fc-list", ":charset=" + letters}, drafts, "fonts") != 0 ||
           fs::file_size(drafts.file("fonts")) > 0;
  } catch (const std::system_error&) {  // it is not there
    return true;
  }
}

/// A letter that no font has would be drawn as high as the picture. An svg is drawn where it is
/// looked at.
void require_letters(const Format& format, const std::string& text, const DraftFolder& drafts) {
  const std::set<std::string> letters = letters_beyond_ascii(text);
  if (format.extension == ".svg" || letters.empty() ||
      has_font_with(fmt::format("{}", fmt::join(letters, " ")), drafts))
    return;
  for (const std::string& letter : letters)
    if (!has_font_with(letter, drafts))
      throw InputError(
          fmt::format("\"{}\": no font here has its letter U+{:0>4}, which png and pdf need; "
                      "--out NAME.svg needs none",
                      shown(text), letter));
}

/// What gnuplot has drawn. It succeeds also where there was no room for the whole of it, and leaves
/// in texts what XML has for an end.
std::string read_picture(const fs::path& path, const Format& format) {
  std::ifstream file(path, std::ios::binary);
  std::string picture(std::istreambuf_iterator<char>(file), {});
  const std::size_t after_end = 4;  // a line's end, or a png's check sum
  const std::size_t at = picture.rfind(format.end);
  if (at == std::string::npos || picture.size() - at > format.end.size() + after_end)
    throw std::runtime_error("gnuplot has not drawn the whole picture");
  if (format.extension == ".svg")
    for (std::size_t in = 0; (in = picture.find("]]>", in)) != std::string::npos;)
      picture.replace(in, 3, "]]&gt;");
  return picture;
}

/// Without the user's own settings, and in a locale whose letters gnuplot can write.
void run_gnuplot(const DraftFolder& drafts) {
  ::setenv("LC_ALL", "C.UTF-8", 1);
  const char* const style = ROTOR_SCENES "/style.gp";
  const char* const script = ROTOR_SCENES "/../program/plot.gp";
  int status = 0;
  try {
    status = status_of({"gnuplot", "--default-settings", "settings.gp", style, script}, drafts);
  } catch (const std::system_error& error) {
    throw std::runtime_error(
        fmt::format("gnuplot, which draws, cannot be started: {}", error.what()));
  }
  if (!(WIFEXITED(status) && WEXITSTATUS(status) == 0))
    throw std::runtime_error("gnuplot has not drawn the picture");
}

}  // namespace

void plot_scene(const PlotOptions& options) {
  Scene scene = read_scene(options.scene, {options.equations_and_method, {}});
  scene.columns =
      parse_columns({"time_s", "normal_force_N", "speed_Hz", "rho_m", "x_a_m", "y_a_m"});
  const fs::path out = options.out.empty()
                           ? fs::path(options.scene).filename().replace_extension(".svg")
                           : fs::path(options.out);
  const auto* const format = std::find_if(formats.begin(), formats.end(), [&](const Format& known) {
    return known.extension == out.extension().string();
  });
  if (format == formats.end())
    throw InputError(fmt::format("--out {}: must end in .svg, .pdf or .png", shown(out.string())));

  const fs::path folder = out.has_parent_path() ? out.parent_path() : fs::path(".");
  if (!fs::is_directory(folder))
    throw InputError(
        fmt::format("{}: cannot be written: there is no such folder", folder.string()));
  FileTransaction::require_distinct({out}, options.scene);

  const std::string title = scene.title.empty() ? one_line(out.stem().string()) : scene.title;
  const DraftFolder drafts;
  require_letters(*format, title, drafts);
  for (const SceneRun& run : scene.runs) require_letters(*format, run.name, drafts);

  const std::vector<NamedTable> tables = std::move(compute_tables({{1, scene}}).of.at(1));
  std::string settings =
      fmt::format("output = 'picture'; format = '{}'; heading = {}; runs = {}\n",
                  format->extension.substr(1), numbered(title), scene.runs.size());
  FileTransaction data;  // a file a run, so that each is read for its own curves alone
  for (std::size_t n = 1; n <= scene.runs.size(); ++n) {
    const SceneRun& run = scene.runs[n - 1];
    const Parameters& p = run.scenario.parameters;
    data.write(
        drafts.file(fmt::format("run{}.csv", n)),
        to_csv(provenance(scene.title, scene), headings("run", scene.columns), {tables[n - 1]}));
    settings += fmt::format("run{0} = {1}; clearance_mm{0} = {2}\n", n, numbered(run.name),
                            1000 * (p.stator_radius - p.rotor_radius));
  }
  data.write(drafts.file("settings.gp"), settings);
  data.commit();
  run_gnuplot(drafts);
  FileTransaction files;
  files.write(out, read_picture(drafts.file("picture"), *format));
  files.commit();
  fmt::print("{}\n", one_line(out.string()));
}

}  // namespace rotor
