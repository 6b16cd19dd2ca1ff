/// `rotor sweep`: its rows, and that it resumes where it was killed.
#include "figures/sweep/sweep.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <thread>
#include <utility>

#include "figures/results/json.hpp"
#include "figures/sweep/journal.hpp"
#include "figures/sweep/sweep_row.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/pattern.hpp"
#include "verification/support/read_csv.hpp"

namespace rotor {
namespace {

/// A sweep over all kinds of inputs, with stalls, refusals and contacts before the loss.
const char* const mixed = R"(
title = "mixed"
[parameters]
tolerance = 1e-7
[[axis]]
quantity = "equations"
values = ["published", "corrected"]
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
count = 4
seed = 3
[[sample.over]]
quantity = "mass_loss_speed_hz"
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
};

// Points of many kinds: each row agrees with `rotor run`.
TEST_F(SweepCommand, SaysOfEachPointWhatARunOfItsOwnSays) {
  const Sweep sweep = this->sweep(mixed);
  ASSERT_EQ(rotor("sweep s.toml --out r.csv").status, 0);
  const auto rows = results("r.csv");
  ASSERT_EQ(static_cast<long>(rows.size()), sweep.points());
  ASSERT_EQ(rows.size(), 48U);
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
    const auto summary = Json::parse(run.output);
    for (const auto& [key, value] : summary.items()) {
      if (value.is_structured() || key == "version" || key == "schema") continue;
      const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
      EXPECT_EQ(row[key], value.is_null() ? "" : text) << key << ' ' << options;
    }
  }
  EXPECT_GT(refused, 2);
  EXPECT_LT(refused, 40);
  EXPECT_GE(outcomes.size(), 3U);
}

// The same cells as in whole rows, followed by a refusal. Maxima that no column shows are not
// located.
TEST_F(SweepCommand, WritesTheColumnsThatItIsAskedFor) {
  const std::string axis = "[[axis]]\nquantity = \"start_speed_hz\"\nvalues = [10, 150]\n";
  write("whole.toml", "[parameters]\nclearance = 1e-3\n" + axis);
  write("part.toml",
        "columns = [\"touch_downs\", \"outcome\", \"peak_force_to_rolling_N\", "
        "\"right_hand_sides\"]\n" +
            content("whole.toml"));
  ASSERT_EQ(rotor("sweep whole.toml --out whole.csv").status, 0);
  ASSERT_EQ(rotor("sweep part.toml --out part.csv").status, 0);
  EXPECT_EQ(rows_of("part.csv").at(0),
            "start_speed_hz,touch_downs,outcome,peak_force_to_rolling_N,right_hand_sides,remarks,"
            "refusal");
  const auto whole = results("whole.csv"), part = results("part.csv");
  ASSERT_EQ(part.size(), 2U);
  for (std::size_t n = 0; n < part.size(); ++n)
    for (const char* column :
         {"start_speed_hz", "touch_downs", "outcome", "peak_force_to_rolling_N", "refusal"})
      EXPECT_EQ(part[n][column], whole[n][column]) << column;
  EXPECT_NE(part[0]["refusal"], "");
  EXPECT_EQ(part[1]["outcome"], "rolling");
  EXPECT_LT(std::stol(part[1]["right_hand_sides"]), std::stol(whole[1]["right_hand_sides"]));
}

// Without stiffness the supports do not vibrate, as the closed forms assume.
TEST_F(SweepCommand, LeavesOutWhatALawDoesNotSay) {
  for (const std::string parameters : {"start_speed_hz = 150\n", "no_mass_loss = true\n"}) {
    write("s.toml", "columns = [\"outcome\", \"law_reach_m\"]\n[parameters]\nuntil = 1e-3\n" +
                        parameters +
                        "[[axis]]\nquantity = \"support_stiffness\"\nvalues = [0, 9e4]\n");
    EXPECT_EQ(rotor("sweep s.toml --force --out r.csv").status, 0);
    const auto rows = results("r.csv");
    ASSERT_EQ(rows.size(), 2U);
    for (const CsvRow& row : rows) {
      EXPECT_NE(row["outcome"], "");
      EXPECT_EQ(row["refusal"], "");
      EXPECT_EQ(row["law_reach_m"].empty(), &row == &rows[0] || parameters[0] == 'n');
    }
  }
}

// A row that is kept is not computed again: its marks remain.
TEST_F(SweepCommand, IsComparedWithAnotherWhateverItsRemarksSay) {
  write("m.toml",
        "[parameters]\nequations = \"corrected\"\nstart_speed_hz = 150\nuntil = 0.01\ntolerance = "
        "1e-8\n"
        "[[axis]]\nquantity = \"support_stiffness\"\nvalues = [1e3, 15e2]\n");
  EXPECT_EQ(shell("\"" ROTOR_SOURCES "/figures/maps/tolerance.sh\" $rotor m.toml .").output,
            "tolerance 10^{-8}; at 10^{-11}, 0 % of 2 points have another outcome\n");
  EXPECT_TRUE(has(content("m-some-1e-8.csv"), ", which is not modelled\""));
}

TEST_F(SweepCommand, RetriesRefusedPointsOnly) {
  write("s.toml",
        "columns = [\"outcome\"]\n[parameters]\nstart_speed_hz = 150\nuntil = 0.01\n[[axis]]\n"
        "quantity = \"friction\"\nvalues = [0.1, 0.2, 0.3]\n");
  expect_refusal("sweep s.toml --retry", "--retry: s.csv: there are no results yet");
  ASSERT_EQ(rotor("sweep s.toml").status, 0);
  shell(
      "sed -i -e '/^0.1,/s/bouncing/freed/' -e '/^0.2,/s/bouncing,,$/,,lost/' -e 's/^0.3/0.4/' "
      "s.csv");
  const auto [status, output] = rotor("sweep s.toml --retry");
  EXPECT_EQ(status, 0) << output;
  EXPECT_TRUE(has(output, "rotor: 1 rows of s.csv are kept\n"));
  for (const CsvRow& row : results("s.csv"))
    EXPECT_EQ(row["outcome"], row["friction"] == "0.1" ? "freed" : "bouncing");
}

// Those of another file or version are replaced on request.
TEST_F(SweepCommand, RepeatsNothingUnlessForced) {
  const std::string text =
      "columns = [\"outcome\"]\n[parameters]\nstart_speed_hz = 150\nuntil = 0.01\n[[axis]]\n"
      "quantity = \"friction\"\nvalues = [0.1, 0.2]\n";
  write("s.toml", text);
  ASSERT_EQ(rotor("sweep s.toml").status, 0);
  const std::string whole = content("s.csv");
  shell("sed -i s/bouncing/freed/ s.csv");
  const std::string marked = content("s.csv");
  const auto [status, output] = rotor("sweep s.toml");
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(has(output, "s.csv has all points of this sweep, 0 of them refused"));
  EXPECT_EQ(content("s.csv"), marked);
  EXPECT_EQ(rotor("sweep s.toml --force").status, 0);
  EXPECT_EQ(content("s.csv"), whole);
  write("s.csv", marked);
  write("s.toml", "# another\n" + text);
  expect_refusal("sweep s.toml", "s.csv: is of another sweep file or version of rotor");
  EXPECT_EQ(content("s.csv"), marked);
  EXPECT_EQ(rotor("sweep s.toml --force").status, 0);
  EXPECT_FALSE(has(content("s.csv"), "freed"));
}

TEST_F(SweepCommand, FailsIfNoPointHasAResult) {
  const auto sweep = [this](const char* torques) {
    write("s.toml", fmt::format("[parameters]\nmass_loss_speed_hz = 150\nuntil = 1\n[[axis]]\n"
                                "quantity = \"torque\"\nvalues = [{}]\n",
                                torques));
    return rotor("sweep s.toml --force");
  };
  EXPECT_EQ(sweep("0.1, 100").status, 0);
  const auto [status, output] = sweep("0.1, 0.2");
  EXPECT_EQ(status, 1);
  EXPECT_TRUE(has(output, "s.csv: no point has a result"));
  EXPECT_EQ(results("s.csv").size(), 2U);
  EXPECT_EQ(rotor("sweep s.toml").status, 1);  // repeated
}

TEST_F(SweepCommand, WritesTheSameBytesWhateverTheNumberOfThreads) {
  write("s.toml", mixed);
  for (const char* jobs : {"1", "2", "5"}) {
    ASSERT_EQ(rotor(fmt::format("sweep s.toml --out {0}.csv --jobs {0}", jobs)).status, 0);
    EXPECT_TRUE(content(fmt::format("{}.csv", jobs)) == content("1.csv")) << jobs;
  }
  EXPECT_EQ(files(), 4);
}

// Killed or interrupted at up to twenty instants. No row is computed twice.
TEST_F(SweepCommand, GoesOnWhereItWasKilled) {
  write(
      "s.toml",
      "[parameters]\ntolerance = 1e-6\nuntil = 29.4\n[sample]\ncount = 3000\nmethod = \"random\"\n"
      "[[sample.over]]\nquantity = \"friction\"\nlog_uniform = [0.05, 1]\n");
  EXPECT_EQ(rotor("sweep s.toml --out whole.csv --jobs 2").status, 0);
  const std::string whole = content("whole.csv");
  std::mt19937 random(1);
  std::ptrdiff_t last = 0;
  int kills = 0;
  for (; kills < 20 && !fs::exists(folder_ / "cut.csv"); ++kills) {
    shell(fmt::format(
        "timeout --foreground --signal={} {} $rotor sweep s.toml --out cut.csv --jobs 2",
        kills % 2 ? "INT" : "KILL", 0.03 + static_cast<double>(random() % 60) / 1000));
    const std::string journal = content("cut.csv.journal");
    const auto now = std::ranges::count(journal, '\n');  // rows
    EXPECT_TRUE(now >= std::exchange(last, now) || fs::exists(folder_ / "cut.csv")) << kills;
    if (kills == 3 && now > 0) write("cut.csv.journal", journal + "0.07,rol");  // torn
  }
  EXPECT_GE(kills, 3);
  EXPECT_EQ(rotor("sweep s.toml --out cut.csv").status, 0);
  EXPECT_TRUE(content("cut.csv") == whole);
  EXPECT_EQ(files(), 3);
}

// Whatever has happened to a journal, power cuts included, the results are those of an undisturbed
// sweep; the rows before the damage are not computed again.
TEST_F(SweepCommand, MakesGoodWhatHasHappenedToItsJournal) {
  const std::string head = sweep_head(
      sweep("[parameters]\nstart_speed_hz = 150\nuntil = 1e-3\n[[axis]]\nquantity = \"friction\"\n"
            "from = 0.1\nto = 0.3\npoints = 40\n"));
  ASSERT_EQ(rotor("sweep s.toml --out whole.csv").status, 0);
  const std::string whole = content("whole.csv");
  std::vector<std::size_t> rows = {head.size()};  // starts of the rows, and the end of the last one
  while (rows.back() < whole.size()) rows.push_back(whole.find('\n', rows.back()) + 1);
  ASSERT_EQ(rows.size(), 41U);
  std::mt19937 random(1);
  const auto below = [&](std::size_t n) { return random() % n; };
  for (int n = 0; n < 20; ++n) {
    const std::size_t row = below(40), other = below(40), at = rows[row];
    std::string damaged = whole;
    switch (n % 4) {
      case 0:  // a row is lost
        damaged.erase(at, rows[row + 1] - at);
        break;
      case 1:  // a row is there twice, or in another place
        damaged.insert(at, whole, rows[other], rows[other + 1] - rows[other]);
        break;
      case 2:  // as power cuts leave it
        std::fill_n(&damaged[at + 1], 1 + below(rows[row + 1] - at - 1), '\0');
        break;
      default:
        damaged.resize(at + below(rows[row + 1] - at));
    }
    std::size_t good = 0;  // rows before the damage
    while (good < 40 && damaged.compare(0, rows[good + 1], whole, 0, rows[good + 1]) == 0) ++good;
    write("r.csv.journal", damaged);
    const auto [status, output] = rotor("sweep s.toml --out r.csv");
    SCOPED_TRACE(testing::Message() << n << " row " << row << output);
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(content("r.csv") == whole);
    const std::string there = fmt::format("{} of 40 points are already in", good);
    EXPECT_EQ(output.find(there) != std::string::npos, good > 0);
    EXPECT_EQ(output.find("were dropped") != std::string::npos, damaged.size() > rows[good]);
    EXPECT_EQ(files(), 3);
  }
  for (const std::size_t begun : {std::size_t{0}, std::size_t{1}, head.size() - 1}) {
    write("r.csv.journal", head.substr(0, begun));
    EXPECT_EQ(rotor("sweep s.toml --out r.csv 2>&-").status, 0);
    EXPECT_TRUE(content("r.csv") == whole) << begun;
  }
  // One descriptor is free, or none; a journal that cannot be read keeps its rows.
  for (const char* descriptors : {"5", "4", "3"}) {
    write("r.csv.journal", whole.substr(0, rows[20]));
    const auto [status, output] =
        shell(fmt::format("ulimit -n {}; $rotor sweep s.toml --out r.csv --jobs 1", descriptors));
    EXPECT_FALSE(has(output, "were dropped"));
    EXPECT_TRUE(status == 0 || content("r.csv.journal").starts_with(whole.substr(0, rows[20])));
  }
}

// One that finishes removes its journal, which others may have opened by then.
TEST_F(SweepCommand, LeavesTheJournalOfAnotherAlone) {
  const auto compete = [this] {
    for (int n = 0; n < 300; ++n) try {
        Journal journal(folder_ / "r.csv", "head\n", 2, [](long, auto) { return true; });
        while (journal.rows() < 2) journal.write("row\n");
        EXPECT_TRUE(fs::exists(journal.path()));
        journal.finish();
      } catch (const std::runtime_error& error) {
        EXPECT_TRUE(std::string_view(error.what()).ends_with("another sweep is writing it"))
            << error.what();
      }
  };
  std::vector<std::thread> others;
  for (int n = 0; n < 4; ++n) others.emplace_back(compete);
  for (std::thread& other : others) other.join();
  EXPECT_EQ(content("r.csv"), "head\nrow\nrow\n");
  EXPECT_EQ(files(), 1);
}

TEST_F(SweepCommand, RefusesAJournalOfAnotherSweepAndOneThatIsBeingWritten) {
  write("s.toml", mixed);
  write("r.csv", "old");
  write("r.csv.journal", "# Sweep: another\n");
  ASSERT_EQ(shell("mkfifo pipe.csv.journal").status, 0);
  expect_refusal("sweep s.toml --out pipe.csv", "pipe.csv.journal: must be a regular file");
  expect_refusal("sweep s.toml --out r.csv --force", "r.csv.journal: is of another sweep file");
  EXPECT_EQ(content("r.csv.journal"), "# Sweep: another\n");
  EXPECT_EQ(content("r.csv"), "old");
  for (const char* lock : {"flock", "flock --shared"}) {
    const std::string output =
        shell(fmt::format("{} r.csv.journal $rotor sweep s.toml --force --out r.csv", lock)).output;
    EXPECT_TRUE(has(output, "another sweep is writing it"));
    EXPECT_EQ(content("r.csv"), "old");
  }
}

// The budget of the file, or instead of it that of the option.
TEST_F(SweepCommand, RefusesAPointThatTakesLongerThanItsBudget) {
  const std::string rest =
      "[parameters]\ndigits = 12\n[[axis]]\nquantity = \"friction\"\nvalues = [0.08]\n";
  write("s.toml", "stop_on = \"end\"\nbudget = 1e-8\n" + rest);
  rotor("sweep s.toml --out r.csv");
  EXPECT_TRUE(has(content("r.csv"), "a budget of 1e-08 s is not enough"));
  rotor("sweep s.toml --out r.csv --budget 1e-9 --force");
  EXPECT_TRUE(has(content("r.csv"), "a budget of 1e-09 s is not enough"));
}

// Each row has the digits that `rotor run` prints, or its refusal. No precision can decide whether
// the motor of a rotor at rest is on at a limit of 0 Hz.
TEST_F(SweepCommand, GivesTheDigitsThatAreAskedFor) {
  for (const std::string options :
       {"--start-speed-hz 150 --until 0.01 --digits 6",
        "--motor-off-hz 0 --mass-loss-time 0 --until 0.01 --digits 5"}) {
    std::string keys = replaced(options.substr(2) + '\n', " --", "\n");
    keys = replaced(replaced(keys, " ", " = "), "-", "_");
    write("s.toml", "stop_on = \"end\"\n[parameters]\n" + keys +
                        "[[axis]]\nquantity = \"friction\"\nvalues = [0.1]\n");
    const int all_refused = rotor("sweep s.toml --force --out r.csv").status;
    const CsvRow row = results("r.csv").at(0);
    const auto [status, run] = rotor("run --friction 0.1 " + options);
    EXPECT_EQ(all_refused == 0, status == 0);
    for (const char* key : {"first_contact_s", "peak_normal_force_N", "final_q2_m"})
      EXPECT_TRUE(row[key].empty() ||
                  run.find(fmt::format("{:<32} {}\n", key, row[key])) != std::string::npos)
          << run;
    EXPECT_EQ(row["refusal"].empty(), status == 0);
    EXPECT_TRUE(has(run, row["refusal"]));
  }
}

}  // namespace
}  // namespace rotor
