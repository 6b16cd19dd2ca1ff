/// The populations, and the stored ensembles compared with runs.
#include "verification/paper/ensembles.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "figures/data/read_csv.hpp"
#include "verification/paper/claims.hpp"
#include "verification/paper/contact_laws.hpp"
#include "verification/paper/readings.hpp"

namespace rotor {
namespace {

const std::filesystem::path data = ROTOR_REFERENCE_DATA;

TEST(PopulationB, PrintsEveryConditioningNumber) {
  constexpr long count = 1000;
  const PopulationDraws draws(Population::b, data, count);
  EXPECT_LT(draws.proposals_a_draw(), 50);
  std::set<double> torques;  // which differ, as the drawn times of switching off do
  for (long n = 0; n < count; n += n < 20 ? 1 : 20) {  // the run-ups take time
    const PaperInputs inputs = draws(n, Equations::published);
    const auto& of = inputs.spec.numbers;
    EXPECT_TRUE(torques.insert(of.at("torque")).second) << n;
    const double m = of.at("mass"), e = of.at("eccentricity"), r = of.at("rotor_radius"),
                 k_u = of.at("unbalance_factor"), inertia = of.at("inertia"),
                 w = two_pi * of.at("motor_off_Hz");
    const double e_1 = k_u * e, m_u = m * (e_1 - e) / (r + e_1), m_1 = m - m_u, v = w * (r + e);
    const double left = inertia - m_u * std::pow(r + e, 2) - m_1 * std::pow(e_1 - e, 2);
    EXPECT_EQ(fmt::format("{:.1f} g, {:.1f} %, {:.0f}", 1e3 * m_u, 100 * m_u / m, k_u),
              "24.8 g, 0.5 %, 3");
    EXPECT_EQ(fmt::format("{:.0f} and {:.1f} g cm", 1e5 * m * e, 1e5 * m_1 * e_1),
              "75 and 223.9 g cm");
    EXPECT_EQ(fmt::format("{:.2f}e-3, {:.0f} %", 1e3 * left, 100 * (1 - left / inertia)),
              "8.91e-3, 1 %");
    EXPECT_EQ(fmt::format("{:.1f} and {:.3f} m/s", v, m_u * v / m_1), "56.7 and 0.283 m/s");
    EXPECT_EQ(fmt::format("{:.0f} Hz, {:.0f} steps",
                          std::sqrt(of.at("support_stiffness") / m) / two_pi, 1e4 * two_pi / w),
              "10 Hz, 67 steps");
    if (n % 200 > 0) continue;
    PaperRuns runs(inputs);
    EXPECT_EQ(fmt::format("{:.1f} s, {:.1f} and {:.0f} Hz", *read_off("motor_off_s", runs),
                          *read_off("Hz_50", runs), *read_off("Hz_75", runs)),
              "28.3 s, 49.8 and 75 Hz");
  }
}

// The proposals cut nothing off: the draws stay further from their ends than chance would explain.
TEST(PopulationB, LiesWithinItsProposals) {
  constexpr long count = 1000;
  const PopulationDraws draws(Population::b, data, count);
  std::map<std::string, std::vector<double>> shares;
  for (long n = 0; n < count; ++n)
    for (const auto& [input, share] : draws.proposed_shares(n)) shares[input].push_back(share);
  for (const auto& [input, of_input] : shares) {
    EXPECT_GT(std::ranges::min(of_input), 0.005) << input;
    EXPECT_LT(std::ranges::max(of_input), 0.995) << input;
  }
  EXPECT_EQ(shares.size(), 5U);
}

// A part of the stored ensembles, computed again: shares within three standard errors, and the
// right number of values on either side of the stored quantiles.
TEST(Ensembles, AreWhatRunsGive) {
  const Ensembles all = read_ensembles(data / "ensembles.csv");
  constexpr long most = 24;
  std::vector<std::string> readings = readings_to_draw(judged());
  const auto rings = std::partition(  // which take more time
      readings.begin(), readings.end(),
      [](const std::string& name) { return !name.starts_with("law_"); });
  const std::vector<std::string> of_rings(rings, readings.end());
  readings.erase(rings, readings.end());
  for (const auto& [name, population] : {std::pair("a", Population::a), {"b", Population::b}}) {
    const PopulationDraws draws(population, data, most);
    for (const Set& set : sets) {
      const auto at = [&](long n) { return draws(n, set.equations); };
      Draws anew = evaluate(readings, most, at, 2);
      anew.merge(evaluate(of_rings, 6, at, 2));
      for (const Number& number : judged())
        for (const Reading& reading : number.readings) {
          if (!number.is_drawn()) continue;
          const Stored& stored = all.at({set.name, name, number.id, reading.name});
          const Spread& s = stored.spread;
          const double holds = stored.holds;
          const auto count = static_cast<double>(anew.at(reading.name).size());
          const auto share = [&](const std::function<bool(double)>& counts) {
            return static_cast<double>(std::ranges::count_if(anew.at(reading.name), counts)) /
                   count;
          };
          const auto error = [count](double of) {
            return 3 * std::sqrt(of * (1 - of) / count) + 1. / count;
          };
          const std::string what =
              fmt::format("{} ({}) {} {}", set.name, name, number.id, reading.name);
          EXPECT_NEAR(share([&](double v) { return number.allowed().holds(v); }), holds,
                      error(holds))
              << what;
          EXPECT_NEAR(share([](double v) { return !std::isnan(v); }), s.valued, error(s.valued))
              << what;
          EXPECT_EQ(s.draws, 1000) << what;  // as many as make ensembles draws
          const auto digits = [](double v) { return 1e-5 * std::abs(v); };  // of six
          const double half = 0.5 * s.valued, outside = 0.1 * s.valued;
          EXPECT_LE(share([&](double v) { return v < s.median - digits(s.median); }),
                    half + error(half))
              << what;
          EXPECT_GE(share([&](double v) { return v <= s.median + digits(s.median); }),
                    half - error(half))
              << what;
          EXPECT_LE(share([&](double v) {
                      return v < s.low - digits(s.low) || v > s.high + digits(s.high);
                    }),
                    outside + error(outside))
              << what;
        }
    }
  }
}

// The runs at the inputs as printed, and the quantiles of a few draws in one of the rings.
TEST(ContactLaws, LeadToWhatTheTableSays) {
  const PopulationDraws draws(Population::b, data, 8);
  int rows = 0, drawn = 0, above = 0, below = 0;
  for (const CsvRow& row : read_csv(data / "contact-laws.csv")) {
    if (row["equations"] != "published" || row["mu"] != "0.3") continue;
    ++rows;
    const auto exponent = static_cast<double>(row.number("exponent"));
    const bool is_linear = row["same_indentation"].empty();
    const SameIndentation same =
        row["same_indentation"] == "impact" ? SameIndentation::impact : SameIndentation::rolling;
    const auto run_in = [&](PaperRuns& runs) -> const PaperRun& {
      const double mu = runs.inputs().mu_high;
      return is_linear ? runs.with(mu, {}) : runs.with(mu, *numbers_of(exponent, same, runs));
    };
    PaperRuns printed{PaperInputs()};
    const Summary& s = run_in(printed).summary();
    EXPECT_EQ(name_of(s.outcome), row["outcome"]);
    EXPECT_EQ(s.touch_downs, row.number("touch_downs"));
    const double digits = 1e-4;  // of five
    EXPECT_NEAR(*s.peak_normal_force_N / 1e3 / static_cast<double>(row.number("peak_kN")), 1,
                digits);
    EXPECT_NEAR(1e3 * (*s.rolling_onset_s - *s.first_contact_s) /
                    static_cast<double>(row.number("to_rolling_ms")),
                1, digits);
    if (exponent != 1.5) continue;
    for (long n = 0; n < 8; ++n) {
      PaperRuns runs(draws(n, Equations::published));
      if (!numbers_of(exponent, same, runs)) continue;  // it does not roll in the linear ring
      ++drawn;
      const double ratio =
          *run_in(runs).summary().peak_normal_force_N / *runs.high().summary().peak_normal_force_N;
      above += ratio > static_cast<double>(row.number("force_p95"));
      below += ratio < static_cast<double>(row.number("force_p5"));
    }
  }
  EXPECT_EQ(rows, 5);
  // A tenth is outside; more than six of sixteen are so in one of a thousand samples.
  EXPECT_GE(drawn, 12);
  EXPECT_LE(above + below, 6);
}

// A blow of the same velocity indents them as far, and the closed form of the restitution holds.
TEST(ContactLaws, GiveWayAsFarAsTheLinearRing) {
  PaperRuns runs{PaperInputs()};
  const PaperRun& linear = runs.high();
  const auto touch = linear.touch_down_before_rolling(linear.touch_downs_before_rolling() - 1);
  const Parameters p = runs.parameters();
  const double mass = MassLoss<double>(p).after.mass,
               velocity = Ring<double>(p).rim_point(touch->motion()).normal_velocity;
  const double same = deepest_indentation(p, mass, velocity);
  EXPECT_NEAR(same, 43e-6, 0.5e-6);  // 34 kN, as in the run
  for (const double exponent : other_exponents) {
    Parameters other = p;
    const auto numbers = *numbers_of(exponent, SameIndentation::impact, runs);
    for (const auto& [name, value] : numbers) {
      Scenario scenario{.parameters = other};
      find_input_quantity(name)->quantity.in(scenario) = value;
      other = scenario.parameters;
    }
    EXPECT_NEAR(deepest_indentation(other, mass, velocity) / same, 1, 1e-5);
  }
}

TEST(Ensembles, DoNotDependOnTheNumberOfThreads) {
  const PopulationDraws draws(Population::b, data, 3);
  const std::vector<std::string> some = {"peak_kN", "motor_off_s", "low_collisions_s"};
  const auto at = [&](long n) { return draws(n, Equations::published); };
  EXPECT_EQ(evaluate(some, 3, at, 1), evaluate(some, 3, at, 2));
}

TEST(Ensembles, HaveTheQuantilesOfTheirValues) {
  std::vector<double> values;
  for (int n = 100; n >= 0; --n) values.push_back(n);
  values.resize(202, std::nan(""));
  const Spread found = spread(values);
  EXPECT_EQ(found.draws, 202);
  EXPECT_EQ(found.valued, 0.5);
  EXPECT_EQ(found.median, 50);
  EXPECT_EQ(found.low, 5);
  EXPECT_EQ(found.high, 95);
}

}  // namespace
}  // namespace rotor
