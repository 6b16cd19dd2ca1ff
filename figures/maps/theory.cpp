/// The closed forms of a map: `map-theory MAP.toml` writes how far each exceeds the quantity that
/// it is compared with. gnuplot draws the lines of no excess: a blank line ends a row of the grid,
/// and a second one a panel.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <limits>
#include <stdexcept>

#include "figures/input/words.hpp"
#include "figures/runs/run_ups.hpp"
#include "figures/sweep/sweep.hpp"
#include "model/theory/accident.hpp"

namespace rotor {
namespace {

/// For each line of maps.
using Excess = std::array<double, lines_in_words.size()>;

/// How far each closed form is above the clearance, the friction or 300 kN; NaN where it has no
/// value. Friction above 1 counts as 1.
Excess excess(const Scenario& scenario) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const Parameters& p = scenario.parameters;
  const double speed = two_pi * scenario.start_speed_Hz, clearance = Ring<double>(p).clearance;
  if (scenario.start) throw std::domain_error("the closed forms hold for a steady start");
  if (!(speed > 0)) throw std::domain_error("a map needs a start speed, at which the mass is lost");
  const MassLossResponse response(p, scenario.equations, speed);
  const Accident law(p, scenario.equations, speed);
  return {law.reach / clearance - 1,
          response.bound() / clearance - 1,
          response.steady() / clearance - 1,
          std::min(law.lasting_friction(), 1.) - p.friction,
          law.whirl_friction ? std::min(*law.whirl_friction, 1.) - p.friction : none,
          law.peak_force().value_or(none) / 3e5 - 1};
}

void print(const char* file) {
  Sweep sweep = read_sweep(file);
  const std::size_t axes = sweep.axes.size();
  if (axes < 2 || !sweep.sample.over.empty())
    throw std::runtime_error(
        fmt::format("{}: a map needs two [[axis]], and excludes a [sample]", file));
  Axis &x = sweep.axes[axes - 1], &y = sweep.axes[axes - 2];
  constexpr long most = 200;  // the lines are nearly straight between the points
  for (Axis* axis : {&x, &y}) axis->range.points = std::min(axis->range.points, most);
  const long width = x.points(), height = y.points();
  const SweepPoints points(sweep);
  fmt::print("# Closed forms of model/theory for {}\n# x,y", sweep.title);
  for (const LineInWords& line : lines_in_words) fmt::print(",{}", line.name);
  fmt::print("\n");
  for (long n = 0; n < sweep.points(); ++n) {
    const auto [spec, values] = points(n);
    Excess at{};
    try {
      at = excess(scenario_of(spec));
    } catch (const std::exception&) {  // the sweep reports it in its own row
      at.fill(std::numeric_limits<double>::quiet_NaN());
    }
    const bool ends_row = (n + 1) % width == 0, ends_panel = (n + 1) % (width * height) == 0;
    fmt::print("{},{},{:.6g}\n{}{}", values[axes - 1], values[axes - 2], fmt::join(at, ","),
               ends_row ? "\n" : "", ends_panel ? "\n" : "");
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
