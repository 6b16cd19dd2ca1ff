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

std::string field(const Json& summary, const std::string& key) {
  const Json& value = summary.at(key);
  if (value.is_null()) return "";
  if (const auto sure = sure_text(summary, key)) return *sure == no_digit ? "" : *sure;
  return value.is_string() ? csv_field(value.get<std::string>()) : value.dump();
}

bool has_laws(const std::vector<std::string>& columns) {
  return std::any_of(columns.begin(), columns.end(),
                     [](const std::string& column) { return !contains(result_columns(), column); });
}

std::string cells(Json summary, const Scenario& scenario, const std::vector<std::string>& columns) {
  if (has_laws(columns)) summary.update(laws_or_nulls(scenario));
  std::string row;
  for (const std::string& key : columns) row += field(summary, key) + ',';
  return row;
}

/// The remarks about exceeded limits and a missed mass loss, as one field.
std::string remarks_of(const RunResult& result) {
  std::vector<std::string> all;
  for (const Remark& remark : remarks(result))
    if (remark.of == Remark::Of::limit || remark.of == Remark::Of::missed_loss)
      all.push_back(remark.sentence);
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
      fmt::format("equations {}, unless a row states others",
                  name_of(equations_of(SweepPoints(sweep)(0).spec))),
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
             remarks_of(result_of(found, scenario)) + ',' +
             csv_field(complaint(found, *digits, monitor)) + '\n';
    }
    RunUpCheckpoint run_so_far = run_ups_.checkpoint_before(scenario, monitor);
    if (!contains(columns, "peak_bearing_force_N"))
      run_so_far.summary.ignore_maxima_of(Extreme::bearing_force);
    const RunResult result = finish(std::move(run_so_far), scenario, sweep_.stop_on, monitor);
    if (is_interrupted()) throw Interrupted();
    if (result.early.interrupted)
      throw std::runtime_error(fmt::format("a budget of {} s is not enough", monitor.budget_s()));
    return row + cells(to_json(result, &columns), scenario, columns) + remarks_of(result) + ",\n";
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    return row + std::string(result_columns(sweep_).size() + 1, ',') +
           csv_field(one_line(error.what())) + '\n';
  }
}

bool SweepRows::is_row_of(long n, std::string_view row) const {
  const std::string begin = fmt::format("{},", fmt::join(points_(n).values, ","));
  return row.starts_with(begin) && row.find('\0') == std::string_view::npos;  // as power cuts leave
}

}  // namespace rotor
