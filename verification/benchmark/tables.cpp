#include "verification/benchmark/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rotor {
namespace {

/// The run time at which a curve reaches an error, interpolated logarithmically; NaN if it never
/// does.
double time_at(const std::vector<Row>& rows, const std::string& problem, const std::string& method,
               double error) {
  const Row* above = nullptr;
  for (const Row& row : rows) {
    if (row.problem != problem || row.method != method || std::isnan(row.error_state)) continue;
    if (row.error_state > error) {
      above = &row;
    } else if (above) {
      const double part =
          std::log(above->error_state / error) / std::log(above->error_state / row.error_state);
      return above->time_s * std::pow(row.time_s / above->time_s, part);
    } else {
      return row.time_s;  // even its coarsest setting is better
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::string power_of_ten(int minus_exponent) { return fmt::format("1e-{}", minus_exponent); }

void print_ratios(const std::vector<Row>& rows) {
  constexpr int first = 1, last = 10;
  fmt::print("\nTime at equal error of the state, relative to the event method's\n");
  std::vector<std::pair<std::string, std::string>> curves;
  for (const Row& row : rows)
    if (row.method != ours && row.method != "reference" &&
        std::ranges::find(curves, std::pair{row.problem, row.method}) == curves.end())
      curves.emplace_back(row.problem, row.method);
  fmt::print("{:<14} {:<31}", "problem", "method");
  for (int digits = first; digits <= last; ++digits) fmt::print(" {:>7}", power_of_ten(digits));
  fmt::print("\n");
  for (const auto& [problem, method] : curves) {
    fmt::print("{:<14} {:<31}", problem, method);
    for (int digits = first; digits <= last; ++digits) {
      const double error = std::pow(10, -digits);
      const double ratio =
          time_at(rows, problem, method, error) / time_at(rows, problem, ours, error);
      fmt::print(" {:>7}", std::isnan(ratio) ? "-" : fmt::format("{:.1f}", ratio));
    }
    fmt::print("\n");
  }
  fmt::print("- : the method does not reach that error with any of its settings.\n");
}

std::string to_csv(const std::vector<Row>& rows) {
  std::string text =
      "# Run time against error, from make bench\n"
      "problem,method,setting,error_state,error_event_s,error_peak,time_s,"
      "right_hand_sides,steps,events\n";
  for (const Row& r : rows)
    text += fmt::format("{},{},{},{:.3e},{:.3e},{:.3e},{:.4e},{},{},{}\n", r.problem, r.method,
                        r.setting, r.error_state, r.error_event_s, r.error_peak, r.time_s,
                        r.right_hand_sides, r.steps, r.events);
  return text;
}

}  // namespace rotor
