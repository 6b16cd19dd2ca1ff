#include "figures/sweep/sweep_row.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "figures/data/text.hpp"
#include "figures/results/estimated_result.hpp"
#include "figures/results/laws.hpp"
#include "figures/results/version.hpp"

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
    return sure == no_digit ? "" : sure;
  }
  return value.is_string() ? csv_field(value.get<std::string>()) : value.dump();
}

bool has_laws(const std::vector<std::string>& columns) {
  return std::any_of(columns.begin(), columns.end(),
                     [](const std::string& column) { return !contains(result_columns(), column); });
}

std::string cells(Json summary, const Scenario& scenario, const std::vector<std::string>& columns) {
  if (has_laws(columns)) summary.update(laws_or_nulls(scenario));
  const int digits = asked_digits(summary);
  std::string row;
  for (const std::string& key : columns) row += field(summary.at(key), digits) + ',';
  return row;
}

/// Whether a cell can be a result with this JSON schema.
bool is_possible(const std::string& cell, const Json& schema) {
  const Json value = cell.empty() ? Json() : Json(cell);
  if (schema.contains("enum")) return contains(schema["enum"], value);
  const auto is = [&](const char* type) {
    return schema["type"] == type || contains(schema["type"], type);
  };
  if (cell.empty()) return is("null");
  if (is("boolean")) return cell == "true" || cell == "false";
  return number_in(cell) &&
         (is("number") || cell.find_first_not_of("0123456789") == std::string::npos);
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
      sweep.title.empty() ? "Sweep" : "Sweep: " + sweep.title, fmt::format("rotor {}", version()),
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
  const auto digits = point.spec.digits;
  double budget_s = Interruptible::unlimited;
  if (digits) budget_s = usual_budget_s;
  Interruptible monitor(sweep_.budget_s.value_or(budget_s));
  try {
    const Scenario scenario = scenario_of(point.spec, run_ups_);
    const std::vector<std::string>& columns = result_columns(sweep_);
    if (digits) {
      const Comparison found = comparison_to_digits(scenario, *digits, monitor);
      return row + cells(to_json(found, scenario, *digits), scenario, columns) +
             limits(result_of(found, scenario)) + ',' +
             csv_field(complaint(found, *digits, monitor)) + '\n';
    }
    RunUpCheckpoint way = run_ups_.checkpoint_before(scenario, monitor);
    if (!contains(columns, "peak_bearing_force_N"))
      way.summary.ignore_maxima_of(Extreme::bearing_force);
    const RunResult result = finish(std::move(way), scenario, sweep_.stop_on, monitor);
    if (is_interrupted()) throw Interrupted();
    if (result.early.interrupted)
      throw std::runtime_error(fmt::format("a budget of {} s is not enough", monitor.budget_s()));
    return row + cells(to_json(result, &columns), scenario, columns) + limits(result) + ",\n";
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    return row + std::string(result_columns(sweep_).size() + 1, ',') +
           csv_field(one_line(error.what())) + '\n';
  }
}

void SweepRows::check(long n, const CsvRow& row) {
  static const Json schema = summary_schema()["properties"];
  const std::vector<std::string>& columns = result_columns(sweep_);
  const ScenarioSpec spec = points_(n).spec;
  RunResult inputs{};
  inputs.scenario = has_laws(columns) ? scenario_of(spec, run_ups_) : stated_scenario(spec);
  inputs.early.stop_on = sweep_.stop_on;
  std::vector<std::string> known = {"stop_on", "equations", "velocity_jump", "gravity_moment",
                                    "method"};
  if (!spec.digits) known.emplace_back("tolerance");
  Json determined = to_json(inputs, &known);
  if (has_laws(columns)) determined.update(laws_or_nulls(inputs.scenario));
  for (const std::string& column : columns) {
    const std::string& cell = row[column];
    if (!determined.contains(column)) {
      const bool has_no_digit = spec.digits && cell.empty();
      if (!has_no_digit && !is_possible(cell, schema[column]))
        row.fail(fmt::format("{} cannot be \"{}\"", column, shown(cell)));
    } else if (const std::string its = field(determined[column], 0); cell != its) {
      row.fail(fmt::format(R"({} must be "{}", not "{}")", column, its, shown(cell)));
    }
  }
}

}  // namespace rotor
