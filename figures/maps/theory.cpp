/// Closed forms for a map: `map-theory MAP.toml` writes a row for each point of a sweep file, in
/// its order, with a blank line before each scan of the last axis, as gnuplot needs.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <limits>
#include <stdexcept>

#include "figures/data/csv.hpp"
#include "figures/runs/run_ups.hpp"
#include "figures/sweep/sweep.hpp"
#include "model/theory/accident.hpp"

namespace rotor {
namespace {

constexpr std::array names = {"clearance_m",
                              "mu",
                              "greatest_m",
                              "bound_m",
                              "steady_m",
                              "rolling_friction",
                              "synchronous_friction",
                              "whip_friction",
                              "rebound_friction",
                              "peak_force_N"};

std::array<double, names.size()> closed_forms(const Scenario& scenario) {
  const Parameters& p = scenario.parameters;
  const double speed = two_pi * scenario.start_speed_Hz;
  if (!(speed > 0)) throw std::domain_error("a map needs a start speed, at which the mass is lost");
  const MassLossResponse response(p, scenario.equations, speed);
  const Whirl whirl(p);
  const Accident law(p, scenario.equations, speed);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {Ring<double>(p).clearance,
          p.friction,
          response.greatest(),
          response.bound(),
          response.steady(),
          whirl.rolling_friction(speed),
          law.forward_friction,
          whirl.whip_friction(),
          law.whirl_friction.value_or(none),
          law.peak_force().value_or(none)};
}

/// Empty cells where the rotor would touch the ring before the loss.
std::string cells(const ScenarioSpec& spec) {
  std::array<double, names.size()> values;
  values.fill(std::numeric_limits<double>::quiet_NaN());
  try {
    values = closed_forms(scenario_of(spec));
  } catch (const std::exception&) {  // the sweep reports it in its own row
  }
  std::string row;
  for (const double value : values) row += ',' + csv_field(value);
  return row + '\n';
}

void print(const char* file) {
  const Sweep sweep = read_sweep(file);
  if (sweep.axes.empty() || !sweep.sample.over.empty())
    throw std::runtime_error(
        fmt::format("{}: a map needs an [[axis]], and excludes a [sample]", file));
  const SweepPoints points(sweep);
  std::vector<std::string> columns = sweep.quantities();
  columns.insert(columns.end(), names.begin(), names.end());
  fmt::print("{}", csv_head({"Closed forms of model/theory for " + sweep.title},
                            {columns.begin(), columns.end()}));
  const long scan = sweep.axes.back().points();
  for (long n = 0; n < sweep.points(); ++n) {
    const SweepPoint point = points(n);
    if (n % scan == 0) fmt::print("\n");
    fmt::print("{}{}", fmt::join(point.values, ","), cells(point.spec));
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw std::runtime_error(
        fmt::format("standard output cannot be written: {}", std::strerror(errno)));
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::runtime_error("needs a sweep file");
    rotor::print(argv[1]);
  } catch (const std::exception& error) {
    rotor::print_message(fmt::format("map-theory: {}", error.what()));
    return 1;
  }
}
