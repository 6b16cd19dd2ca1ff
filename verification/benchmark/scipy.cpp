#include "verification/benchmark/scipy.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "figures/data/csv.hpp"
#include "figures/data/files.hpp"

namespace rotor {
namespace {

/// What another process needs to run the problems.
std::string to_json(const std::vector<Problem>& problems, const std::vector<Outcome>& exact) {
  nlohmann::json all;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    const Problem& problem = problems[i];
    const Instant first = rounded<double>(problem.start);
    nlohmann::json json{{"name", problem.name},
                        {"from_s", first.time_s},
                        {"until_s", problem.scenario.until},
                        {"state", first.state},
                        {"mass", first.body.mass},
                        {"inertia", first.body.inertia},
                        {"eccentricity", first.body.eccentricity},
                        {"motor_on", first.motor_on},
                        {"rolling", first.contact == ContactState::rolling},
                        {"exact_state", exact[i].state},
                        {"exact_touch_downs", exact[i].touch_downs}};
    for (const Quantity& quantity : quantities())
      json["parameters"][std::string(quantity.name)] = quantity.of(problem.scenario);
    all.push_back(json);
  }
  return all.dump(1);
}

}  // namespace

std::vector<Row> rows_of_scipy(const std::vector<Problem>& problems,
                               const std::vector<Outcome>& exact,
                               const std::filesystem::path& folder, const std::string& python,
                               const std::string& script) {
  const auto input = folder / "problems.json", output = folder / "scipy.csv";
  FileTransaction files;
  files.write(input, to_json(problems, exact));
  files.commit();
  const std::string command =
      fmt::format("'{}' '{}' '{}' '{}'", python, script, input.string(), output.string());
  if (std::system(command.c_str()) != 0) {
    fmt::print("Without SciPy, which make deps-bench installs.\n");
    return {};
  }
  std::vector<Row> rows;
  for (const CsvRow& row : read_csv(output)) {
    const auto number = [&](std::string_view name) {
      return static_cast<double>(row.number(name));
    };
    const auto count = [&](std::string_view name) { return static_cast<long>(row.number(name)); };
    rows.push_back({.problem = row["problem"],
                    .method = row["method"],
                    .setting = row["setting"],
                    .error_state = number("error_state"),
                    .error_event_s = number("error_event_s"),
                    .error_peak = number("error_peak"),
                    .time_s = number("time_s"),
                    .time_median_s = number("time_median_s"),
                    .right_hand_sides = count("right_hand_sides"),
                    .steps = count("steps"),
                    .events = count("events")});
  }
  return rows;
}

}  // namespace rotor
