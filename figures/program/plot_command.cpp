#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "figures/data/files.hpp"
#include "figures/program/commands.hpp"
#include "figures/results/provenance.hpp"
#include "figures/results/run_result.hpp"
#include "figures/results/scene_data.hpp"

namespace rotor {
namespace {

/// What the runs of a scene share, as far as it is drawn: their equations and the stated numbers,
/// in lines that end between them.
std::string conditions_of(const Scene& scene) {
  const std::vector<SceneRun>& runs = scene.runs;
  const auto all_have = [&](const auto& has) { return std::ranges::all_of(runs, has); };
  const Equations equations = runs.front().scenario.equations;
  Items items;
  if (all_have([&](const SceneRun& run) { return run.scenario.equations == equations; }))
    items.add(std::string(equations_in_words(name_of(equations))));
  if (all_have([](const SceneRun& run) {
        return run.scenario.parameters.drive == Drive::constant_speed;
      }))
    items.add("held speed");
  for (const auto& [quantity, instead_of, of_start] : input_quantities()) {
    const auto stated = [&name = quantity.name](const SceneRun& run) -> std::optional<double> {
      const auto found = run.stated.numbers.find(name);
      return found == run.stated.numbers.end() ? std::nullopt : std::optional(found->second);
    };
    std::optional<double> shared = stated(runs.front());
    if (!shared || !all_have([&](const SceneRun& run) { return stated(run) == shared; })) continue;
    items.add(with_unit(quantity, *shared));
  }
  const double drawn_until_s = scene.window.from_s + scene.window.length_s;
  if (!scene.window.from_rolling_onset &&
      all_have([&](const SceneRun& run) { return drawn_until_s < run.scenario.until; }))
    items.add(fmt::format("drawn until {:.6g} s, results of the whole run", drawn_until_s));
  return items.text();
}

/// A panel draws its last column over time or, an orbit, over the one before.
struct Panel {
  std::string_view column;
  std::vector<std::size_t> columns;  ///< of the scene
};

/// The rows that a panel needs: it is at most half as high as the largest picture.
std::string rows_of(const std::vector<std::size_t>& columns, const Scene& scene,
                    const NamedTable& all) {
  constexpr double pixel = 1 / 560.;
  Table some(columns.size());
  std::vector<std::string_view> headings = {"run"};
  for (const std::size_t column : columns) headings.push_back(scene.columns[column]->name);
  for (std::size_t row = 0; row < all.table.rows(); ++row)
    for (const std::size_t column : columns) some.add(all.table.row(row)[column]);
  return csv_head(std::vector<std::string>(), headings) +
         csv_rows({{all.name, thinned(some, pixel)}});
}

}  // namespace

void plot(const PlotOptions& options) {
  if (std::filesystem::path(options.file).extension() == ".csv") return plot_sweep(options);
  if (!options.columns.empty() || !options.drafts.empty())
    throw InputError("--{}: is for the results of a sweep, NAME.csv",
                     options.columns.empty() ? "drafts" : "columns");
  const std::string out = options.out.empty() ? name_made_from(options.file, ".svg") : options.out;
  Scene scene = read_scene(options.file, {.of_parameters = {}, .of_runs = options.stated});
  scene.columns =
      parse_columns({"time_s", "normal_force_N", "speed_Hz", "rho_m", "x_a_m", "y_a_m"});
  scene.window = stated_window(scene.window, options.from_s, options.until_s, scene.runs);
  require_picture(out, options.file);
  const SceneData data = std::move(compute_data({{1, scene}}).at(1));
  const bool in_rpm =
      std::ranges::any_of(scene.runs, [](const SceneRun& run) { return run.stated.states_rpm(); });
  Drafts drafts = {
      {"settings.gp",
       fmt::format("heading = {}; conditions = {}; per_Hz = {}; speed_unit = '{}'\n",
                   gnuplot_text(with_indices(scene.title)), gnuplot_text(conditions_of(scene)),
                   in_rpm ? 60 : 1, in_rpm ? "rpm" : "Hz") +
           variables(scene, data.results)}};
  const std::vector<Panel> panels = {
      {"normal_force_N", {0, 1}}, {"speed_Hz", {0, 2}}, {"rho_m", {0, 3}}, {"x_a_m", {0, 4, 5}}};
  for (std::size_t n = 1; n <= scene.runs.size(); ++n)
    for (const Panel& panel : panels)
      drafts.emplace_back(fmt::format("run{}-{}.csv", n, panel.column),
                          rows_of(panel.columns, scene, data.curves[n - 1]));
  draw(out, "program/plot.gp", drafts);
  for (std::size_t n = 0; n < scene.runs.size(); ++n) {
    const SceneRun& run = scene.runs[n];
    RunResult result;
    result.scenario = run.scenario;
    result.summary = data.results[n];
    for (const Remark& remark : remarks(result))
      print_message(fmt::format("rotor: {}{}", scene.runs.size() > 1 ? run.name + ": " : "",
                                as_stated(remark.message, run.stated).text()));
  }
  say_what_is_assumed(scene);
}

}  // namespace rotor
