#include "figures/sweep/sweep_row.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "figures/data/text.hpp"
#include "figures/results/estimated_result.hpp"
#include "figures/results/laws.hpp"
#include "figures/results/section_result.hpp"
#include "figures/results/version.hpp"

namespace rotor {
namespace {

/// The keys of a summary that become columns, without those that all rows share or that are of
/// early stops.
std::vector<std::string> keys_of(const Json& summary) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : summary.items())
    if (!value.is_object() && key != "version" && key != "schema" && !key.starts_with("stop_"))
      keys.push_back(key);
  return keys;
}

std::string field(const Json& summary, const std::string& key) {
  const Json& value = summary.at(key);
  if (value.is_null()) return "";
  if (const auto sure = sure_text(summary, key)) return *sure == no_digit ? "" : *sure;
  if (value.is_array())
    return csv_field(fmt::format("{}", fmt::join(value.get<std::vector<std::string>>(), "; ")));
  return value.is_string() ? csv_field(value.get<std::string>()) : value.dump();
}

std::string cells(Json summary, const Scenario& scenario, const std::vector<std::string>& columns) {
  if (std::any_of(columns.begin(), columns.end(),
                  [&](const std::string& column) { return !summary.contains(column); }))
    summary.update(laws_or_nulls(scenario));
  std::string row;
  for (const std::string& key : columns) row += field(summary, key) + ',';
  return row;
}

std::vector<std::string> joined(std::vector<std::string> names,
                                const std::vector<std::string>& more) {
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

/// The end of the line above the sweep file in a head, and the start of the file's lines.
constexpr std::string_view above_file = ", as this file has them, a row each:", of_file = "  ";

}  // namespace

std::vector<std::string> result_columns(bool with_section) {
  static const std::vector<std::string> keys = keys_of(to_json(RunResult{}));
  return with_section ? joined(keys, section_columns()) : keys;
}

std::vector<std::string> usual_columns(bool with_section) {
  std::vector<std::string> all = {"outcome",
                                  "touch_downs",
                                  "touch_downs_before_loss",
                                  "speed_at_mass_loss_Hz",
                                  "first_contact_s",
                                  "rolling_onset_s",
                                  "rolling_onset_speed_Hz",
                                  "rolling_onset_force_N",
                                  "peak_force_to_rolling_N",
                                  "peak_normal_force_N",
                                  "peak_time_s",
                                  "peak_displacement_m",
                                  "contact_time_s",
                                  "whirl_frequency_Hz",
                                  "final_time_s",
                                  "final_speed_Hz",
                                  "remarks"};
  return with_section ? joined(all, {"repeats_after_turns"}) : all;
}

std::vector<std::string> columns_on_request(bool with_section) {
  return joined(result_columns(with_section), keys_of(laws(Scenario{})));
}

std::optional<std::size_t> place_of(std::string_view column, const Sweep& sweep) {
  const auto found = std::find(sweep.columns.begin(), sweep.columns.end(), column);
  if (found == sweep.columns.end()) return std::nullopt;
  return sweep.quantities().size() + static_cast<std::size_t>(found - sweep.columns.begin());
}

std::string column_of(const std::string& quantity) {
  return contains(result_columns(), quantity) ? quantity + "_varied" : quantity;
}

ResultHeads heads_of(const Sweep& sweep, const Part& part) {
  const long all = sweep.points();
  const std::string points = part.of == 1
                                 ? fmt::format("{} points", all)
                                 : fmt::format("part {} of {}: {} of {} points", part.number,
                                               part.of, part.points(all), all);
  std::vector<std::string> provenance = {
      sweep.title.empty() ? "Sweep" : "Sweep: " + sweep.title, fmt::format("rotor {}", version()),
      fmt::format("equations {}, unless a row states others",
                  name_of(equations_of(SweepPoints(sweep)(0).spec))),
      points + std::string(above_file)};
  std::istringstream text(sweep.text);
  for (std::string line; std::getline(text, line);) {
    if (line.ends_with('\r')) line.pop_back();
    std::replace(line.begin(), line.end(), '\t', ' ');
    provenance.push_back(std::string(of_file) + line);
  }
  std::vector<std::string> varied = sweep.quantities();
  std::transform(varied.begin(), varied.end(), varied.begin(), column_of);
  const auto head = [&](const std::vector<std::string>& names) {
    return csv_head(provenance, {names.begin(), names.end()});
  };
  ResultHeads heads{head(joined(joined(varied, sweep.columns), {"refusal"}))};
  if (!sweep.section_turns) return heads;
  std::vector<std::string> in_section = joined({"point"}, varied);
  for (const Column* column : Section::columns()) in_section.emplace_back(column->name);
  heads.sections = head(in_section);
  return heads;
}

Sweep sweep_of(std::string_view head, const std::string& name) {
  const std::string comment = "# ", version_mark = "# rotor ";
  std::vector<std::string> lines;
  std::istringstream stream{std::string(head)};
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  constexpr std::size_t before_file = 4;
  if (lines.size() <= before_file || !lines[1].starts_with(version_mark) ||
      !lines[before_file - 1].ends_with(above_file))
    throw InputError("{}: is not a file of results that rotor sweep has written", name);
  if (lines[before_file - 1].starts_with(comment + "part "))
    throw InputError("{}: has the results of a part: rotor sweep --join puts all parts together",
                     name);
  if (lines.back().starts_with("point,"))
    throw InputError("{}: has the sections of a sweep, which rotor plot draws from its results",
                     name);
  std::string file;
  for (std::size_t n = before_file; n < lines.size(); ++n)
    if (const std::string start = comment + std::string(of_file); lines[n].starts_with(start))
      file += lines[n].substr(start.size()) + '\n';
  try {
    Sweep sweep = read_sweep("the sweep file in its head", file);
    std::istringstream wanted(heads_of(sweep).results);
    bool is_equal = true;
    std::string line;
    for (const std::string& has : lines)
      is_equal = std::getline(wanted, line) &&
                 (has == line || (&has == &lines[1] && line.starts_with(version_mark))) && is_equal;
    if (!is_equal || std::getline(wanted, line))
      throw InputError("its head is not the one that this version writes");
    return sweep;
  } catch (const InputError& error) {
    throw InputError("{}: {}", name, error.what());
  }
}

std::string SweepRows::operator()(long n) {
  const SweepPoint point = points_(n);
  std::string varied, section;
  for (const std::string& value : point.values) varied += csv_field(value) + ',';
  const std::string start = '\t' + start_of_section_row(n) + varied;
  try {
    const std::string found = results(point, start, section);
    return varied + found + section;
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    return varied + std::string(sweep_.columns.size(), ',') + csv_field(one_line(error.what()));
  }
}

/// Adds to the section its rows, which start so.
std::string SweepRows::results(const SweepPoint& point, const std::string& start,
                               std::string& section) {
  const auto digits = point.spec.digits;
  double budget_s = Interruptible::unlimited;
  if (digits) budget_s = usual_budget_s;
  Interruptible monitor(sweep_.budget_s.value_or(budget_s));
  const std::vector<std::string>& columns = sweep_.columns;
  const Scenario scenario = scenario_of(point.spec, run_ups_);
  if (digits) {
    const Comparison found = comparison_to_digits(scenario, *digits, monitor);
    return cells(to_json(found, scenario, *digits), scenario, columns) +
           csv_field(complaint(found, *digits, monitor));
  }
  std::optional<Section> turns;
  ObserverGroup observers = {&monitor};
  if (sweep_.section_turns)
    observers.add(turns.emplace(scenario, *sweep_.section_turns, [&](std::span<const double> row) {
      section += start + fmt::format("{}", fmt::join(row, ","));
    }));
  const RunResult result =
      turns ? complete_run(RunUpCheckpoint(scenario), scenario, std::nullopt, observers)
            : complete_run_for(columns, run_ups_.checkpoint_before(scenario, monitor), scenario,
                               monitor);
  if (is_interrupted()) throw Interrupted();
  if (result.early.interrupted)
    throw std::runtime_error(fmt::format("a budget of {} s is not enough", monitor.budget_s()));
  Json summary = to_json(result, &columns);
  if (turns) summary.update(to_json(turns->summary()));
  return cells(std::move(summary), scenario, columns);
}

}  // namespace rotor
