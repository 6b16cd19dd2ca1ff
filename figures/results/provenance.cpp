#include "figures/results/provenance.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "figures/data/csv.hpp"
#include "figures/results/laws.hpp"
#include "figures/results/run_result.hpp"
#include "figures/results/version.hpp"

namespace rotor {
namespace {

std::string describe(const Equations& equations) {
  if (equations == Equations::published || equations == Equations::corrected)
    return std::string(name_of(equations));
  return fmt::format("{} (velocity jump {}, gravity moment {})", name_of(equations),
                     name_of(equations.velocity_jump), name_of(equations.gravity_moment));
}

std::string parameters(const Scenario& scenario) {
  std::vector<std::string> all;
  const Json inputs = inputs_of(scenario);
  for (const auto& [key, value] : inputs.items())
    if (value.is_number()) {
      const std::string_view unit = find_input_quantity(key)->quantity.unit;
      all.push_back(
          fmt::format("{} = {}{}{}", key, value.get<double>(), unit.empty() ? "" : " ", unit));
    }
  if (scenario.parameters.drive != Drive::motor)
    all.push_back(fmt::format("drive {}", name_of(scenario.parameters.drive)));
  if (!scenario.parameters.loses_mass) all.emplace_back("no mass loss");
  return fmt::format("{}", fmt::join(all, ", "));
}

/// The closed forms that have a value.
std::string closed_forms_of(const Scenario& scenario) {
  std::vector<std::string> all;
  const Json known = laws_or_nulls(scenario);
  for (const auto& [key, value] : known.items())
    if (value.is_number()) all.push_back(fmt::format("{} = {}", key, value.dump()));
  return fmt::format("{}", fmt::join(all, ", "));
}

}  // namespace

std::string csv_head(const std::string& title, const Scene& scene, std::string_view names) {
  std::vector<std::string> lines = {title, fmt::format("rotor {}", version())};
  for (const SceneRun& run : scene.runs)
    lines.push_back(fmt::format("{}: equations {}, method {}, {}", run.name,
                                describe(run.scenario.equations), name_of(run.scenario.method),
                                parameters(run.scenario)));
  for (const SceneRun& run : scene.runs)
    if (const std::string said = closed_forms_of(run.scenario); !said.empty())
      lines.push_back(fmt::format("{}: by closed forms, {}", run.name, said));
  std::vector<std::string_view> headings = {names};
  for (const Column* column : scene.columns) {
    lines.push_back(fmt::format("{}: {}", column->name, column->meaning));
    headings.push_back(column->name);
  }
  return csv_head(lines, headings);
}

std::string gnuplot_text(std::string_view text) {
  std::string numbers;
  for (const char c : text) numbers += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
  return '"' + numbers + '"';
}

std::string variables(const Scene& scene, const std::vector<Summary>& results) {
  std::vector<std::string> known = {"equations", "method", "drive", "inputs"};
  for (const auto& field : summary_fields<double>) known.emplace_back(field.key);
  std::string text = fmt::format("known_runs = {}\n", scene.runs.size());
  for (std::size_t n = 0; n < scene.runs.size(); ++n) {
    RunResult result;
    result.scenario = scene.runs[n].scenario;
    result.summary = results[n];
    Json all = {{"run", scene.runs[n].name}};
    all.update(to_json(result, &known));
    all.update(Json(all["inputs"]));
    all.update(laws_or_nulls(result.scenario));
    for (const auto& [key, value] : all.items())
      if (!value.is_structured())
        text += fmt::format("{}{} = {}\n", key, n + 1,
                            value.is_null()      ? "NaN"
                            : value.is_string()  ? gnuplot_text(value.get<std::string>())
                            : value.is_boolean() ? std::to_string(int{value.get<bool>()})
                                                 : fmt::format("{:#}", value.get<double>()));
  }
  return text;
}

}  // namespace rotor
