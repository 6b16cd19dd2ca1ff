/// Parts of a sweep: that they are joined to what one sweep gives, or not at all.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

#include "figures/sweep/join.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/content.hpp"
#include "verification/support/damage.hpp"
#include "verification/support/pattern.hpp"

namespace rotor {
namespace {

class Parts : public CommandLine {
 protected:
  /// 24 points of axes and a sample, some of them refused.
  void write_sweep() const {
    write("s.toml",
          "[parameters]\nuntil = 0.01\n[[axis]]\nquantity = \"start_speed_Hz\"\nvalues = [0.1, 60, "
          "150]\n[[axis]]\nquantity = \"friction\"\nvalues = [0.1, 0.2]\n[sample]\ncount = 4\n"
          "[[sample.over]]\nquantity = \"support_damping\"\nuniform = [20, 30]\n");
  }
  void compute(int parts) const {
    for (int n = 1; n <= parts; ++n)
      ASSERT_EQ(rotor(fmt::format("sweep s.toml --part {}/{} --jobs 1", n, parts)).status, 0) << n;
  }
};

TEST(Part, HasPointsThatNoOtherHas) {
  for (long of : {1L, 2L, 7L, 64L, Part::most})
    for (long all : {of, of + 1, 3 * of - 1, 12345L}) {
      std::vector<int> found(static_cast<std::size_t>(all));
      for (Part part{1, of}; part.number <= of; ++part.number) {
        EXPECT_GT(part.points(all), 0);
        EXPECT_LE(std::abs(part.points(all) - all / of), 1);
        for (long row = 0, before = -1; row < part.points(all); ++row) {
          const long point = part.point(row);
          ASSERT_LT(point, all);
          EXPECT_GT(point, before);  // joining reads each part from its beginning to its end
          EXPECT_EQ(Part::with(point, of), part.number);
          ++found[static_cast<std::size_t>(point)];
          before = point;
        }
      }
      EXPECT_EQ(found, std::vector<int>(found.size(), 1));
    }
}

// Of grids whose points take the longer, the further they are along one axis or both: whatever the
// number of columns has in common with the number of parts. The allowed deviation is five times the
// standard error of the mean of as many independent points.
TEST(Part, TakesAsLongAsAnyOther) {
  constexpr long rows = 120;
  for (long of : {2L, 3L, 8L, 20L, 32L})
    for (long columns = 8; columns <= 70; ++columns) {
      const long all = rows * columns;
      for (const auto& [of_row, of_column] : {std::pair(0., 1.), {1., 0.}, {1., 1.}}) {
        const auto time = [&, a = of_row, b = of_column](long point) {
          return a * static_cast<double>(point / columns) / rows +
                 b * static_cast<double>(point % columns) / static_cast<double>(columns);
        };
        double whole = 0, squares = 0;
        for (long point = 0; point < all; ++point) {
          whole += time(point);
          squares += time(point) * time(point);
        }
        const double mean = whole / static_cast<double>(all),
                     variance = squares / static_cast<double>(all) - mean * mean;
        for (Part part{1, of}; part.number <= of; ++part.number) {
          const long points = part.points(all);
          double its = 0;
          for (long row = 0; row < points; ++row) its += time(part.point(row));
          EXPECT_NEAR(its / static_cast<double>(points), mean,
                      5 * std::sqrt(variance / static_cast<double>(points)))
              << part.number << " of " << of << ", " << columns << " columns";
        }
      }
    }
}

TEST_F(Parts, AreJoinedToOneSweepAlsoAfterTheyWereKilled) {
  write("s.toml",
        "[parameters]\ntolerance = 1e-6\nuntil = 29.2\n[[axis]]\nquantity = \"contact_damping\"\n"
        "values = [9e3, 1e4, 1.1e4]\n[sample]\ncount = 600\n[[sample.over]]\nquantity = "
        "\"friction\"\nlog_uniform = [0.05, 1]\n");
  ASSERT_EQ(rotor("sweep s.toml --out whole.csv").status, 0);
  std::mt19937 random(1);
  int kills = 0;
  for (int n = 0; n < 200 && files() < 2 + 7; ++n) {
    const auto started = shell(fmt::format(
        "timeout --foreground --signal=KILL {} $rotor sweep s.toml --part {}/7 --jobs 2",
        0.01 + static_cast<double>(random() % 40) / 1000, random() % 7 + 1));
    kills += started.status == 128 + SIGKILL ? 1 : 0;
  }
  EXPECT_GE(kills, 7);
  compute(7);
  EXPECT_EQ(rotor("sweep s.toml --join").status, 0);
  EXPECT_TRUE(content("s.csv") == content("whole.csv"));
  EXPECT_EQ(files(), 3 + 7);
}

// As many as there are points, and one.
TEST_F(Parts, AreOfAnyNumber) {
  write_sweep();
  ASSERT_EQ(rotor("sweep s.toml --out whole.csv").status, 0);
  for (int parts : {1, 5, 24}) {
    compute(parts);
    const auto [status, output] = rotor("sweep s.toml --join --force");
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(has(output, "rotor: 24 points, "));  // all are counted
    EXPECT_TRUE(content("s.csv") == content("whole.csv")) << parts;
    shell("rm *-of-*.csv");
  }
  expect_refusal("sweep s.toml --part 1/25",
                 "--part 1/25: there are more parts than the 24 points");
}

/// What is done to four parts, and what joining them says.
struct Wrong {
  const char* command;
  const char* says;
};

void PrintTo(const Wrong& wrong, std::ostream* to) { *to << wrong.command; }

class WrongParts : public Parts, public testing::WithParamInterface<Wrong> {};

// By name, with an option that computes it; then the parts can be joined.
TEST_P(WrongParts, AreRefusedByName) {
  write_sweep();
  ASSERT_EQ(rotor("sweep s.toml --out whole.csv").status, 0);
  compute(4);
  ASSERT_EQ(shell(GetParam().command).status, 0);
  expect_refusal("sweep s.toml --join", GetParam().says);
  EXPECT_FALSE(fs::exists(folder_ / "s.csv"));
  for (const Match& remedy :
       matches(rotor("sweep s.toml --join").output, "--part \\d+/\\d+( --(force|retry))?"))
    EXPECT_EQ(rotor("sweep s.toml " + remedy[0]).status, 0) << remedy[0];
  if (std::string_view(GetParam().says).ends_with("not meant")) shell("rm s.*-of-3.csv");
  EXPECT_EQ(rotor("sweep s.toml --join").status, 0);
  EXPECT_TRUE(content("s.csv") == content("whole.csv"));
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongParts,
    testing::Values(
        Wrong{"rm s.3-of-4.csv", "s.3-of-4.csv: is missing: --part 3/4 computes it"},
        Wrong{"touch s.3-of-4.csv.journal", "s.3-of-4.csv: is unfinished: --part 3/4 resumes it"},
        Wrong{"cp s.2-of-4.csv s.3-of-4.csv",
              "s.3-of-4.csv: is of another sweep file, part or version of rotor: has \"# part 2 of "
              "4: 6 of 24"},
        Wrong{"sed s/150/140/ s.toml >t.toml && $rotor sweep t.toml --part 3/4 --out s.3-of-4.csv "
              "--force && rm t.toml",
              "s.3-of-4.csv: is of another sweep file, part or version of rotor: has "},
        Wrong{"cp whole.csv s.3-of-4.csv", "s.3-of-4.csv: is of another sweep file, part or"},
        Wrong{"cp s.2-of-4.csv s.2-of-3.csv", " parts: remove those that are not meant"}));

// Whatever has happened to a row: none of them is joined.
TEST_F(Parts, AreNotJoinedIfOneIsDamaged) {
  write_sweep();
  compute(4);
  const std::string whole = content("s.3-of-4.csv");
  std::mt19937 random(1);
  for (int kind = 0; kind <= kinds_of_damage; ++kind) {
    const auto rows = starts_of_rows(whole);
    write("s.3-of-4.csv", kind == kinds_of_damage
                              ? whole + "more\n"
                              : damaged(whole, rows, random() % 6, kind, random));
    expect_refusal("sweep s.toml --join",
                   "s.3-of-4.csv: is damaged or cut: its last line is not the check sum of those "
                   "above; --part 3/4 --retry computes it anew");
    EXPECT_EQ(files(), 1 + 4);
  }
}

TEST_F(Parts, AreNotJoinedOverAnUnfinishedOrAnotherSweep) {
  write_sweep();
  compute(2);
  write("s.csv.journal", "");
  expect_refusal("sweep s.toml --join", "s.csv.journal: is of an unfinished sweep without --part");
  fs::remove(folder_ / "s.csv.journal");
  write("s.csv", "mine");
  expect_refusal("sweep s.toml --join", "s.csv: is of another sweep file");
  EXPECT_EQ(content("s.csv"), "mine");
}

// The script for Slurm with the variables that it sets, and the line of GNU parallel on this
// machine, both in four parts.
TEST_F(Parts, AreComputedByTheRecipesOfTheInstructions) {
  const std::string readme = content_of(ROTOR_SOURCES "/figures/program/README.md");
  const auto sweep = matches(readme, "```toml\n([^`]*\\[sample\\][^`]*)```"),
             recipes = matches(readme, "```bash\n([^`]*)```");
  ASSERT_EQ(sweep.size(), 1U);
  ASSERT_EQ(recipes.size(), 2U);
  write("damping.toml", replaced(replaced(sweep[0][1], "count = \\d+", "count = 2"),
                                 "points = \\d+", "points = 3"));
  const char* const names[] = {"slurm.sh", "parallel.sh"};
  for (std::size_t n : {0U, 1U}) write(names[n], replaced(recipes[n][1], "\\b64\\b", "4"));
  write("hosts", ":\n");  // this machine
  ASSERT_EQ(shell("mkdir build && ln -s $rotor build/rotor").status, 0);
  ASSERT_EQ(rotor("sweep damping.toml --out whole.csv").status, 0);
  ASSERT_EQ(shell("for n in 1 2 3 4; do SLURM_ARRAY_TASK_ID=$n SLURM_CPUS_PER_TASK=1 bash -e "
                  "slurm.sh || exit; done; build/rotor sweep damping.toml --join")
                .status,
            0);
  EXPECT_TRUE(content("damping.csv") == content("whole.csv"));
  if (shell("command -v parallel").status != 0) GTEST_SKIP() << "needs GNU parallel";
  ASSERT_EQ(shell("rm damping.*csv").status, 0);
  const auto [status, output] = shell("HOME=$PWD bash -e parallel.sh");
  EXPECT_EQ(status, 0) << output;
  EXPECT_TRUE(content("damping.csv") == content("whole.csv"));
}

}  // namespace
}  // namespace rotor
