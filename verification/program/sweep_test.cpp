/// `rotor sweep`: its rows, and that it resumes where it was killed.
#include "figures/sweep/sweep.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <thread>
#include <utility>

#include "figures/data/read_csv.hpp"
#include "figures/results/json.hpp"
#include "figures/results/section_result.hpp"
#include "figures/sweep/journal.hpp"
#include "figures/sweep/sweep_row.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/damage.hpp"
#include "verification/support/pattern.hpp"
#include "verification/support/random_runs.hpp"

namespace rotor {
namespace {

/// A sweep over all kinds of inputs, with stalls, refusals and contacts before the loss.
const char* const mixed = R"(
title = "mixed"
columns = "all"
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
quantity = "mass_loss_speed_Hz"
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

  /// Edits results by sed as if they had been computed so: with the check sum, which gzip computes.
  void edit(const std::string& name, const std::string& commands) const {
    const Outcome edited =
        shell(fmt::format("sed -i -e '$d' {1} {0} && sum=$(gzip -c {0} | tail -c 8 | od "
                          "--endian=little -An -tu4 -N4) "
                          "&& echo '# crc32 of the lines above:' $sum >>{0}",
                          name, commands));
    EXPECT_EQ(edited.status, 0) << edited.output;
  }
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
    std::string options = "--tolerance 1e-7";
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
      if (value.is_object() || key == "version" || key == "schema" || key.starts_with("stop_"))
        continue;
      EXPECT_EQ(row[key], cell_of(value)) << key << ' ' << options;
    }
  }
  EXPECT_GT(refused, 2);
  EXPECT_LT(refused, 40);
  EXPECT_GE(outcomes.size(), 3U);
}

/// How far a run is followed.
struct Followed : Observer {
  bool should_continue(const Progress& now) override {
    until_s = now.time_s;
    return true;
  }
  double until_s = 0;
};

// Random columns of random rotors, and all: whatever ends the run early for their sake.
TEST(SweepRows, HaveInEachColumnWhatTheWholeRunGives) {
  RandomRuns runs(41);
  std::mt19937 random(1);
  const std::vector<std::string> all = result_columns(true);
  std::set<std::string> empty(all.begin(), all.end());
  for (int n = 0; n < 150; ++n) {
    const RandomInputs::Rotor rotor = runs.rotor();
    SCOPED_TRACE(options_of(rotor.stated));
    Json expected;
    Sweep sweep{.title = {}, .text = {}, .base = rotor.stated, .axes = {}, .sample = {}};
    try {
      std::optional<Section> section;
      ObserverGroup observers;
      try {
        observers.add(section.emplace(rotor.scenario, 12, [](auto) {}));
        sweep.section_turns = 12;
      } catch (const ScenarioError&) {  // as it has no turns
      }
      expected = to_json(
          complete_run(RunUpCheckpoint(rotor.scenario), rotor.scenario, std::nullopt, observers));
      if (section) expected.update(to_json(section->summary()));
    } catch (const std::runtime_error&) {  // a refusal, which other tests compare
      continue;
    }
    const std::vector<std::string> with = result_columns(sweep.section_turns.has_value());
    for (int k = 0; k < 4; ++k) {
      sweep.columns = with;
      if (k > 0) {
        std::shuffle(sweep.columns.begin(), sweep.columns.end(), random);
        sweep.columns.resize(1 + random() % 3);
      }
      const std::string line = SweepRows(sweep)(0);
      const std::vector<std::string> cells = csv_cells(PointLine(line).row);
      ASSERT_EQ(cells.size(), sweep.columns.size() + 1);
      EXPECT_EQ(cells.back(), "");
      for (std::size_t i = 0; i < sweep.columns.size(); ++i) {
        const std::string& column = sweep.columns[i];
        if (!cells[i].empty()) empty.erase(column);
        EXPECT_EQ(cells[i], cell_of(expected.at(column))) << column;
      }
    }
  }
  EXPECT_EQ(empty, std::set<std::string>());
}

// The paper's accident: its outcome is known at the first maximum in rolling, its largest force at
// the end; of a rotor that stays clear, both are known at the mass loss.
TEST(SweepRows, RunNoFurtherThanTheirColumnsNeed) {
  struct Case {
    std::vector<std::string> columns;
    double rolls_until_s, clear_until_s;
  };
  for (const auto& [columns, rolls_until_s, clear_until_s] :
       {Case{{"outcome", "peak_force_to_rolling_N"}, 29.14, 14.152},
        Case{{"touch_downs"}, 29.2, 14.152}, Case{{"peak_displacement_m"}, 29.2, 29.2},
        Case{{"final_time_s"}, 29.2, 29.2}})
    for (const bool rolls : {true, false}) {
      Scenario scenario;
      scenario.until = 29.2;
      if (!rolls) scenario.parameters.mass_loss_time = 14.15;
      Followed followed;
      const RunResult result =
          complete_run_for(columns, RunUpCheckpoint(scenario), scenario, followed);
      EXPECT_EQ(result.summary.outcome, rolls ? Outcome::rolling : Outcome::no_contact);
      EXPECT_NEAR(followed.until_s, rolls ? rolls_until_s : clear_until_s, 0.01) << columns[0];
    }
}

// Without stiffness the supports do not vibrate, as the closed forms assume.
TEST_F(SweepCommand, LeavesOutWhatALawDoesNotSay) {
  for (const std::string parameters : {"start_speed_Hz = 150\n", "no_mass_loss = true\n"}) {
    write(
        "s.toml",
        "columns = [\"outcome\", \"law_contact\", \"law_reach_m\"]\n[parameters]\nuntil = 1e-3\n" +
            parameters + "[[axis]]\nquantity = \"support_stiffness\"\nvalues = [0, 9e4]\n");
    EXPECT_EQ(rotor("sweep s.toml --force --out r.csv").status, 0);
    const auto rows = results("r.csv");
    ASSERT_EQ(rows.size(), 2U);
    for (const CsvRow& row : rows) {
      EXPECT_NE(row["outcome"], "");
      EXPECT_EQ(row["refusal"], "");
      for (const char* law : {"law_contact", "law_reach_m"})
        EXPECT_EQ(row[law].empty(), &row == &rows[0] || parameters[0] == 'n') << law;
    }
  }
}

// A row that is kept is not computed again: its marks remain.
TEST_F(SweepCommand, IsComparedWithAnotherWhateverItsRemarksSay) {
  write("m.toml",
        "[parameters]\nequations = \"corrected\"\nstart_speed_Hz = 150\nuntil = 0.01\ntolerance = "
        "1e-8\n"
        "[[axis]]\nquantity = \"support_stiffness\"\nvalues = [1e3, 15e2]\n");
  EXPECT_EQ(
      shell("\"" ROTOR_SOURCES "/figures/maps/tolerance.sh\" \"" ROTOR_BUILD "\" m.toml .").output,
      "tolerance 10^{-8}; at 10^{-11}, 0 % of 2 points have another outcome\n");
  EXPECT_TRUE(has(content("m-some-1e-8.csv"), ", which is not modelled\""));
}

TEST_F(SweepCommand, RetriesRefusedPointsOnly) {
  write("s.toml",
        "columns = [\"outcome\"]\n[parameters]\nequations = \"published\"\nstart_speed_Hz = 150\n"
        "until = 0.01\n[[axis]]\nquantity = \"friction\"\nvalues = [0.1, 0.2, 0.3]\n");
  expect_refusal("sweep s.toml --retry", "--retry: s.csv: there are no results yet");
  ASSERT_EQ(rotor("sweep s.toml").status, 0);
  const std::string whole = content("s.csv");
  edit("s.csv", "");
  EXPECT_EQ(content("s.csv"), whole);
  edit("s.csv", "-e '/^0.1,/s/bouncing/freed/' -e '/^0.2,/s/bouncing,$/,lost/'");
  const auto [status, output] = rotor("sweep s.toml --retry");
  EXPECT_EQ(status, 0) << output;
  EXPECT_TRUE(has(output, "rotor: 2 rows of s.csv are kept\n"));
  for (const CsvRow& row : results("s.csv"))
    EXPECT_EQ(row["outcome"], row["friction"] == "0.1" ? "freed" : "bouncing");
}

// Nothing is taken from them.
TEST_F(SweepCommand, TrustsNoRowOfDamagedResults) {
  write("s.toml",
        "columns = [\"outcome\", \"peak_normal_force_N\"]\n[parameters]\n"
        "equations = \"published\"\nstart_speed_Hz = 150\nuntil = 0.01\n[[axis]]\nquantity = "
        "\"friction\"\nvalues = [0.1, 0.2, 0.3]\n");
  ASSERT_EQ(rotor("sweep s.toml --out r.csv").status, 0);
  const std::string whole = content("r.csv"), last = whole.substr(whole.rfind('#'));
  std::vector<std::string> all = {whole.substr(0, whole.size() - last.size()),
                                  whole.substr(0, whole.size() - 1), whole + last, whole + "more"};
  std::mt19937 random(1);
  for (int kind = 0; kind < kinds_of_damage; ++kind)
    all.push_back(damaged(whole, starts_of_rows(whole), random() % 3, kind, random));
  for (const std::string& results : all) {
    ASSERT_NE(results, whole);
    SCOPED_TRACE(results);
    write("r.csv", results);
    expect_refusal("sweep s.toml --out r.csv",
                   "r.csv: is damaged or cut: its last line is not the check sum");
    EXPECT_TRUE(content("r.csv") == results);
    const auto [status, output] = rotor("sweep s.toml --out r.csv --retry");
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(has(output, "; all its points are computed anew\n"));
    EXPECT_TRUE(content("r.csv") == whole);
  }
}

// Those of another file or version are replaced on request.
TEST_F(SweepCommand, RepeatsNothingUnlessForced) {
  const std::string text =
      "columns = [\"outcome\"]\n[parameters]\nstart_speed_Hz = 150\nuntil = 0.01\n[[axis]]\n"
      "quantity = \"friction\"\nvalues = [0.1, 0.2]\n";
  write("s.toml", text);
  ASSERT_EQ(rotor("sweep s.toml").status, 0);
  const std::string whole = content("s.csv");
  edit("s.csv", "-e s/bouncing/freed/");
  const std::string marked = content("s.csv");
  const auto [status, output] = rotor("sweep s.toml");
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(has(output, "s.csv has all points of this sweep, 0 of them refused"));
  EXPECT_EQ(content("s.csv"), marked);
  EXPECT_EQ(rotor("sweep s.toml --force").status, 0);
  EXPECT_EQ(content("s.csv"), whole);
  write("s.csv", marked);
  write("s.toml", "# another\n" + text);
  expect_refusal("sweep s.toml", "s.csv: is of another sweep file, part or version of rotor");
  EXPECT_EQ(content("s.csv"), marked);
  EXPECT_EQ(rotor("sweep s.toml --force").status, 0);
  EXPECT_FALSE(has(content("s.csv"), "freed"));
}

TEST_F(SweepCommand, FailsIfNoPointHasAResult) {
  const auto sweep = [this](const char* torques) {
    write("s.toml", fmt::format("[parameters]\nmass_loss_speed_Hz = 150\nuntil = 1\n[[axis]]\n"
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

// Killed or interrupted at up to forty instants, its journal damaged each time. No row before the
// damage is computed twice.
TEST_F(SweepCommand, GoesOnWhereItWasKilled) {
  write(
      "s.toml",
      "[parameters]\ntolerance = 1e-6\nuntil = 29.4\n[sample]\ncount = 6000\nmethod = \"random\"\n"
      "[[sample.over]]\nquantity = \"friction\"\nlog_uniform = [0.05, 1]\n");
  EXPECT_EQ(rotor("sweep s.toml --out whole.csv --jobs 2").status, 0);
  const std::string whole = content("whole.csv");
  std::mt19937 random(1);
  std::size_t good = 0;  // rows, and the header row
  int kills = 0;
  for (; kills < 40 && !fs::exists(folder_ / "cut.csv"); ++kills) {
    shell(fmt::format(
        "timeout --foreground --signal={} {} $rotor sweep s.toml --out cut.csv --jobs 2",
        kills % 2 ? "INT" : "KILL", 0.03 + static_cast<double>(random() % 40) / 1000));
    const std::string journal = content("cut.csv.journal");
    const auto rows = starts_of_rows(journal);
    EXPECT_TRUE(rows.size() >= good || fs::exists(folder_ / "cut.csv")) << kills;
    good = rows.size();
    if (good < 6) continue;
    good -= 2 + random() % 4;
    write("cut.csv.journal", damaged(journal, rows, good, kills % kinds_of_damage, random));
  }
  EXPECT_GE(kills, 3);
  EXPECT_EQ(rotor("sweep s.toml --out cut.csv").status, 0);
  EXPECT_TRUE(content("cut.csv") == whole);
  EXPECT_EQ(files(), 3);
}

// Whatever has happened to a journal, power cuts included, the results are those of an undisturbed
// sweep; the rows before the damage are not computed again.
TEST_F(SweepCommand, MakesGoodWhatHasHappenedToItsJournal) {
  const Sweep sweep = this->sweep(
      "[parameters]\nstart_speed_Hz = 150\nuntil = 0.01\n[[axis]]\nquantity = \"friction\"\n"
      "from = 0.1\nto = 0.3\npoints = 40\n");
  ASSERT_EQ(rotor("sweep s.toml --out whole.csv").status, 0);
  const std::string whole = content("whole.csv");
  std::string journal;
  {
    Journal written(folder_ / "r.csv", heads_of(sweep), sweep.points());
    const auto rows = rows_of("whole.csv");
    for (std::size_t n = 1; n < rows.size(); ++n) written.write(rows[n]);
    journal = content("r.csv.journal");
  }
  const auto rows = starts_of_rows(journal);
  ASSERT_EQ(rows.size(), 41U);
  std::mt19937 random(1);
  for (int n = 0; n < 3 * kinds_of_damage; ++n) {
    const std::size_t row = random() % 40;
    const std::string now = damaged(journal, rows, row, n % kinds_of_damage, random);
    std::size_t good = 0;  // rows before the damage
    while (good < 40 && now.compare(0, rows[good + 1], journal, 0, rows[good + 1]) == 0) ++good;
    write("r.csv.journal", now);
    const auto [status, output] = rotor("sweep s.toml --out r.csv");
    SCOPED_TRACE(testing::Message() << n << " row " << row << output);
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(content("r.csv") == whole);
    const std::string there = fmt::format("{} of 40 points are already in", good),
                      dropped = fmt::format("the {} bytes after row {} are damaged or too many",
                                            now.size() - rows[good], good);
    EXPECT_EQ(output.find(there) != std::string::npos, good > 0);
    EXPECT_EQ(output.find(dropped) != std::string::npos, now.size() > rows[good]);
    EXPECT_EQ(files(), 3);
  }
  for (const std::size_t begun : {std::size_t{0}, std::size_t{1}, rows[0] - 1}) {
    write("r.csv.journal", journal.substr(0, begun));
    EXPECT_EQ(rotor("sweep s.toml --out r.csv 2>&-").status, 0);
    EXPECT_TRUE(content("r.csv") == whole) << begun;
  }
  // One descriptor is free, or none; a journal that cannot be read keeps its rows.
  for (const char* descriptors : {"5", "4", "3"}) {
    write("r.csv.journal", journal.substr(0, rows[20]));
    const auto [status, output] =
        shell(fmt::format("ulimit -n {}; $rotor sweep s.toml --out r.csv --jobs 1", descriptors));
    EXPECT_FALSE(has(output, "were dropped"));
    EXPECT_TRUE(status == 0 || content("r.csv.journal").starts_with(journal.substr(0, rows[20])));
  }
}

// One that finishes removes its journal, which others may have opened by then.
TEST_F(SweepCommand, LeavesTheJournalOfAnotherAlone) {
  const auto compete = [this] {
    for (int n = 0; n < 300; ++n) try {
        Journal journal(folder_ / "r.csv", {"head\n"}, 2);
        while (journal.rows() < 2) journal.write("row");
        EXPECT_TRUE(fs::exists(journal.path()));
        journal.write_results();
      } catch (const std::runtime_error& error) {
        EXPECT_TRUE(std::string_view(error.what()).ends_with("another sweep is writing it"))
            << error.what();
      }
  };
  std::vector<std::thread> others;
  for (int n = 0; n < 4; ++n) others.emplace_back(compete);
  for (std::thread& other : others) other.join();
  EXPECT_TRUE(content("r.csv").starts_with("head\nrow\nrow\n#"));
  EXPECT_EQ(files(), 1);
}

// From its last row to the results.
TEST_F(SweepCommand, FinishesNoJournalThatAnotherProgramHasChanged) {
  Journal journal(folder_ / "r.csv", {"head\n"}, 2);
  journal.write("first");
  journal.write("second");
  const std::string whole = content("r.csv.journal");
  std::mt19937 random(1);
  std::vector<std::string> all = {"", "he"};
  for (int kind = 0; kind < kinds_of_damage; ++kind)
    all.push_back(damaged(whole, starts_of_rows(whole), 1, kind, random));
  for (const std::string& changed : all) {
    write("r.csv.journal", changed);
    if (!changed.starts_with(whole)) {
      EXPECT_THROW(journal.write_results(), std::runtime_error) << changed;
      EXPECT_EQ(files(), 1);
    }
    EXPECT_TRUE(content("r.csv.journal") == changed);
  }
  write("r.csv.journal", whole);
  journal.write_results();
  EXPECT_TRUE(content("r.csv").starts_with("head\nfirst\nsecond\n#"));
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
  write("s.toml", "budget = 1e-8\n" + rest);
  rotor("sweep s.toml --out r.csv");
  EXPECT_TRUE(has(content("r.csv"), "a budget of 1e-08 s is not enough"));
  rotor("sweep s.toml --out r.csv --budget 1e-9 --force");
  EXPECT_TRUE(has(content("r.csv"), "a budget of 1e-09 s is not enough"));
}

// Each row has the digits that `rotor run` prints, or its refusal. No precision can decide whether
// the motor of a rotor at rest is on at a limit of 0 Hz.
TEST_F(SweepCommand, GivesTheDigitsThatAreAskedFor) {
  for (const std::string options :
       {"--start-speed-Hz 150 --until 0.01 --digits 6",
        "--motor-off-Hz 0 --mass-loss-time 0 --until 0.01 --digits 5"}) {
    std::string keys = replaced(options.substr(2) + '\n', " --", "\n");
    keys = replaced(replaced(keys, " ", " = "), "-", "_");
    write("s.toml", "columns = \"all\"\n[parameters]\n" + keys +
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
