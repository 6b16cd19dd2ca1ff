/// The closed forms of a map: `map-theory MAP.toml MAP.csv` writes how far each exceeds the
/// quantity that it is compared with, where the runs of the map do what it assumes. gnuplot draws
/// the lines of no excess: a blank line ends a row of the grid, and a second one a panel.
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
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "figures/data/read_csv.hpp"
#include "figures/input/names.hpp"
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

/// The outcomes of a map, panel after panel.
class OutcomesOfMap {
 public:
  OutcomesOfMap(const char* csv, const Sweep& map)
      : width_(map.axes.back().points()), height_(map.axes[map.axes.size() - 2].points()) {
    read_csv(csv, [&](const CsvRow& row) {
      const std::string& name = row["outcome"];
      outcomes_.push_back(name.empty() ? std::nullopt : std::optional(parse_name<Outcome>(name)));
    });
    if (static_cast<long>(outcomes_.size()) != map.points())
      throw std::runtime_error(
          fmt::format("{}: has {} points, the map {}", csv, outcomes_.size(), map.points()));
  }

  /// Whether a quarter of the points around a place have one of these outcomes: those within 2 % of
  /// the panel's sides, and at least two rows and columns. The place is in shares of the sides.
  bool are_around(long panel, double x, double y, const std::array<Outcome, 2>& wanted) const {
    const Span columns = around(x, width_), rows = around(y, height_);
    long all = 0, found = 0;
    for (long row = rows.first; row <= rows.last; ++row)
      for (long column = columns.first; column <= columns.last; ++column) {
        const auto n = static_cast<std::size_t>((panel * height_ + row) * width_ + column);
        ++all;
        found += contains(wanted, outcomes_[n]) ? 1 : 0;
      }
    return 4 * found >= all;
  }

 private:
  struct Span {
    long first, last;
  };
  static Span around(double share, long points) {
    const long last = points - 1, nearest = std::lround(share * static_cast<double>(last)),
               reach = std::max(2L, last / 50);
    return {std::max(0L, nearest - reach), std::min(last, nearest + reach)};
  }

  long width_, height_;
  std::vector<std::optional<Outcome>> outcomes_;  ///< none of refused points
};

void print(const char* file, const char* csv) {
  Sweep sweep = read_sweep(file);
  const std::size_t axes = sweep.axes.size();
  if (axes < 2 || !sweep.sample.over.empty())
    throw std::runtime_error(
        fmt::format("{}: a map needs two [[axis]], and excludes a [sample]", file));
  const OutcomesOfMap outcomes_of_map(csv, sweep);
  Axis &x = sweep.axes[axes - 1], &y = sweep.axes[axes - 2];
  // The lines are nearly straight between so many points, also on a coarse map.
  for (Axis* axis : {&x, &y}) axis->range.points = 200;
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
    const auto share = [](long of, long all) {
      return static_cast<double>(of) / static_cast<double>(std::max(1L, all - 1));
    };
    for (std::size_t line = 0; line < at.size(); ++line)
      if (!outcomes_of_map.are_around(n / (width * height), share(n % width, width),
                                      share(n / width % height, height),
                                      lines_in_words[line].assumed))
        at[line] = std::numeric_limits<double>::quiet_NaN();
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
    if (argc != 3) throw std::runtime_error("needs a sweep file and its results");
    rotor::print(argv[1], argv[2]);
  } catch (const std::exception& error) {
    rotor::print_message(fmt::format("map-theory: {}", error.what()));
    return 1;
  }
}
