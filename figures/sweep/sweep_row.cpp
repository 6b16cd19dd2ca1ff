#include "figures/sweep/sweep_row.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "figures/data/csv.hpp"
#include "figures/results/certified_result.hpp"
#include "figures/results/laws.hpp"
#include "model/certified/comparison.hpp"

namespace rotor {
namespace {

/// The keys of a summary that become columns: its plain values, without those that all rows share.
std::vector<std::string> keys_of(const Json& summary) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : summary.items())
    if (!value.is_structured() && key != "version" && key != "schema") keys.push_back(key);
  return keys;
}

std::string field(const Json& value, int digits) {
  if (value.is_null()) return "";
  if (value.is_object()) {
    const std::string sure = text_of(value, digits);
    return sure == no_sure_digit ? "" : sure;
  }
  return value.is_string() ? csv_field(value.get<std::string>()) : value.dump();
}

std::string cells(Json summary, const Scenario& scenario, const std::vector<std::string>& columns) {
  const auto is_law = [&](const std::string& column) { return !summary.contains(column); };
  if (std::any_of(columns.begin(), columns.end(), is_law)) summary.update(laws_or_nulls(scenario));
  const int digits = asked_digits(summary);
  std::string row;
  for (const std::string& key : columns) row += field(summary.at(key), digits) + ',';
  return row;
}

/// The remarks about exceeded limits, as one field.
std::string limits(const RunResult& result) {
  std::vector<std::string> all;
  for (const Remark& remark : remarks(result))
    if (remark.of == Remark::Of::limit) all.push_back(remark.sentence);
  return csv_field(fmt::format("{}", fmt::join(all, "; ")));
}

}  // namespace

const std::vector<std::string>& result_columns() {
  static const std::vector<std::string> keys = keys_of(to_json(RunResult{}));
  return keys;
}

const std::vector<std::string>& result_columns(const Sweep& sweep) {
  return sweep.columns.empty() ? result_columns() : sweep.columns;
}

const std::vector<std::string>& columns_on_request() {
  static const std::vector<std::string> keys = [] {
    std::vector<std::string> all = result_columns(), more = keys_of(laws(Scenario{}));
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return keys;
}

std::string column_of(const std::string& quantity) {
  return contains(result_columns(), quantity) ? quantity + "_varied" : quantity;
}

std::string sweep_head(const Sweep& sweep) {
  std::vector<std::string> provenance = {
      sweep.title.empty() ? "Sweep" : "Sweep: " + sweep.title, "rotor " ROTOR_VERSION,
      fmt::format("{} points, as this file has them, a row each:", sweep.points())};
  std::istringstream text(sweep.text);
  for (std::string line; std::getline(text, line);) {
    if (line.ends_with('\r')) line.pop_back();
    std::replace(line.begin(), line.end(), '\t', ' ');
    provenance.push_back("  " + line);
  }
  std::vector<std::string> names = sweep.quantities();
  std::transform(names.begin(), names.end(), names.begin(), column_of);
  const std::vector<std::string>& columns = result_columns(sweep);
  names.insert(names.end(), columns.begin(), columns.end());
  names.emplace_back("remarks");
  names.emplace_back("refusal");
  return csv_head(provenance, {names.begin(), names.end()});
}

std::string SweepRows::operator()(long n) {
  const SweepPoint point = points_(n);
  std::string row;
  for (const std::string& value : point.values) row += csv_field(value) + ',';
  Interruptible monitor;
  try {
    const Scenario scenario = scenario_of(point.spec, run_ups_);
    if (const auto digits = point.spec.digits) {
      const auto found =
          run_to_digits(scenario, *digits, [](double /*time_s*/) { return !is_interrupted(); });
      if (!found || is_interrupted()) throw Interrupted();
      return row + cells(to_json(*found, scenario, *digits), scenario, result_columns(sweep_)) +
             limits(result_of(*found, scenario)) + ',' + csv_field(complaint(*found, *digits)) +
             '\n';
    }
    const std::vector<std::string>& columns = result_columns(sweep_);
    RunUpCheckpoint way = run_ups_.checkpoint_before(scenario, monitor);
    if (!contains(columns, "peak_bearing_force_N"))
      way.summary.ignore_maxima_of(Extreme::bearing_force);
    const RunResult result = finish(std::move(way), scenario, sweep_.stop_on, monitor);
    if (result.early.interrupted) throw Interrupted();
    return row + cells(to_json(result, &columns), scenario, columns) + limits(result) + ",\n";
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    return row + std::string(result_columns(sweep_).size() + 1, ',') +
           csv_field(one_line(error.what())) + '\n';
  }
}

}  // namespace rotor
