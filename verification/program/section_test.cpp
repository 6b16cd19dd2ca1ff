/// A motion at a constant speed, once a turn.
#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "model/mechanics/parameters.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

class Sections : public CommandLine {
 protected:
  /// Rub once in two turns, at 2.8 rad/s.
  static std::string partial_rub(double turns) {
    return fmt::format("'" ROTOR_REFERENCE_DATA "/problems/partial-rub.toml' --until {} ",
                       turns * two_pi / 2.8);
  }

  /// Of rows without the name of the run.
  std::vector<std::vector<double>> numbers_of(const char* file) const {
    std::vector<std::vector<double>> all;
    const std::vector<std::string> rows = rows_of(file);
    for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
      std::istringstream cells(*row);
      std::string cell;
      std::getline(cells, cell, ',');
      for (all.emplace_back(); std::getline(cells, cell, ',');)
        all.back().push_back(std::stod(cell));
    }
    return all;
  }
};

TEST_F(Sections, AreTheLastTurnsAndTellAfterHowManyThePositionRepeats) {
  const Json run = summary(partial_rub(600) + "--section s.csv");
  EXPECT_EQ(run["section"], (Json{{"turns", 192}, {"repeats_after_turns", 2}}));
  EXPECT_EQ(rows_of("s.csv").at(0),
            "run,time_s,x_a_m,y_a_m,x_a_rate_m_per_s,y_a_rate_m_per_s,normal_force_N");
  const auto rows = numbers_of("s.csv");
  ASSERT_EQ(rows.size(), 192U);
  for (std::size_t n = 0; n < rows.size(); ++n)
    EXPECT_NEAR(rows[n][0] * 2.8 / two_pi, 409. + static_cast<double>(n), 1e-9);
  // After whole turns the rotor's axes are the stator's; between the ends of steps the motion has
  // some of their errors, of 1e-11.
  EXPECT_NEAR(rows.back()[1], run["final_q1_m"].get<double>(), 1e-10);
  EXPECT_NEAR(rows.back()[2], run["final_q2_m"].get<double>(), 1e-10);
  EXPECT_GT(std::hypot(rows[191][1] - rows[190][1], rows[191][2] - rows[190][2]), 0.1);
}

// The section adds itself to the summary, and evaluations between the ends of steps.
TEST_F(Sections, OfShortRunsHaveTheirTurnsAndPerhapsNoPeriod) {
  Json run = summary(partial_rub(10.5) + "--section s.csv");
  EXPECT_EQ(run["section"], (Json{{"turns", 11}, {"repeats_after_turns", nullptr}}));
  EXPECT_EQ(numbers_of("s.csv").size(), 11U);
  Json without = summary(partial_rub(10.5));
  for (const char* key : {"section", "right_hand_sides", "contact_evaluations"})
    for (Json* of : {&run, &without}) of->erase(key);
  EXPECT_EQ(run, without);
  // The steady response itself repeats after each turn.
  EXPECT_EQ(
      summary("--drive constant_speed --no-mass-loss --start-speed-Hz 60 --ring-offset-y 1e-3 "
              "--until 0.1 --section s.csv")["section"],
      (Json{{"turns", 7}, {"repeats_after_turns", 1}}));
}

TEST_F(Sections, AreRefusedWithoutTurnsOfOneLengthUpToTheEnd) {
  const std::string section = "--section s.csv";
  expect_refusal("run " + section, "--section: needs drive = constant_speed");
  for (const auto& [option, message] :
       {std::pair("--method rk4 ", "--section: only --method event"),
        {"--stop-on rest ", "--section: excludes --stop-on"},
        {"--digits 6 ", "digits: are not estimated in a --section"}})
    expect_refusal("run " + partial_rub(4) + option + section, message);
}

}  // namespace
}  // namespace rotor
