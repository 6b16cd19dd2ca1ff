/// The stored ensembles are what runs give.
#include "verification/paper/ensembles.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/paper/judged.hpp"

namespace rotor {
namespace {

/// The share of draws that have a value.
double values_share(const std::vector<double>& values) {
  return spread(values, [](double value) { return !std::isnan(value); }).share;
}

// A part of the stored ensembles, drawn anew: shares within three standard errors.
TEST(Ensembles, AreWhatRunsGive) {
  const auto inputs = std::filesystem::path(ROTOR_REFERENCE_DATA) / "printed-inputs.csv";
  for (const auto& [rounded, count] :
       {std::pair(Rounded::times, 40L), {Rounded::everything, 120L}}) {
    const Draws draws =
        draw(readings_to_draw(judged()), inputs, rounded, Equations::published, count, 2);
    for (const Number& number : judged())
      for (const Reading& reading : number.readings) {
        if (number.kind != Kind::simulated) continue;
        const Spread stored = rounded == Rounded::times ? reading.times : reading.everything;
        const Spread anew = spread(draws.at(reading.name),
                                   [&](double value) { return number.allowed.holds(value); });
        const auto n = static_cast<double>(count);
        const double deviation = std::sqrt(stored.share * (1 - stored.share) / n);
        EXPECT_NEAR(anew.share, stored.share, 3 * deviation + 1 / n) << number.id << reading.name;
        if (std::isfinite(stored.low)) {  // nine of ten lie between the quantiles
          const Spread inside = spread(draws.at(reading.name), [&](double value) {
            const double rounding = 1e-5 * std::abs(value);  // of six digits
            return stored.low - rounding <= value && value <= stored.high + rounding;
          });
          EXPECT_GT(
              inside.share + 3 * std::sqrt(0.09 / n) + (1 - values_share(draws.at(reading.name))),
              0.9)
              << number.id << reading.name;
        }
      }
  }
}

// Of the accidents in either set of equations: shares within three standard errors, and as many of
// the forces on either side of the quantiles.
TEST(Ensembles, OfAccidentsAreWhatRunsGive) {
  const std::filesystem::path folder(ROTOR_REFERENCE_DATA);
  const Accidents all = read_accidents(folder / "accidents.csv");
  EXPECT_EQ(all.size(), 2 * losses_of_accidents().size());
  constexpr double count = 150;
  const auto error = [](double share, double of) {
    return 3 * std::sqrt(share * (1 - share) / of) + 1 / of;
  };
  for (const auto& [name, equations] :
       {std::pair("published", Equations::published), {"consistent", Equations::consistent}}) {
    const Draws draws = draw(readings_of_accidents(), folder / "printed-inputs.csv",
                             Rounded::everything, equations, static_cast<long>(count), 2);
    for (const LossOfAccident& loss : losses_of_accidents()) {
      const auto& [force, rolls] = all.at({loss.at, name});
      const Accident anew = accident(loss, draws);
      EXPECT_EQ(force.draws, 10000);
      EXPECT_NEAR(anew.force.share, force.share, error(force.share, count)) << loss.at << name;
      EXPECT_NEAR(anew.rolls, rolls, error(rolls, count)) << loss.at << name;
      const auto& forces = draws.at(loss.force);
      for (const auto& [until, expected] :
           {std::pair(force.low, 0.05), {force.median, 0.5}, {force.high, 0.95}}) {
        const double below =
            spread(forces, [limit = until](double value) { return value <= limit; }).share;
        EXPECT_NEAR(below / anew.force.share, expected, error(expected, count * force.share))
            << loss.at << name << expected;
      }
    }
  }
}

TEST(Ensembles, DoNotDependOnTheNumberOfThreads) {
  const auto inputs = std::filesystem::path(ROTOR_REFERENCE_DATA) / "printed-inputs.csv";
  const Draws one =
      draw(readings_to_draw(judged()), inputs, Rounded::everything, Equations::published, 3, 1);
  const Draws two =
      draw(readings_to_draw(judged()), inputs, Rounded::everything, Equations::published, 3, 2);
  for (const auto& [reading, values] : one)
    for (std::size_t n = 0; n < values.size(); ++n)
      EXPECT_TRUE(values[n] == two.at(reading)[n] ||
                  (std::isnan(values[n]) && std::isnan(two.at(reading)[n])))
          << reading;
}

TEST(Ensembles, HaveTheQuantilesOfTheirValues) {
  std::vector<double> values;
  for (int n = 100; n >= 0; --n) values.push_back(n);
  values.push_back(std::nan(""));
  const Spread found = spread(values, [](double value) { return value < 51; });
  EXPECT_EQ(found.draws, 102);
  EXPECT_EQ(found.median, 50);
  EXPECT_EQ(found.low, 5);
  EXPECT_EQ(found.high, 95);
  EXPECT_EQ(found.share, 0.5);
}

}  // namespace
}  // namespace rotor
