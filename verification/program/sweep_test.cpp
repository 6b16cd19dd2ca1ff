/// `rotor sweep`: its points, their order, and that it goes on where it was killed.
#include "figures/sweep/sweep.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <utility>

#include "figures/data/csv.hpp"
#include "figures/sweep/journal.hpp"
#include "figures/sweep/sweep_row.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

/// Of every kind of thing that can vary, with stalls, refusals and contacts before the loss.
const char* const mixed = R"(
title = "mixed"
[parameters]
tolerance = 1e-7
[[axis]]
quantity = "equations"
values = ["published", "consistent"]
[[axis]]
quantity = "support_stiffness"
from = 2e4
to = 1.2e5
points = 3
spacing = "log"
[[axis]]
quantity = "friction"
values = [0.3, 0.08]
[sample]
count = 8
seed = 3
[[sample.over]]
quantity = "separation_speed_hz"
normal = [75, 15]
[[sample.over]]
quantity = "clearance"
uniform = [2.5e-3, 3.5e-3]
)";

class SweepCommand : public CommandLine {
 protected:
  Sweep sweep(const std::string& text) const {
    write("s.toml", text);
    return read_sweep(folder_ / "s.toml");
  }
  std::vector<CsvRow> results(const std::string& name) const { return read_csv(folder_ / name); }
  /// Of runs to their ends, in a folder that was not there.
  std::vector<CsvRow> swept(const std::string& text) const {
    write("s.toml", "stop_on = \"end\"\n" + text);
    EXPECT_EQ(rotor("sweep s.toml --out new/r.csv").status, 0);
    return results("new/r.csv");
  }
};

// A hundred points of many kinds; what a run says, it says on the command line.
TEST_F(SweepCommand, SaysOfEachPointWhatARunOfItsOwnSays) {
  const Sweep sweep = this->sweep(mixed);
  ASSERT_EQ(rotor("sweep s.toml --out r.csv").status, 0);
  const auto rows = results("r.csv");
  ASSERT_EQ(static_cast<long>(rows.size()), sweep.points());
  ASSERT_EQ(rows.size(), 96U);
  const SweepPoints points(sweep);
  int refused = 0;
  std::set<std::string> outcomes;
  for (long n = 0; n < sweep.points(); ++n) {
    const SweepPoint point = points(n);
    const CsvRow& row = rows[static_cast<std::size_t>(n)];
    std::string options = "--tolerance 1e-7 --stop-on outcome";
    const auto quantities = sweep.quantities();
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      std::string option = quantities[i];
      std::replace(option.begin(), option.end(), '_', '-');
      options += fmt::format(" --{} {}", option, point.values[i]);
    }
    const Outcome run = rotor("run --json " + options + " 2> messages");
    if (run.status != 0) {
      ++refused;
      EXPECT_EQ("rotor: " + row["refusal"] + "\n", content("messages")) << options;
      EXPECT_EQ(row["outcome"], "");
      continue;
    }
    EXPECT_EQ(row["refusal"], "");
    EXPECT_EQ(row["equations_varied"], point.values[0]);
    outcomes.insert(row["outcome"]);
    const auto summary = nlohmann::ordered_json::parse(run.output);
    for (const auto& [key, value] : summary.items()) {
      if (value.is_structured() || key == "version" || key == "schema") continue;
      const std::string expected = value.is_null()     ? ""
                                   : value.is_string() ? value.get<std::string>()
                                                       : value.dump();
      EXPECT_EQ(row[key], expected) << key << ' ' << options;
    }
  }
  EXPECT_GT(refused, 5);
  EXPECT_LT(refused, 75);
  EXPECT_GE(outcomes.size(), 3U);
}

TEST_F(SweepCommand, RunsEachToItsEndWhereItIsAskedTo) {
  const std::string axis = "[[axis]]\nquantity = \"friction\"\nvalues = [0.3]\n";
  const auto final_time = [&](const std::string& text) {
    write("s.toml", text);
    EXPECT_EQ(rotor("sweep s.toml --out r.csv").status, 0);
    return std::stod(results("r.csv").at(0)["final_time_s"]);
  };
  EXPECT_EQ(final_time("stop_on = \"end\"\n" + axis), 29.35);
  EXPECT_LT(final_time(axis), 29.2);  // rolling, 23 ms after the first contact
}

// A tab is no more than a blank there.
TEST_F(SweepCommand, HasTheSweepFileAboveItsRows) {
  const Sweep sweep = this->sweep("[[axis]]\r\nquantity\t= \"friction\"\nvalues = [0.3]\n");
  EXPECT_NE(
      sweep_head(sweep).find("\n#   [[axis]]\n#   quantity = \"friction\"\n#   values = [0.3]\n"),
      std::string::npos);
}

// The same cells as in the whole rows, a refusal beside them.
TEST_F(SweepCommand, WritesTheColumnsThatItIsAskedFor) {
  const std::string axis = "[[axis]]\nquantity = \"start_speed_hz\"\nvalues = [10, 150]\n";
  write("whole.toml", "[parameters]\nclearance = 1e-3\n" + axis);
  write("part.toml", "columns = [\"collisions\", \"outcome\"]\n" + content("whole.toml"));
  ASSERT_EQ(rotor("sweep whole.toml --out whole.csv").status, 0);
  ASSERT_EQ(rotor("sweep part.toml --out part.csv").status, 0);
  EXPECT_EQ(rows_of("part.csv").at(0), "start_speed_hz,collisions,outcome,refusal");
  const auto whole = results("whole.csv"), part = results("part.csv");
  ASSERT_EQ(part.size(), 2U);
  for (std::size_t n = 0; n < part.size(); ++n)
    for (const char* column : {"start_speed_hz", "collisions", "outcome", "refusal"})
      EXPECT_EQ(part[n][column], whole[n][column]) << column;
  EXPECT_NE(part[0]["refusal"], "");
  EXPECT_EQ(part[1]["outcome"], "rolling");
}

TEST_F(SweepCommand, WritesTheSameBytesWhateverTheNumberOfThreads) {
  write("s.toml", mixed);
  for (const char* jobs : {"1", "2", "5"})
    ASSERT_EQ(rotor(fmt::format("sweep s.toml --out {0}.csv --jobs {0}", jobs)).status, 0);
  EXPECT_FALSE(content("1.csv").empty());
  EXPECT_TRUE(content("1.csv") == content("2.csv"));
  EXPECT_TRUE(content("1.csv") == content("5.csv"));
  EXPECT_EQ(files(), 4);
}

// Or interrupted; at twenty instants, wherever it is then. None of its rows is worked out twice.
TEST_F(SweepCommand, GoesOnWhereItWasKilled) {
  const auto sweep_whole = [&](int count) {
    write("s.toml", fmt::format("[parameters]\ntolerance = 1e-6\nuntil = 29.4\n[sample]\n"
                                "count = {}\nmethod = \"random\"\n[[sample.over]]\n"
                                "quantity = \"friction\"\nlog_uniform = [0.05, 1]\n",
                                count));
    EXPECT_EQ(rotor("sweep s.toml --out whole.csv --jobs 2").status, 0);
    return content("whole.csv");
  };
  const std::string whole = sweep_whole(4000);
  std::mt19937 random(1);
  std::size_t last = 0;
  int kills = 0;
  for (; kills < 20 && !fs::exists(folder_ / "cut.csv"); ++kills) {
    shell(fmt::format(
        "timeout --foreground --signal={} {} $rotor sweep s.toml --out cut.csv --jobs 2",
        kills % 2 ? "INT" : "KILL", 0.03 + static_cast<double>(random() % 60) / 1000));
    const std::size_t now = content("cut.csv.journal").size();
    EXPECT_TRUE(now >= std::exchange(last, now) || fs::exists(folder_ / "cut.csv")) << kills;
    if (kills == 3) write("cut.csv.journal", content("cut.csv.journal") + "0.07,rol");  // torn
  }
  EXPECT_GE(kills, 5);
  EXPECT_EQ(rotor("sweep s.toml --out cut.csv").status, 0);
  EXPECT_TRUE(content("cut.csv") == whole);
  EXPECT_EQ(files(), 3);
}

// Whatever has happened to a journal since, power cuts included, the results are those of a sweep
// that nobody disturbed; the rows before the damage are not worked out again.
TEST_F(SweepCommand, MakesGoodWhatHasHappenedToItsJournal) {
  const std::string head = sweep_head(
      sweep("[parameters]\nstart_speed_hz = 150\nuntil = 1e-3\n[[axis]]\nquantity = \"friction\"\n"
            "from = 0.1\nto = 0.3\npoints = 40\n"));
  ASSERT_EQ(rotor("sweep s.toml --out whole.csv").status, 0);
  const std::string whole = content("whole.csv");
  Journal(folder_ / "r.csv", head).write(whole.substr(head.size()));
  const std::string journal = content("r.csv.journal");
  std::vector<std::size_t> rows = {head.size()};  // where they begin, and the last one ends
  while (rows.back() < journal.size()) rows.push_back(journal.find('\n', rows.back()) + 1);
  ASSERT_EQ(rows.size(), 41U);
  std::mt19937 random(1);
  const auto below = [&](std::size_t n) { return random() % n; };
  for (int n = 0; n < 40; ++n) {
    const std::size_t row = below(40), other = below(40), at = rows[row];
    const std::string its = journal.substr(at, rows[row + 1] - at);
    std::string damaged = journal, what;
    std::size_t good = row;  // rows before the damage
    switch (n % 7) {
      case 0:
        what = "lost", damaged.erase(at, its.size());
        break;
      case 1:
        what = "doubled", damaged.insert(at, its);
        good = row + 1;
        break;
      case 2:
        what = "garbled", damaged[at + below(its.size())] ^= static_cast<char>(1 + below(255));
        break;
      case 3:
        what = "zeros", std::fill_n(&damaged[at + 1], 1 + below(journal.size() - at - 1), '\0');
        break;
      case 4:
        what = "one too many", damaged += its, good = 40;
        break;
      case 5:
        what = "cut", damaged.resize(at + below(its.size()));
        break;
      default:
        what = "of another place",
        damaged.insert(at, journal, rows[other], rows[other + 1] - rows[other]);
        good = other == row ? row + 1 : row;
    }
    write("r.csv.journal", damaged);
    const auto [status, output] = rotor("sweep s.toml --out r.csv");
    EXPECT_EQ(status, 0) << what << output;
    EXPECT_TRUE(content("r.csv") == whole) << what << row;
    const std::string there = fmt::format("{} of 40 points are there already", good);
    EXPECT_EQ(output.find(there) != std::string::npos, good > 0) << what << row << output;
    EXPECT_EQ(output.find("are dropped") != std::string::npos, damaged.size() > rows[good])
        << what << row << output;
    EXPECT_EQ(files(), 3);
  }
  for (const std::size_t begun : {std::size_t{0}, std::size_t{1}, head.size() - 1}) {
    write("r.csv.journal", head.substr(0, begun));
    EXPECT_EQ(rotor("sweep s.toml --out r.csv 2>&-").status, 0);  // nobody is told
    EXPECT_TRUE(content("r.csv") == whole) << begun;
  }
}

TEST_F(SweepCommand, RefusesAJournalThatIsNoRegularFile) {
  write("s.toml", mixed);
  ASSERT_EQ(shell("mkfifo r.csv.journal").status, 0);
  expect_refusal("sweep s.toml --out r.csv", "r.csv.journal: must be a regular file");
}

TEST_F(SweepCommand, RefusesAJournalOfAnotherSweepAndOneThatIsBeingWritten) {
  write("s.toml", mixed);
  write("r.csv", "old");
  write("r.csv.journal", "# Sweep: another\n");
  expect_refusal("sweep s.toml --out r.csv", "r.csv.journal: is of another sweep file");
  EXPECT_EQ(content("r.csv.journal"), "# Sweep: another\n");
  EXPECT_EQ(content("r.csv"), "old");
  for (const char* lock : {"flock", "flock --shared"}) {
    const std::string output =
        shell(fmt::format("{} r.csv.journal $rotor sweep s.toml --out r.csv", lock)).output;
    EXPECT_NE(output.find("another sweep is writing it"), std::string::npos) << output;
    EXPECT_EQ(content("r.csv"), "old");
  }
}

TEST_F(SweepCommand, LeavesAJournalWhenItIsInterrupted) {
  write("s.toml", "[[axis]]\nquantity = \"friction\"\nfrom = 0.1\nto = 0.3\npoints = 100000\n");
  const auto [status, output] =
      shell("timeout --foreground --signal=INT 0.3 $rotor sweep s.toml --out r.csv");
  EXPECT_NE(output.find("the same command goes on there"), std::string::npos) << output;
  EXPECT_FALSE(fs::exists(folder_ / "r.csv"));
  EXPECT_TRUE(fs::exists(folder_ / "r.csv.journal"));
}

TEST_F(SweepCommand, SaysInItsHeadWhatItIs) {
  const std::string axis = "[[axis]]\nquantity = \"until\"\nvalues = [1e-3]\n";
  write("s.toml", axis);
  ASSERT_EQ(rotor("sweep s.toml --out r.csv").status, 0);
  EXPECT_TRUE(content("r.csv").starts_with("# Sweep\n# rotor ")) << content("r.csv");
  for (const char* line :
       {"\n# 1 points,", "\n#   [[axis]]\n#   quantity = \"until\"\n#   values = [1e-3]\n"})
    EXPECT_NE(content("r.csv").find(line), std::string::npos) << content("r.csv");
  write("s.toml", "title = \"How short\"\n" + axis);
  ASSERT_EQ(rotor("sweep s.toml --out r.csv").status, 0);
  EXPECT_TRUE(content("r.csv").starts_with("# Sweep: How short\n# rotor ")) << content("r.csv");
}

// A zero that nobody is sure of has no digit: the cell is empty, as that of what there is not.
TEST_F(SweepCommand, LeavesACellWithoutASureDigitEmpty) {
  const auto rows = swept(
      "columns = [\"final_q1_m\", \"final_speed_Hz\"]\n[parameters]\n"
      "eccentricity = 0\ngravity = 0\nno_separation = true\nuntil = 0.1\ndigits = 3\n"
      "[[axis]]\nquantity = \"torque\"\nvalues = [0.3]\n");
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["final_q1_m"], "");
  EXPECT_GT(rows[0].number("final_speed_Hz"), 0);
}

// Whether the motor of a rotor at rest is on at a limit of 0 Hz, no precision tells.
TEST_F(SweepCommand, TellsWhatARowLacks) {
  const auto rows = swept(
      "[parameters]\nmotor_off_hz = 0\nseparation_time = 0\nuntil = 0.01\ndigits = 5\n"
      "[[axis]]\nquantity = \"friction\"\nvalues = [0.1]\n");
  ASSERT_EQ(rows.size(), 1U);
  const std::string refusal(rows[0]["refusal"]);
  EXPECT_TRUE(refusal.starts_with("counts and outcome hang on digits that are not there"))
      << refusal;
  EXPECT_EQ(rows[0]["max_displacement_m"], "");
  const auto [status, output] =
      rotor("run --motor-off-hz 0 --separation-time 0 --until 0.01 --digits 5 2>&1 >/dev/null");
  EXPECT_NE(output.find(": " + refusal + "\n"), std::string::npos) << output;
}

TEST_F(SweepCommand, SaysBeforehandHowLongItTakes) {
  write("s.toml", "[[axis]]\nquantity = \"friction\"\nfrom = 0.1\nto = 0.3\npoints = 50\n");
  const auto [status, output] = rotor("sweep s.toml --dry-run");
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(output.starts_with("50 points; 50 of them took ")) << output;
  EXPECT_EQ(files(), 1);
  // Said with three digits: what each takes, times the points, over the jobs.
  const auto start = std::chrono::steady_clock::now();
  const auto [status_of_3, said] = rotor("sweep s.toml --dry-run --jobs 3");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  double each_ms = 0, all_s = 0;
  ASSERT_EQ(std::sscanf(said.c_str(), "50 points; 50 of them took %lf ms each: about %lf s with 3",
                        &each_ms, &all_s),
            2)
      << said;
  EXPECT_NEAR(all_s / (each_ms / 1000 * 50 / 3), 1, 0.01);
  EXPECT_LT(each_ms / 1000 * 50, took.count() * 1.01);  // which is what they took, one by one
}

// After some seconds it has tried enough.
TEST_F(SweepCommand, SaysBeforehandHowLongSlowPointsTake) {
  write("s.toml",
        "stop_on = \"end\"\n[parameters]\ntolerance = 1e-14\nuntil = 1500\nno_separation = true\n"
        "[[axis]]\nquantity = \"friction\"\nfrom = 0.1\nto = 0.3\npoints = 1000\n");
  const auto start = std::chrono::steady_clock::now();
  const std::string said = rotor("sweep s.toml --dry-run --jobs 3").output;
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  int tried = 0;
  double each_ms = 0, all_s = 0;
  ASSERT_EQ(
      std::sscanf(said.c_str(), "1000 points; %d of them took %lf ms each: about %lf s with 3",
                  &tried, &each_ms, &all_s),
      3)
      << said;
  EXPECT_LT(tried, 50);
  EXPECT_NEAR(each_ms / 1000 * tried / took.count(), 1, 0.1);
  EXPECT_NEAR(all_s / (each_ms / 1000 * 1000 / 3), 1, 0.01);
}

// Each row has the digits that a run of its own prints; where a run ends must not hang on steps.
TEST_F(SweepCommand, GivesTheDigitsThatAreAskedFor) {
  const auto rows = swept(
      "[parameters]\nstart_speed_hz = 150\nuntil = 0.01\ndigits = 6\n"
      "[[axis]]\nquantity = \"friction\"\nvalues = [0.1, 0.3]\n");
  ASSERT_EQ(rows.size(), 2U);
  for (const CsvRow& row : rows) {
    EXPECT_EQ(row["refusal"], "");
    const std::string run = rotor("run --start-speed-hz 150 --until 0.01 --digits 6 --friction " +
                                  row["friction"] + " 2>messages")
                                .output;
    for (const char* key : {"first_contact_s", "peak_normal_force_N", "final_q2_m"})
      EXPECT_NE(run.find(fmt::format("{:<24} {}\n", key, row[key])), std::string::npos)
          << key << ' ' << row[key];
  }
}

}  // namespace
}  // namespace rotor
