/// Right digits of an entry to reference-data/problems.
#include <fmt/format.h>

#include <map>

#include "figures/data/read_csv.hpp"
#include "figures/runs/scene.hpp"
#include "model/run/simulation.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/pattern.hpp"
#include "verification/support/problem_observer.hpp"

namespace rotor {
namespace {

class Score : public CommandLine {
 protected:
  Outcome score_of(const std::string& file) const {
    return shell("'" ROTOR_SOURCES "/verification/benchmark/score.py' " + file);
  }
  Outcome score(const std::string& rows) const {
    write("entry.csv", "problem,quantity,value,seconds,right_hand_sides\n" + rows);
    return score_of("entry.csv");
  }
};

TEST_F(Score, IsFullForTheAnswersThemselves) {
  std::string rows;
  for (const CsvRow& row : read_csv(ROTOR_REFERENCE_DATA "/problems/answers.csv"))
    rows += row["problem"] + ',' + row["quantity"] + ',' + row["value"] + ",2,54321\n";
  const auto [status, output] = score(rows);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(has(output, "| accident | 14.0 |\n")) << "the least of its digits";
  EXPECT_TRUE(has(output, "| accident | 2 / 54,321 |\n"));
  EXPECT_TRUE(matches(output, "missing|not entered|lacks").empty()) << output;
}

// The first touch-down is at 0.00100000000000000 s; of the three quantities one is absent.
TEST_F(Score, CountsTheDigitsThatAreRight) {
  const auto [status, output] =
      score("# an entry\nhertz,touch_downs,1,0.5,\nhertz,touch_down_1_s,1.0001e-3,0.5,\n");
  EXPECT_EQ(status, 0);
  EXPECT_FALSE(matches(output, "touch_downs +right\n").empty()) << output;
  EXPECT_FALSE(matches(output, "touch_down_1_s +4\\.0\n").empty()) << output;
  EXPECT_FALSE(matches(output, "peak_time_s +missing\n").empty()) << output;
  EXPECT_TRUE(has(output, "| hertz | 4.0 * |\n"));
  EXPECT_TRUE(has(output, "| hertz | 0.5 / not counted |\n"));
  EXPECT_TRUE(has(output, "| accident | - |\n"));
  EXPECT_TRUE(has(output, "hertz lacks peak_normal_force_N, "));
  EXPECT_TRUE(has(output, "not entered: accident, "));
}

TEST_F(Score, GivesNoDigitsToAWrongCountOrSign) {
  const std::string output = score("hertz,touch_downs,2,,\nhertz,touch_down_1_s,-1e-3,,\n").output;
  EXPECT_FALSE(matches(output, "touch_downs +0\n").empty()) << output;
  EXPECT_FALSE(matches(output, "touch_down_1_s +0\n").empty()) << output;
}

TEST_F(Score, OfTheEngineIsHighWithoutChaos) {
  std::string rows;
  std::map<std::string, std::map<std::string, double>> found;
  for (const CsvRow& row : read_csv(ROTOR_REFERENCE_DATA "/problems/answers.csv")) {
    auto& values = found[row["problem"]];
    if (values.empty()) {
      const Scene scene = read_scene(ROTOR_REFERENCE_DATA "/problems/" + row["problem"] + ".toml");
      ProblemObserver observer(scene.runs.at(0).scenario);
      run(scene.runs.at(0).scenario, observer);
      values = observer.values();
    }
    rows +=
        fmt::format("{},{},{},,\n", row["problem"], row["quantity"], values.at(row["quantity"]));
  }
  const std::string output = score(rows).output;
  const auto scored = matches(output, "\\| ([a-z-]+) \\| ([0-9.]+) \\|");
  EXPECT_GT(scored.size(), 8U) << output;
  for (const Match& row : scored)
    if (row[1] != "chaos") {
      EXPECT_GE(std::stod(row[2]), 5) << row[1];
    }
}

// Where its samples are close enough, and its friction at another lever does not matter.
TEST_F(Score, OfAnIndependentCodeIsRightInTouchDowns) {
  const std::string output =
      score_of("'" ROTOR_SOURCES "/verification/benchmark/LIGGGHTS.csv'").output;
  for (const char* what : {"accident\n  touch_downs +right", "low-friction\n  touch_downs +right",
                           "hertz\n  touch_downs +right", "limit-cycle\n  touch_downs +right",
                           "touch_down_7_s +[5-9]\\.", "touch_down_10_s +[4-9]\\."})
    EXPECT_FALSE(matches(output, what).empty()) << what << output;
}

TEST_F(Score, NamesWhatItRefuses) {
  const auto expect_refused = [&](const std::string& rows, std::string_view message) {
    const auto [status, output] = score(rows);
    EXPECT_NE(status, 0) << rows;
    EXPECT_TRUE(has(output, message));
    EXPECT_EQ(output.find("Traceback"), output.npos);
  };
  expect_refused("herz,touch_downs,1,,\n",
                 "entry.csv, line 2: unknown problem 'herz'; must be one of: accident, ");
  expect_refused("hertz,touches,1,,\n",
                 "line 2: unknown quantity 'touches' of hertz; must be one of: touch_downs, ");
  expect_refused("hertz,touch_downs,1,,\n\n# twice\nhertz,touch_downs,1,,\n",
                 "line 5: touch_downs of hertz is stated twice; remove one row");
  expect_refused("hertz,touch_downs,none,,\n", "line 2: value must be a number, not 'none'");
  expect_refused("hertz,touch_downs,nan,,\n", "line 2: value must be a number, not 'nan'");
  expect_refused("hertz,touch_downs,,,\n", "line 2: value must be a number, not ''");
  expect_refused("hertz,touch_downs,1,fast,\n", "line 2: seconds must be a number, not 'fast'");
  expect_refused("hertz,touch_downs,1,-1,\n",
                 "line 2: seconds must be a positive number, not '-1'");
  expect_refused("hertz,touch_downs,1,1,8.5\n",
                 "line 2: right_hand_sides must be a whole number, not '8.5'");
  expect_refused("hertz,touch_downs,1,2,\nhertz,peak_time_s,1,3,\n",
                 "line 3: seconds of hertz was 2 above; state one of them");
  expect_refused("hertz,touch_downs\n", "line 2: 2 cells; must be 5, as in the first row");
  expect_refused("hertz,touch_downs,1,,,\n", "line 2: 6 cells; must be 5, as in the first row");
  expect_refused("hertz,\"touch_downs\n", "line 2: unexpected end of data");
}

TEST_F(Score, NamesTheColumnsThatItReads) {
  for (const char* titles : {"problem,value", "problem,quantity,value,second",
                             "problem,quantity,value,value", "problem;quantity;value", ""}) {
    write("other.csv", std::string("# an entry\n") + titles + '\n');
    const auto [status, output] = score_of("other.csv");
    EXPECT_NE(status, 0);
    EXPECT_TRUE(has(output, "other.csv")) << output;
    EXPECT_TRUE(has(output,
                    "the first row must be problem,quantity,value, perhaps with seconds and "
                    "right_hand_sides, not '" +
                        std::string(titles) + "'"))
        << output;
  }
  write("other.csv", "\xef\xbb\xbfvalue,quantity,problem\r\n1,touch_downs,hertz\r\n");
  EXPECT_TRUE(has(score_of("other.csv").output, "| hertz | right * |"));
}

}  // namespace
}  // namespace rotor
