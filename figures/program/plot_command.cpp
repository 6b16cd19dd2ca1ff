#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <thread>
#include <vector>

#include "figures/data/files.hpp"
#include "figures/data/interruption.hpp"
#include "figures/data/text.hpp"
#include "figures/program/commands.hpp"
#include "figures/program/scene_tables.hpp"
#include "figures/scenes/provenance.hpp"

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

/// As gnuplot reads a text between single quotes, on a line.
std::string quoted(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  for (std::size_t at = 0; (at = text.find('\'', at)) != std::string::npos; at += 2)
    text.insert(at, 1, '\'');
  return '\'' + text + '\'';
}

/// A format by how names of its pictures end, and what the pictures themselves end with.
struct Format {
  std::string_view extension, end;
};
constexpr std::array<Format, 3> formats = {
    {{".svg", "</svg>"}, {".pdf", "%%EOF"}, {".png", "IEND"}}};

/// What gnuplot has drawn. It succeeds also where there was no room for the whole of it.
std::string read_picture(const fs::path& path, std::string_view end) {
  std::ifstream file(path, std::ios::binary);
  std::string picture(std::istreambuf_iterator<char>(file), {});
  const std::size_t after_end = 4;  // a line's end, or a png's check sum
  const std::size_t at = picture.rfind(end);
  if (at == std::string::npos || picture.size() - at > end.size() + after_end)
    throw std::runtime_error("gnuplot has not drawn the whole picture");
  return picture;
}

/// Without the user's own settings.
void run_gnuplot(const std::vector<std::string>& scripts) {
  std::vector<const char*> arguments = {"gnuplot", "--default-settings"};
  for (const std::string& script : scripts) arguments.push_back(script.c_str());
  arguments.push_back(nullptr);
  pid_t child = 0;
  int status = ::posix_spawnp(&child, "gnuplot", nullptr, nullptr,
                              const_cast<char**>(arguments.data()), environ);
  if (status != 0)
    throw std::runtime_error(
        fmt::format("gnuplot, which draws, cannot be started: {}", std::strerror(status)));
  constexpr std::chrono::milliseconds pause(5);
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (is_interrupted()) ::kill(child, SIGKILL);
    std::this_thread::sleep_for(pause);
  }
  if (is_interrupted()) throw Interrupted();
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

  const DraftFolder drafts;
  const std::vector<NamedTable> tables = std::move(compute_tables({{1, scene}}).of.at(1));
  const std::string title = scene.title.empty() ? out.stem().string() : scene.title;
  const fs::path picture = drafts.file("picture");
  std::string settings =
      fmt::format("folder = {}; output = {}; format = '{}'; heading = {}; runs = {}\n",
                  quoted(drafts.file("").string()), quoted(picture.string()),
                  format->extension.substr(1), quoted(title), scene.runs.size());
  FileTransaction data;  // a file a run, so that each is read for its own curves alone
  for (std::size_t n = 1; n <= scene.runs.size(); ++n) {
    const SceneRun& run = scene.runs[n - 1];
    const Parameters& p = run.scenario.parameters;
    data.write(
        drafts.file(fmt::format("run{}.csv", n)),
        to_csv(provenance(scene.title, scene), headings("run", scene.columns), {tables[n - 1]}));
    settings += fmt::format("run{0} = {1}; clearance_mm{0} = {2}\n", n, quoted(run.name),
                            1000 * (p.stator_radius - p.rotor_radius));
  }
  data.write(drafts.file("settings.gp"), settings);
  data.commit();
  run_gnuplot({drafts.file("settings.gp").string(), ROTOR_SCENES "/style.gp",
               ROTOR_SCENES "/../program/plot.gp"});
  FileTransaction files;
  files.write(out, read_picture(picture, format->end));
  files.commit();
  fmt::print("{}\n", out.string());
}

}  // namespace rotor
