#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "figures/input/toml_file.hpp"
#include "figures/program/commands.hpp"
#include "figures/results/provenance.hpp"
#include "model/mechanics/contact.hpp"

namespace rotor {
namespace {

/// Force, speed, displacement and orbit.
void plot_motion(const Scene& scene, const PlotOptions& options) {
  const Drawing drawing(options.file, options.out);
  const std::vector<NamedTable> tables = std::move(compute_tables({{1, scene}}).of.at(1));
  std::string settings = fmt::format("heading = {}; runs = {}\n",
                                     numbered(drawing.heading(scene.title)), scene.runs.size());
  for (std::size_t n = 1; n <= scene.runs.size(); ++n) {
    const SceneRun& run = scene.runs[n - 1];
    const Parameters& p = run.scenario.parameters;
    drawing.write(  // one file per run, so that each is read only for its own curves
        fmt::format("run{}.csv", n),
        csv_head(scene.title, scene, "run") + csv_rows({tables[n - 1]}));
    settings += fmt::format("run{0} = {1}; clearance_mm{0} = {2}\n", n, numbered(run.name),
                            1000 * Ring<double>(p).clearance);
  }
  drawing.finish(settings, "plot.gp");
}

bool is_sweep(const std::filesystem::path& file) {
  if (file.extension() == ".csv") return true;
  const TomlFile toml(file);
  return toml.root().contains("axis") || toml.root().contains("sample");
}

}  // namespace

void plot(const PlotOptions& stated) {
  PlotOptions options = stated;
  if (options.out.empty())  // another one for each kind of picture
    options.out = fmt::format("{}{}{}{}.svg", std::filesystem::path(options.file).stem().string(),
                              options.spectrum ? "-spectrum" : "",
                              options.column.empty() ? "" : "-", options.column);
  if (is_sweep(options.file)) return plot_sweep(options);
  if (!options.column.empty()) throw InputError("--column: needs a sweep; this is a scene");
  Scene scene = read_scene(options.file, {options.equations_and_method, {}});
  scene.columns =
      parse_columns({"time_s", "normal_force_N", "speed_Hz", "rho_m", "x_a_m", "y_a_m"});
  scene.window = stated_window(scene.window, options.from_s, options.until_s, scene.runs);
  options.spectrum ? plot_spectrum(scene, options) : plot_motion(scene, options);
  say_what_is_assumed(scene.runs);
}

}  // namespace rotor
