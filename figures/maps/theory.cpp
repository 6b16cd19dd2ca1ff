/// The lines of a map: `map-theory MAP.toml` writes where a closed form equals the quantity that it
/// is compared with, as curves with a blank line after each.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

#include "figures/data/csv.hpp"
#include "figures/runs/run_ups.hpp"
#include "figures/sweep/sweep.hpp"
#include "model/theory/accident.hpp"

namespace rotor {
namespace {

/// What map.gp draws.
constexpr std::array lines = {"greatest", "bound", "steady", "forward", "rebound", "peak"};
using Excess = std::array<double, lines.size()>;

/// How far each closed form is above the clearance, the friction or 300 kN; NaN where it has no
/// value. Friction above 1 counts as 1.
Excess excess(const Scenario& scenario) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const Parameters& p = scenario.parameters;
  const double speed = two_pi * scenario.start_speed_Hz, clearance = Ring<double>(p).clearance;
  if (!(speed > 0)) throw std::domain_error("a map needs a start speed, at which the mass is lost");
  const MassLossResponse response(p, scenario.equations, speed);
  const Accident law(p, scenario.equations, speed);
  return {law.reach / clearance - 1,
          response.bound() / clearance - 1,
          response.steady() / clearance - 1,
          std::min(law.forward_friction, 1.) - p.friction,
          law.whirl_friction ? std::min(*law.whirl_friction, 1.) - p.friction : none,
          law.peak_force().value_or(none) / 3e5 - 1};
}

/// A panel of a map: two axes, and the excess at their points, x varying fastest.
struct Panel {
  const Axis &x, &y;
  std::vector<Excess> at;
};

/// The number of an axis a share of the way from its n-th to the next.
double between(const Axis& axis, long n, double share) {
  const double a = axis.number(n), b = axis.number(n + 1);
  return axis.range.logarithmic ? a * std::pow(b / a, share) : a + share * (b - a);
}

/// The curves on which a form has no excess, each as the crossed edges of the grid in order: 2 n is
/// the edge from point n to the right, 2 n + 1 that upwards.
std::vector<std::vector<long>> curves(const Panel& panel, std::size_t form) {
  const long width = panel.x.points();
  std::map<long, std::vector<long>> neighbours;
  for (long n = 0; n + width < static_cast<long>(panel.at.size()); ++n) {
    if (n % width == width - 1) continue;
    const std::array corners = {n, n + 1, n + 1 + width, n + width};
    const std::array edges = {2 * n, 2 * n + 3, 2 * (n + width), 2 * n + 1};
    const auto value = [&](std::size_t k) {
      return panel.at[static_cast<std::size_t>(corners[k % 4])][form];
    };
    if (!std::isfinite(value(0) + value(1) + value(2) + value(3))) continue;
    std::vector<long> crossed;
    for (std::size_t k = 0; k < edges.size(); ++k)
      if ((value(k) < 0) != (value(k + 1) < 0)) crossed.push_back(edges[k]);
    for (std::size_t k = 0; k + 1 < crossed.size(); k += 2) {
      neighbours[crossed[k]].push_back(crossed[k + 1]);
      neighbours[crossed[k + 1]].push_back(crossed[k]);
    }
  }
  std::vector<std::vector<long>> all;
  for (const std::size_t begins : {1UL, 2UL})  // at an end, or anywhere on a closed curve
    for (const auto& [edge, beside] : neighbours) {
      if (beside.size() != begins) continue;
      all.push_back({edge});
      for (long at = edge; !neighbours[at].empty(); all.back().push_back(at)) {
        const long next = neighbours[at].back();
        neighbours[at].pop_back();
        std::erase(neighbours[next], at);
        at = next;
      }
    }
  return all;
}

void print(const Panel& panel, long number) {
  const long width = panel.x.points();
  for (std::size_t form = 0; form < lines.size(); ++form)
    for (const auto& curve : curves(panel, form)) {
      for (const long edge : curve) {
        const long n = edge / 2, i = n % width, j = n / width;
        const bool up = edge % 2 == 1;
        const double here = panel.at[static_cast<std::size_t>(n)][form],
                     there = panel.at[static_cast<std::size_t>(up ? n + width : n + 1)][form],
                     share = here / (here - there);
        fmt::print("{},{},{},{}\n", number, lines[form],
                   up ? panel.x.number(i) : between(panel.x, i, share),
                   up ? between(panel.y, j, share) : panel.y.number(j));
      }
      fmt::print("\n");
    }
}

void print(const char* file) {
  const Sweep sweep = read_sweep(file);
  const std::size_t axes = sweep.axes.size();
  if (axes < 2 || !sweep.sample.over.empty())
    throw std::runtime_error(
        fmt::format("{}: a map needs two [[axis]], and excludes a [sample]", file));
  Panel panel{sweep.axes[axes - 1], sweep.axes[axes - 2], {}};
  const long size = panel.x.points() * panel.y.points();
  const SweepPoints points(sweep);
  fmt::print("{}", csv_head({"Closed forms of model/theory for " + sweep.title},
                            {"panel", "line", "x", "y"}));
  for (long n = 0; n < sweep.points(); ++n) {
    try {
      panel.at.push_back(excess(scenario_of(points(n).spec)));
    } catch (const std::exception&) {  // the sweep reports it in its own row
      panel.at.emplace_back().fill(std::numeric_limits<double>::quiet_NaN());
    }
    if ((n + 1) % size != 0) continue;
    print(panel, n / size);
    panel.at.clear();
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
