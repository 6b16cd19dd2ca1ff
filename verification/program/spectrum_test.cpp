/// `rotor plot --spectrum`.
#include "figures/program/spectrum.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "figures/data/csv.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

using Complex = std::complex<double>;

/// A number between two others.
double between(double least, double greatest) {
  constexpr int steps = 1 << 20;
  return least + (greatest - least) * *rc::gen::inRange(0, steps) / steps;
}

/// The largest amplitude within a number of lines of a number of turns.
double height(const std::vector<double>& all, double turns, long within) {
  const auto count = static_cast<long>(all.size());
  double largest = 0;
  for (long n = std::lround(turns) - within; n <= std::lround(turns) + within; ++n)
    largest = std::max(largest, all[static_cast<std::size_t>((n + count) % count)]);
  return largest;
}

// Two circles of any frequencies, forward or backward, at least five lines apart. The window's top
// deviates from 1 by 4.5e-4, and each circle adds at most 3.1e-5 of its radius to the other.
RC_GTEST_PROP(RandomAmplitudes, AreTheRadiiOfSteadyCircles, ()) {
  const auto samples = static_cast<std::size_t>(*rc::gen::inRange(200, 2000));
  const auto count = static_cast<double>(samples);
  const double turns = between(-0.4 * count, 0.4 * count);
  const double radius = between(1e-4, 1e-3), other_radius = between(0, 1e-3);
  const double other_turns = turns + between(6, 0.5 * count);
  std::vector<Complex> signal;
  for (std::size_t k = 0; k < samples; ++k) {
    const double share = static_cast<double>(k) / count;
    signal.push_back(std::polar(radius, two_pi * turns * share) +
                     std::polar(other_radius, two_pi * other_turns * share + 1));
  }
  const std::vector<double> all = amplitudes(signal);
  RC_ASSERT(std::abs(height(all, turns, 0) - radius) < 4.6e-4 * radius + 3.2e-5 * other_radius);
}

// What README.md says of a frequency that changes: a circle keeps its height to a tenth up to a
// change by twenty lines, and its height then falls. The bound for all changes is the mean of the
// window's magnitude.
RC_GTEST_PROP(RandomAmplitudes, FallWhereTheFrequencyChangesMuch, ()) {
  constexpr std::size_t samples = 2000;
  constexpr auto count = static_cast<double>(samples);
  const double turns = between(-400, 400), change = between(0, 200);
  std::vector<Complex> signal;
  for (std::size_t k = 0; k < samples; ++k) {
    const double share = static_cast<double>(k) / count;
    signal.push_back(std::polar(1., two_pi * (turns + change * (share - 1) / 2) * share));
  }
  const double highest = height(amplitudes(signal), turns, std::lround(change));
  RC_ASSERT(highest < 1.17);
  if (change < 20) RC_ASSERT(std::abs(highest - 1) < 0.1);
  // Stationary phase: the window's top, 4.77, over the square root of the change.
  if (change > 100) RC_ASSERT(std::abs(highest * std::sqrt(change) / 4.77 - 1) < 0.1);
}

class Spectrum : public CommandLine {};

// O moves steadily on a circle, forward, once per turn of the rotor. Its radius is that of steady
// unbalance; the dampers slow the rotor by some millionths in this time.
TEST_F(Spectrum, HasTheRadiusOfACircleAtAnySpeed) {
  std::mt19937 random(1);
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution(a, b)(random);
  };
  std::string scene = "[parameters]\ntorque = 0\ngravity = 0\nno_mass_loss = true\n";
  std::map<std::string, std::pair<double, double>> circles;  // speed and radius
  for (int n = 0; n < 12; ++n) {
    const double speed_Hz = uniform(15, 200), eccentricity = uniform(1e-5, 2e-4);
    const std::string name = fmt::format("{}", n);
    scene +=
        fmt::format("[[run]]\nname = \"{}\"\nstart_speed_hz = {}\neccentricity = {}\nuntil = {}\n",
                    name, speed_Hz, eccentricity, uniform(0.2, 1));
    const Parameters p{};
    const double speed = two_pi * speed_Hz;
    const Complex stiffness(p.support_stiffness - p.mass * speed * speed,
                            p.support_damping * speed);
    circles[name] = {speed_Hz, p.mass * eccentricity * speed * speed / std::abs(stiffness)};
  }
  write("circles.toml", scene);
  ASSERT_EQ(rotor("plot circles.toml --from 0 --spectrum --out spectrum.csv").status, 0);
  std::map<std::string, std::pair<double, double>> highest;
  for (const CsvRow& row : read_csv(folder_ / "spectrum.csv")) {
    auto& largest = highest[row["run"]];
    const auto amplitude = static_cast<double>(row.number("displacement_m"));
    if (amplitude > largest.second)
      largest = {static_cast<double>(row.number("frequency_Hz")), amplitude};
    EXPECT_EQ(row.number("force_N"), 0);
  }
  ASSERT_EQ(highest.size(), circles.size());
  for (const auto& [name, circle] : circles) {
    EXPECT_NEAR(highest[name].first, circle.first, 5) << name;           // the distance of lines
    EXPECT_NEAR(highest[name].second / circle.second, 1, 5e-4) << name;  // the window's top
  }
}

// The highest line of the force in rolling agrees with a direct sum over the trace, in which the
// force is composed of its components along the normal and the tangent.
TEST_F(Spectrum, HasTheForceInRolling) {
  const double from_s = 0.03, length_s = 0.03;
  const long samples = 1024;  // of so short a time
  write("rub.toml",
        "[parameters]\nequations = \"consistent\"\nstart_speed_hz = 150\nuntil = 0.06\n");
  ASSERT_EQ(rotor("plot rub.toml --spectrum --from 0.03 --out spectrum.csv").status, 0);
  ASSERT_EQ(rotor(fmt::format("run --scene rub.toml --from {} --trace t.csv --rows {} --columns "
                              "time_s,x_a_m,y_a_m,normal_force_N,friction_force_N",
                              from_s, samples + 1))
                .status,
            0);
  double frequency_Hz = 0, highest_N = 0;
  for (const CsvRow& row : read_csv(folder_ / "spectrum.csv"))
    if (const auto force_N = static_cast<double>(row.number("force_N")); force_N > highest_N) {
      highest_N = force_N;
      frequency_Hz = static_cast<double>(row.number("frequency_Hz"));
    }
  EXPECT_LT(frequency_Hz, -700);  // the whirl runs backwards
  const std::vector<CsvRow> rows = read_csv(folder_ / "t.csv");
  ASSERT_EQ(rows.size(), samples + 1);
  double real = 0, imaginary = 0;
  for (long k = 0; k < samples; ++k) {
    const auto number = [&](const char* column) {
      return static_cast<double>(rows[static_cast<std::size_t>(k)].number(column));
    };
    const double rho = std::hypot(number("x_a_m"), number("y_a_m"));
    const double n_x = number("x_a_m") / rho, n_y = number("y_a_m") / rho;
    const double force_x = number("normal_force_N") * n_x - number("friction_force_N") * n_y,
                 force_y = number("normal_force_N") * n_y + number("friction_force_N") * n_x;
    const double share = static_cast<double>(k) / static_cast<double>(samples), z = two_pi * share,
                 window = 1 - 1.942604 * std::cos(z) + 1.340318 * std::cos(2 * z) -
                          0.440811 * std::cos(3 * z) + 0.043097 * std::cos(4 * z),
                 angle = -two_pi * frequency_Hz * length_s * share;
    real += window * (force_x * std::cos(angle) - force_y * std::sin(angle));
    imaginary += window * (force_x * std::sin(angle) + force_y * std::cos(angle));
  }
  EXPECT_NEAR(std::hypot(real, imaginary) / static_cast<double>(samples) / highest_N, 1, 1e-9);
}

}  // namespace
}  // namespace rotor
