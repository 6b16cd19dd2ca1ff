/// A motion at a constant speed, once a turn.
#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "figures/sweep/journal.hpp"
#include "figures/sweep/sweep_row.hpp"
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
  const Json run = summary(partial_rub(600) + "--section s.csv"), found = run["section"];
  EXPECT_EQ(found["section_turns"], 192);
  EXPECT_EQ(found["repeats_after_turns"], 2);
  EXPECT_EQ(found["orders_over_turns"], 192);
  EXPECT_EQ(found["orders_over_whole_periods"], true);
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
  Json run = summary(partial_rub(10.5) + "--section s.csv"),
       short_one = summary(partial_rub(10.5) + "--section s.csv --section-turns 5")["section"],
       without = summary(partial_rub(10.5));
  EXPECT_EQ(run["section"]["section_turns"], 10);
  EXPECT_EQ(run["section"]["repeats_after_turns"], nullptr);
  EXPECT_EQ(run["section"]["orders_over_turns"], 6);
  EXPECT_EQ(run["section"]["orders_over_whole_periods"], false);
  EXPECT_EQ(short_one["orders_over_turns"], 0);
  EXPECT_EQ(short_one["orders_over_whole_periods"], nullptr);
  EXPECT_EQ(short_one["order_1_forward_m"], nullptr);
  EXPECT_EQ(numbers_of("s.csv").size(), 5U);
  for (const char* key : {"section", "right_hand_sides", "contact_evaluations"})
    for (Json* of : {&run, &without}) of->erase(key);
  EXPECT_EQ(run, without);
}

// The steady response repeats after each turn; C turns with the rotor, at e W^2/(w^2 - W^2) for
// weak damping, and nothing is backward or at another order.
TEST_F(Sections, OfTheSteadyResponseHaveItAsTheirFirstOrder) {
  const Json found = summary(
      "--drive constant_speed --no-mass-loss --start-speed-Hz 60 --support-damping 0 "
      "--ring-offset-y 1e-3 --until 0.2 --section s.csv")["section"];
  EXPECT_EQ(found["section_turns"], 12);
  EXPECT_EQ(found["repeats_after_turns"], 1);
  const Parameters p;
  const double speed = 60 * two_pi, w2 = p.support_stiffness / p.mass;
  const double of_O = p.eccentricity * speed * speed / (w2 - speed * speed);
  const double rounding = 1e-12;  // m, of twelve turns and a displacement of mm
  EXPECT_NEAR(found["order_1_forward_m"].get<double>(), std::abs(of_O), rounding);
  EXPECT_NEAR(std::abs(found["order_1_forward_phase_rad"].get<double>()), two_pi / 2, 1e-9);
  EXPECT_NEAR(found["order_1_backward_m"].get<double>(), 0, rounding);
  EXPECT_NEAR(found["order_1_x_a_peak_to_peak_m"].get<double>(), 2 * std::abs(of_O), rounding);
  for (const char* other : {"1_3", "1_2", "2_3", "3_2", "2"})
    for (const char* sense : {"forward", "backward"})
      EXPECT_NEAR(found[fmt::format("order_{}_{}_m", other, sense)].get<double>(), 0, rounding);
}

// A balanced rotor that vibrates once in two turns is in the middle after each, and moves the other
// way; nothing of its vibration is at another order. The last turn may end with the run, up to
// rounding.
TEST_F(Sections, TellMotionsApartByTheirVelocity) {
  const Parameters p;
  const double natural_Hz = std::sqrt(p.support_stiffness / p.mass) / two_pi;
  for (const double turns : {40., 40 - 1e-10, 40 - 1e-6}) {
    const Json found = summary(fmt::format(
        "--drive constant_speed --no-mass-loss --eccentricity 0 --support-damping 0 --start-x 0 "
        "--start-y 0 --start-velocity-x 0.1 --start-velocity-y 0 --start-speed-Hz {} --until {} "
        "--section s.csv",
        2 * natural_Hz, turns / (2 * natural_Hz)))["section"];
    EXPECT_EQ(found["section_turns"], turns > 40 - 1e-9 ? 40 : 39);
    EXPECT_EQ(found["repeats_after_turns"], 2);
    EXPECT_NEAR(found["order_1_2_x_a_peak_to_peak_m"].get<double>(), 0.2 / (two_pi * natural_Hz),
                1e-9);
    EXPECT_EQ(found["order_1_forward_m"], 0);
    EXPECT_EQ(found["order_1_forward_phase_rad"], nullptr);
  }
}

TEST_F(Sections, AreRefusedWithoutTurnsOfOneLengthUpToTheEnd) {
  const std::string section = "--section s.csv";
  expect_refusal("run " + section, "--section: needs drive = constant_speed");
  for (const auto& [option, message] :
       {std::pair("--method rk4 ", "--section: needs method = event"),
        {"--stop-on rest ", "--section: excludes --stop-on"},
        {"--digits 6 ", "digits: are not estimated in a --section"}})
    expect_refusal("run " + partial_rub(4) + option + section, message);
  expect_refusal("run " + partial_rub(0.9) + section, "is before the end of the first turn");
  expect_refusal("run --section-turns 3", "--section-turns requires --section");
}

/// A sweep over the speed, from one that is too slow for a turn on.
std::string over_speed(const std::string& section) {
  return "columns = [\"touch_downs\", \"repeats_after_turns\", \"order_1_2_forward_m\"]\n" +
         section +
         "[parameters]\ndrive = \"constant_speed\"\nno_mass_loss = true\nuntil = 0.5\n"
         "ring_offset_x = -2.4525e-3\ntolerance = 1e-8\n"
         "[[axis]]\nquantity = \"start_speed_Hz\"\nvalues = [1.5, 40, 60]\n";
}

TEST_F(Sections, OfASweepAreThoseOfItsRuns) {
  write("s.toml", over_speed("section = { turns = 12 }\n"));
  EXPECT_EQ(rotor("sweep s.toml").status, 0);
  EXPECT_EQ(rows_of("s-sections.csv").at(0),
            "point,start_speed_Hz,time_s,x_a_m,y_a_m,x_a_rate_m_per_s,y_a_rate_m_per_s,"
            "normal_force_N");
  std::vector<std::string> expected_rows, expected;
  for (const auto& [point, speed] : {std::pair(2, 40), {3, 60}}) {
    const Json run = summary(
        fmt::format("--drive constant_speed --no-mass-loss --until 0.5 --ring-offset-x -2.4525e-3 "
                    "--tolerance 1e-8 --start-speed-Hz {} --section one.csv --section-turns 12",
                    speed));
    expected.push_back(fmt::format("{},{},{},{},", speed, cell_of(run["touch_downs"]),
                                   cell_of(run["section"]["repeats_after_turns"]),
                                   cell_of(run["section"]["order_1_2_forward_m"])));
    const auto rows = rows_of("one.csv");
    EXPECT_EQ(rows.size(), 13U);
    for (auto row = rows.begin() + 1; row != rows.end(); ++row)
      expected_rows.push_back(fmt::format("{},{}", point, speed) + row->substr(row->find(',')));
  }
  const auto rows = rows_of("s.csv"), in_sections = rows_of("s-sections.csv");
  EXPECT_EQ(std::vector(rows.begin() + 2, rows.end()), expected);
  EXPECT_TRUE(has(rows.at(1), "until = 0.5 s is before the end of the first turn"));
  EXPECT_EQ(std::vector(in_sections.begin() + 1, in_sections.end()), expected_rows);
}

// Points, parts and journals have their sections with them.
TEST_F(Sections, OfASweepAreKeptJoinedAndResumed) {
  write("s.toml", over_speed("section = {}\n"));
  ASSERT_EQ(rotor("sweep s.toml --out whole.csv").status, 0);
  const auto expect_whole = [this](const std::string& results, const std::string& sections) {
    EXPECT_TRUE(content(results) == content("whole.csv"));
    EXPECT_TRUE(content(sections) == content("whole-sections.csv"));
  };
  for (const char* part : {"1/2", "2/2"})
    ASSERT_EQ(rotor(fmt::format("sweep s.toml --part {}", part)).status, 0);
  write("s.1-of-9.png", "not a part");
  EXPECT_EQ(rotor("sweep s.toml --join").status, 0);
  expect_whole("s.csv", "s-sections.csv");
  // A point is refused still, the others are kept with their sections.
  const auto retried = rotor("sweep s.toml --retry");
  EXPECT_TRUE(has(retried.output, "2 rows of s.csv are kept"));
  expect_whole("s.csv", "s-sections.csv");
  {
    const Sweep sweep = read_sweep(folder_ / "s.toml");
    Journal journal(folder_ / "r.csv", heads_of(sweep), sweep.points());
    SweepRows rows(sweep);
    for (const long point : {0, 1}) journal.write(rows(point));
  }
  const auto resumed = rotor("sweep s.toml --out r.csv");
  EXPECT_TRUE(has(resumed.output, "2 of 3 points are already in r.csv.journal"));
  expect_whole("r.csv", "r-sections.csv");
  // Neither file is trusted without the other.
  shell("sed -i '$d' r-sections.csv");
  expect_refusal("sweep s.toml --out r.csv", "is damaged or cut");
  fs::remove(folder_ / "r-sections.csv");
  expect_refusal("sweep s.toml --out r.csv", "r-sections.csv: is missing; --force");
  EXPECT_EQ(rotor("sweep s.toml --out r.csv --retry").status, 0);
  expect_whole("r.csv", "r-sections.csv");
  fs::remove(folder_ / "s.1-of-2-sections.csv");
  expect_refusal("sweep s.toml --join --force",
                 "s.1-of-2-sections.csv: is missing; --part 1/2 --retry computes it anew");
  // Whatever else has that name is kept, also while a journal waits.
  for (const char* journal : {"", "r.csv.journal"}) {
    fs::remove(folder_ / "r.csv");
    if (*journal) write(journal, "");
    write("r-sections.csv", "mine\n");
    expect_refusal("sweep s.toml --out r.csv", "r-sections.csv: is of another sweep file");
    EXPECT_EQ(content("r-sections.csv"), "mine\n");
  }
  EXPECT_EQ(rotor("sweep s.toml --out r.csv --force").status, 0);
  expect_whole("r.csv", "r-sections.csv");
  expect_refusal("plot r-sections.csv", "r-sections.csv: has the sections of a sweep");
}

TEST_F(Sections, OfASweepAreRefusedWithTheReason) {
  for (const auto& [section, message] :
       {std::pair("section = 3\n", "section: must be a table"),
        {"section = { turns = 0 }\n", "turns: must be at least 1"},
        {"section = { turns = 10001 }\n", "turns: must be at most 10000"},
        {"section = { turn = 3 }\n", "turn"},
        {"", "repeats_after_turns needs section = { turns = 192 }"}}) {
    write("s.toml", over_speed(section));
    expect_refusal("sweep s.toml", message);
  }
  for (const auto& [parameter, message] :
       {std::pair("", "section: needs drive = constant_speed"),
        {"drive = \"constant_speed\"\nmethod = \"rk4\"\n", "section: needs method = event"},
        {"drive = \"constant_speed\"\ndigits = 6\n", "section: excludes digits"}}) {
    write("s.toml", fmt::format("section = {{}}\n[parameters]\nstart_speed_Hz = 60\n{}"
                                "[[axis]]\nquantity = \"friction\"\nvalues = [0.1, 0.2]\n",
                                parameter));
    expect_refusal("sweep s.toml", message);
  }
}

}  // namespace
}  // namespace rotor
