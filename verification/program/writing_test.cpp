/// How the program writes, and what it leaves behind.
#include "verification/support/writing.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <sstream>

#include "figures/data/csv.hpp"

namespace rotor {
namespace {

TEST_F(Writing, GoesThroughWhatIsNoRegularFile) {
  EXPECT_EQ(shell("mkfifo pipe && (cat pipe > copy &) && $rotor " + short_run +
                  " --trace pipe && while [ ! -s copy ]; do sleep 0.01; done; sleep 0.05")
                .status,
            0);
  EXPECT_TRUE(fs::is_fifo(folder_ / "pipe"));
  EXPECT_GT(rows_of("copy").size(), 10U);
  EXPECT_EQ(rotor(short_run + " --trace /dev/null").status, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  remove("pipe");
  remove("copy");
}

// Behind what has been written to it, and before what is written to it then.
TEST_F(Writing, WritesToADescriptorInItsPlace) {
  for (const std::string name : {"/dev/fd/3", "/proc/self/fd/3", "/dev/stdout"})
    for (const std::string open : {">>", ">"}) {
      write("t.csv", "precious\n");
      const auto [status, output] =
          shell("exec 3" + open + "t.csv >&3; echo head; $rotor " + short_run + " --trace " + name +
                " 2>messages; echo tail");
      EXPECT_EQ(status, 0);
      const std::string text = content("t.csv"), kept = open == ">>" ? "precious\n" : "";
      EXPECT_TRUE(text.starts_with(kept + "head\n# Trace of a run\n")) << name << text;
      EXPECT_TRUE(text.ends_with("\ntail\n")) << name << text;
    }
  remove("messages");
  expect_refusal(short_run + " --trace /dev/fd/3 3<t.csv",
                 "/dev/fd/3: cannot be written: it is open for reading alone");
  expect_refusal(short_run + " --trace /dev/fd/77", "/dev/fd/77: cannot be written: Bad file");
  remove("t.csv");
}

TEST_F(Writing, LeavesNoFolderOfARunThatFails) {
  EXPECT_EQ(rotor("run --stop-on rolling --from 29.3 --trace new/folder/t.csv").status, 1);
  EXPECT_FALSE(fs::exists(folder_ / "new"));
  EXPECT_EQ(rotor("run --stop-on rolling --from 29.3 --trace new/sub/t.csv --events new/sub/e.csv")
                .status,
            1);
  EXPECT_FALSE(fs::exists(folder_ / "new"));
}

TEST_F(Writing, ToStandardOutputLeavesTheSummaryToStandardError) {
  const auto [status, output] =
      shell("$rotor " + short_run + " --json --trace - 2> summary > trace");
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(content("summary").starts_with("{"));
  EXPECT_EQ(rows_of("trace").front(), "run,time_s,rho_m");
  EXPECT_EQ(content("trace").find('{'), std::string::npos);
  remove("summary");
  remove("trace");
}

TEST_F(Writing, OfEventsToStandardOutputLeavesTheSummaryToStandardError) {
  const auto [status, output] =
      shell("$rotor run --until 29.12 --events - 2>/dev/null | tail -n 1");
  EXPECT_TRUE(output.find("outcome") == std::string::npos &&
              output.find(",29.1") != std::string::npos)
      << output;
  EXPECT_NE(shell("$rotor run --until 29.12 --events - 2>&1 >/dev/null").output.find("outcome"),
            std::string::npos);
}

TEST_F(Writing, ToStandardOutputByItsNameLeavesTheSummaryToStandardError) {
  fs::create_symlink("/dev/stdout", folder_ / "link");
  for (const char* name : {"/dev/stdout", "/proc/self/fd/1", "link"}) {
    const auto [status, output] =
        shell("$rotor " + short_run + " --trace " + name + " 2>/dev/null | tail -n 1");
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(output.starts_with("run,")) << name << output;
  }
  remove("link");
  EXPECT_NE(shell("$rotor " + short_run + " --trace /dev/null").output.find("outcome"),
            std::string::npos);
  EXPECT_EQ(
      shell("$rotor " + short_run + " --trace /dev/null 2>&1 >/dev/null").output.find("outcome"),
      std::string::npos);
}

TEST_F(Writing, RefusesTheSameTargetTwiceHoweverItIsSpelt) {
  for (const char* twice : {"--trace t.csv --events t.csv", "--trace t.csv --events ./t.csv",
                            "--trace new/t.csv --events new/../new/t.csv", "--trace - --events -",
                            "--trace - --events /dev/stdout"})
    expect_refusal(long_run + " " + twice, "it is asked for twice");
  expect_refusal(long_run + " --trace t.csv --events " + (folder_ / "t.csv").string(),
                 "it is asked for twice");
  fs::create_directory(folder_ / "real");
  fs::create_directory_symlink("real", folder_ / "linked");
  expect_refusal(long_run + " --trace real/t.csv --events linked/t.csv", "it is asked for twice");
  remove("linked");
  remove("real");
  EXPECT_EQ(shell("$rotor " + long_run + " --trace - --events - 2>&1 >/dev/null").output,
            "rotor: -: cannot be written: it is asked for twice\n");
  if (has_terminals()) {
    EXPECT_NE(
        shell("script -qec \"$rotor " + long_run + " --trace - --events /dev/stdout\" /dev/null")
            .output.find("it is asked for twice"),
        std::string::npos);
  }
  write("t.csv", "precious");
  fs::create_symlink("t.csv", folder_ / "link");
  expect_refusal(long_run + " --trace t.csv --events link", "it is asked for twice");
  EXPECT_EQ(content("t.csv"), "precious");
  remove("link");
  remove("t.csv");
}

TEST_F(Writing, ReportsAFullDiskAndALostStandardOutput) {
  expect_refusal(short_run + " --trace /dev/full", "/dev/full: cannot be written: No space left");
  write("t.csv", "old");
  expect_refusal(short_run + " --trace t.csv --events /dev/full", "/dev/full: cannot be written");
  EXPECT_EQ(content("t.csv"), "old");
  remove("t.csv");
  expect_refusal(short_run + " --trace - > /dev/full", "standard output: cannot be written: No");
  expect_refusal("run --no-separation --until 0.1 --json > /dev/full",
                 "standard output cannot be written: No space");
  expect_refusal("run --no-separation --until 0.1 --json >&-",
                 "standard output cannot be written: Bad file");
  EXPECT_EQ(rotor("run --no-separation --until 0.1 --json <&-").status, 0);
  for (const char* trace : {"t.csv", "t.csv 2>/dev/full", "t.csv 2>&-"})  // nobody is told then
    EXPECT_EQ(rotor(short_run + " --trace " + trace).status, 0) << trace;
  EXPECT_EQ(rotor("run --friction -1 2>/dev/full").status, 1);
  remove("t.csv");
  const auto [status, output] = shell(
      "{ sleep 0.2; $rotor run --no-separation --until 0.1 --json; echo status $? >&2; } | true");
  EXPECT_NE(output.find("status 1"), std::string::npos) << output;
}

// A reader that goes away ends the run with a message, and with nothing half written beside.
TEST_F(Writing, LeavesNothingBehindWhenItsReaderGoesAway) {
  const std::string output =
      shell(
          "{ $rotor run --until 20 --no-separation --trace - --events e.csv; echo status $? >&2; "
          "} | head -n 3 >/dev/null")
          .output;
  EXPECT_NE(output.find("standard output: cannot be written: Broken pipe"), std::string::npos)
      << output;
  EXPECT_NE(output.find("status 1"), std::string::npos) << output;
  EXPECT_EQ(files(), 0);
}

TEST_F(Writing, TouchesNobodysOwnDrafts) {
  write("t.csv.part", "precious");
  write(".t.csv.part", "precious");
  EXPECT_EQ(rotor(short_run + " --trace t.csv").status, 0);
  EXPECT_EQ(content("t.csv.part"), "precious");
  EXPECT_EQ(content(".t.csv.part"), "precious");
  // No process has this number; but drafts are named otherwise.
  write(".t.csv.4194305.part", "precious");
  rotor("run --until 0.01 --trace t.csv");
  EXPECT_EQ(content(".t.csv.4194305.part"), "precious");
  remove(".t.csv.4194305.part");
  remove("t.csv.part");
  remove(".t.csv.part");
  remove("t.csv");
}

// It tells by the names of drafts, which stand beside the file itself, and by who still runs.
TEST_F(Writing, ClearsAwayTheDraftsOfProcessesThatWereKilled) {
  fs::create_symlink("t.csv", folder_ / "link");
  write(".t.csv.4194305-0.part", "half");
  const std::string own = fmt::format(".t.csv.{}-0.part", ::getpid());
  write(".t.csv.1-0.part", "being written");
  write(own, "being written");
  EXPECT_EQ(rotor(short_run + " --trace link").status, 0);
  EXPECT_FALSE(fs::exists(folder_ / ".t.csv.4194305-0.part"));
  EXPECT_EQ(content(".t.csv.1-0.part"), "being written");
  remove(".t.csv.1-0.part");
  remove(own);
  remove("link");
  remove("t.csv");
}

TEST_F(Writing, LetsOneOfTwoProcessesWinWhole) {
  EXPECT_EQ(rotor(short_run + " --friction 0.1 --trace a").status, 0);
  EXPECT_EQ(rotor(short_run + " --friction 0.2 --trace b").status, 0);
  EXPECT_NE(content("a"), content("b"));
  for (int n = 0; n < 10; ++n) {
    const auto [status, output] =
        shell("$rotor " + short_run + " --friction 0.1 --trace t & $rotor " + short_run +
              " --friction 0.2 --trace t; wait");
    EXPECT_TRUE(content("t") == content("a") || content("t") == content("b"));
  }
  for (const char* name : {"a", "b", "t"}) remove(name);
}

TEST_F(Writing, QuotesNamesAsRfc4180HasIt) {
  const std::string name = "mu, \"high\" # or so";
  write("s.toml",
        "columns = [\"time_s\", \"rho_m\"]\n"
        "[parameters]\nuntil = 0.1\n[[run]]\nname = \"mu, \\\"high\\\" # or so\"\n");
  EXPECT_EQ(rotor("run --scene s.toml --trace t.csv").status, 0);
  const std::vector<CsvRow> rows = read_csv(folder_ / "t.csv");
  ASSERT_GT(rows.size(), 10U);
  for (const CsvRow& row : rows) EXPECT_EQ(row["run"], name);
  EXPECT_EQ(rows.front().number("time_s"), 0);
  EXPECT_EQ(static_cast<double>(rows.back().number("time_s")), 0.1);
  remove("s.toml");
  remove("t.csv");
}

TEST_F(Writing, TakesNoMemoryForALongTrace) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer takes memory of its own";
#endif
  // 600,000 rows of 16 columns are 77 MB as numbers alone.
  const auto [status, output] = shell(
      "ulimit -v 60000; $rotor run --method rk4 --no-separation --step-run-up 1e-5 --until 6 "
      "--json "
      "--trace /dev/null");
  EXPECT_EQ(status, 0) << output;
  EXPECT_NE(output.find("\"steps\": 600000"), std::string::npos) << output;
}

}  // namespace
}  // namespace rotor
