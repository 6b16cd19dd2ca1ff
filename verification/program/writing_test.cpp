/// The files that the program writes: each is complete, or unchanged.
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <map>

#include "figures/data/csv.hpp"
#include "figures/data/files.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

/// A short run, and one that takes longer than any test.
const std::string short_run = "run --until 0.1";
const std::string long_run = "run --no-mass-loss --until 1e6 --columns time_s,rho_m";
/// Shell: waits, but not for ever, until the first rows of t.csv are in its draft.
const std::string wait_for_rows =
    "for n in $(seq 300); do [ -s .t.csv.*.part ] && break; sleep 0.05; done";

class Writing : public CommandLine {
 protected:
  void TearDown() override {
    EXPECT_EQ(files(), 0) << "something was left behind";
    CommandLine::TearDown();
  }
  void remove(std::initializer_list<const char*> names) const {
    for (const char* name : names) EXPECT_TRUE(fs::remove(folder_ / name)) << name;
  }

  /// A long run with options in the background until it has rows; then a shell command. What it
  /// says on stderr is lost, because a busy machine adds how far it is.
  Outcome with_rows(const std::string& options, const std::string& then) const {
    return shell("bash -c 'set -m; \"$0\" " + long_run + " --trace t.csv " + options +
                 " 2>/dev/null & " + wait_for_rows + "; " + then + "' \"$rotor\"");
  }
};

TEST_F(Writing, GoesThroughWhatIsNoRegularFile) {
  EXPECT_EQ(shell("mkfifo pipe && (cat pipe > copy &) && $rotor " + short_run +
                  " --trace pipe && while [ ! -s copy ]; do sleep 0.01; done; sleep 0.05")
                .status,
            0);
  EXPECT_TRUE(fs::is_fifo(folder_ / "pipe"));
  EXPECT_GT(rows_of("copy").size(), 10U);
  EXPECT_EQ(rotor(short_run + " --trace /dev/null").status, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  remove({"pipe", "copy"});
}

// After what was written to it before, and before what is written to it later.
TEST_F(Writing, WritesToStandardOutputInItsPlace) {
  for (const std::string open : {">>", ">"}) {
    write("t.csv", "precious\n");
    EXPECT_EQ(shell("exec " + open + "t.csv; echo head; $rotor " + short_run +
                    " --trace /dev/stdout 2>messages; echo tail")
                  .status,
              0);
    const std::string text = content("t.csv"), kept = open == ">>" ? "precious\n" : "";
    EXPECT_TRUE(text.starts_with(kept + "head\n# Trace of a run\n")) << text;
    EXPECT_TRUE(text.ends_with("\ntail\n")) << text;
  }
  write("t.csv", "precious\n");
  expect_refusal(short_run + " --trace /dev/fd/3 3>>t.csv", "name a file");
  EXPECT_EQ(content("t.csv"), "precious\n");
  remove({"messages", "t.csv"});
}

// If the table goes to standard output, by any name, the summary goes to standard error.
TEST_F(Writing, MixesNoTableWithTheSummary) {
  fs::create_symlink("/dev/stdout", folder_ / "link");
  for (const std::string file : {"-", "/dev/stdout", "/proc/self/fd/1", "link"})
    for (const std::string table : {"--trace ", "--events "}) {
      EXPECT_EQ(
          shell("$rotor " + short_run + " --json " + table + file + " 2>summary >table").status, 0);
      EXPECT_TRUE(content("summary").starts_with("{")) << file;
      EXPECT_FALSE(has(content("table"), "{")) << file;
      EXPECT_TRUE(content("table").starts_with("# ")) << file;
    }
  remove({"link", "summary", "table"});
  EXPECT_TRUE(shell("$rotor " + short_run + " --trace /dev/null 2>/dev/null").output.size() > 100);
}

TEST_F(Writing, RefusesTheSameTargetTwiceHoweverItIsSpelt) {
  for (const char* folder : {"real", "new"}) fs::create_directory(folder_ / folder);
  fs::create_directory_symlink("real", folder_ / "linked");
  write("t.csv", "precious");
  fs::create_symlink("t.csv", folder_ / "link");
  for (const char* twice :
       {"--trace t.csv --events ./t.csv", "--trace new/t.csv --events new/../new/t.csv",
        "--trace - --events /dev/stdout", "--trace real/t.csv --events linked/t.csv",
        "--trace t.csv --events link"})
    expect_refusal(long_run + " " + twice, "it is the file of two outputs");
  EXPECT_EQ(content("t.csv"), "precious");
  remove({"linked", "real", "new", "link", "t.csv"});
}

TEST_F(Writing, ReportsAFullDiskAndALostStandardOutput) {
  expect_refusal(short_run + " --trace /dev/full", "/dev/full: cannot be written: No space left");
  write("t.csv", "old");
  expect_refusal(short_run + " --trace t.csv --events /dev/full", "/dev/full: cannot be written");
  EXPECT_NE(rotor("run --method rk4 --contact-stiffness 1e13 --trace t.csv").status, 0);
  EXPECT_EQ(content("t.csv"), "old");
  remove({"t.csv"});
  expect_refusal(short_run + " --trace - > /dev/full", "standard output: cannot be written: No");
  expect_refusal("run --no-mass-loss --until 0.1 --json > /dev/full",
                 "standard output cannot be written: No space");
  expect_refusal("run --no-mass-loss --until 0.1 --json >&-",
                 "standard output cannot be written: Bad file");
  EXPECT_EQ(rotor(short_run + " --trace t.csv 2>&-").status, 0);  // nowhere to report it
  EXPECT_TRUE(content("t.csv").starts_with("# Trace"));
  remove({"t.csv"});
  EXPECT_EQ(
      rotor("run --stop-on rolling --from 29.3 --trace new/sub/t.csv --events new/e.csv").status,
      1);  // the folder is gone
}

// If the reader of standard output disappears, nothing is said, and no partial file is left. The
// status is that of a program that SIGPIPE ends.
TEST_F(Writing, EndsQuietlyWhenItsReaderGoesAway) {
  EXPECT_EQ(shell("{ $rotor " + long_run +
                  " --trace - --events e.csv; echo status $? >&2; } | head -n 3 >/dev/null")
                .output,
            "status 141\n");
  write("s.toml",
        "[parameters]\nstart_speed_Hz = 150\nuntil = 1e-3\n[[run]]\nname = \"a\"\n"
        "[[run]]\nname = \"b\"\n");
  for (const char* command :
       {"--help", "run --help", "run --json-schema", "run --columns help", "run s.toml 2>/dev/null",
        "run s.toml --json", "run s.toml --run a", "run s.toml --trace /dev/stdout 2>/dev/null",
        "run s.toml --events - 2>/dev/null", "estimate 2>/dev/null", "estimate --json 2>/dev/null",
        "plot s.toml"})
    EXPECT_EQ(shell(fmt::format("{{ sleep 0.1; $rotor {}; echo status $? >&2; }} | true", command))
                  .output,
              "status 141\n")
        << command;
  // Of another pipe it is an error.
  EXPECT_TRUE(has(
      shell("mkfifo pipe; head -n 3 <pipe >/dev/null & $rotor " + long_run + " --trace pipe; wait")
          .output,
      "rotor: pipe: cannot be written: Broken pipe"));
  remove({"s.toml", "s.svg", "pipe"});
}

// From a pipe the text comes once, and a sweep can tell no name for its results.
TEST_F(Writing, ReadsPipesAsItReadsFiles) {
  write("s.toml", "[parameters]\nstart_speed_Hz = 150\nuntil = 1e-3\n");
  write("w.toml", content("s.toml") + "[[axis]]\nquantity = \"friction\"\nvalues = [0.1, 0.2]\n");
  const std::string whole = rotor("run s.toml --json").output;
  for (const char* command :
       {"cat s.toml | $rotor run /dev/stdin --json",
        "bash -c '\"$0\" run <(cat s.toml) --json' $rotor",
        "mkfifo pipe; timeout 5 bash -c 'cat s.toml > pipe' & $rotor run pipe --json; rm pipe"})
    EXPECT_EQ(shell(command).output, whole) << command;
  EXPECT_EQ(rotor("sweep w.toml").status, 0);
  EXPECT_EQ(shell("cat w.toml | $rotor sweep /dev/stdin --out r.csv").status, 0);
  EXPECT_EQ(content("r.csv"), content("w.csv"));
  expect_refusal("sweep /dev/stdin < w.toml", "--out: must be stated");
  EXPECT_TRUE(has(shell("cat s.toml | $rotor plot /dev/stdin").output, "--out: must be stated"));
  EXPECT_EQ(shell("cat s.toml | $rotor plot /dev/stdin --out p.svg 2>/dev/null").output, "p.svg\n");
  EXPECT_TRUE(has(shell("yes | $rotor run /dev/stdin").output, "it is larger than"));
  EXPECT_EQ(shell("mkfifo pipe; timeout --foreground --signal=INT --kill-after=10 0.2 $rotor run "
                  "pipe; echo status $?")
                .output,
            "rotor: interrupted; no file has been written\nstatus 124\n");
  remove({"s.toml", "w.toml", "w.csv", "r.csv", "p.svg", "pipe"});
}

TEST_F(Writing, LeavesNothingBehindWhenInterrupted) {
  const std::map<std::string, int> statuses = {
      {"INT", 130}, {"TERM", 143}, {"HUP", 129}, {"QUIT", 131}};
  for (const auto& [signal, expected] : statuses) {
    write("t.csv", "precious");
    const std::string output =
        with_rows("", "ls -A | wc -l; kill -" + signal + " %1; wait %1; echo status $?").output;
    EXPECT_TRUE(output.starts_with("2\n")) << output;  // the draft was there
    EXPECT_TRUE(has(output, fmt::format("status {}\n", expected)));
    EXPECT_EQ(content("t.csv"), "precious");
    remove({"t.csv"});
  }
}

// A killed process cannot clean up. The next one that writes the same file does so, but leaves
// alone the draft of one that is still running.
TEST_F(Writing, RemovesWhatAKilledProcessHasLeft) {
  const std::string again = "\"$0\" " + short_run + " --trace t.csv 2>/dev/null >&2; ls -A";
  const std::string output =
      with_rows("", again + "; kill -KILL %1; wait %1 2>messages; " + again).output;
  EXPECT_TRUE(output.starts_with(".t.csv.0.part\nt.csv\n")) << output;
  EXPECT_TRUE(output.ends_with("\nmessages\nt.csv\n")) << output;
  EXPECT_EQ(output.rfind(".part"), output.find(".part")) << output;
  remove({"messages", "t.csv"});
  write("s.toml", "[parameters]\nstart_speed_Hz = 150\nuntil = 1e-3\n");
  // rotor calls a shell that calls gnuplot
  write("gnuplot",
        "#!/bin/bash\nls -A $TMPDIR >&2\nread -r _ _ _ rotor _ </proc/$PPID/stat; kill -KILL "
        "$rotor\n");
  fs::permissions(folder_ / "gnuplot", fs::perms::owner_all);
  fs::create_directory(folder_ / "drafts");
  for (int n = 0; n < 2; ++n)
    EXPECT_TRUE(shell("TMPDIR=$PWD/drafts PATH=$PWD:$PATH $rotor plot s.toml 2>&1")
                    .output.starts_with(".rotor-plot.0.part\n"));
  EXPECT_EQ(shell("TMPDIR=$PWD/drafts $rotor plot s.toml 2>&1").status, 0);
  EXPECT_TRUE(fs::is_empty(folder_ / "drafts"));
  remove({"drafts", "gnuplot", "s.toml", "s.svg"});
}

// `ulimit -f` limits files to some kB. Only a sweep leaves something: the journal from which it
// resumes.
TEST_F(Writing, LeavesNothingBehindWhereFilesMayNotGrow) {
  write("s.toml", "[parameters]\nstart_speed_Hz = 150\nuntil = 0.03\n");
  write("sweep.toml", content("s.toml") +
                          "[[axis]]\nquantity = \"friction\"\nfrom = 0.1\nto = 0.3\npoints = 9\n");
  fs::create_directory(folder_ / "drafts");
  for (const char* command :
       {"run s.toml --trace t.csv", "run s.toml --trace - >t.csv", "run s.toml --json >t.csv",
        "estimate --help >t.csv", "figure --out .", "plot s.toml",
        "sweep sweep.toml --out t.csv --jobs 1"}) {
    const auto [status, output] =
        shell(std::string("ulimit -f 1; TMPDIR=$PWD/drafts $rotor ") + command + "; ls drafts");
    EXPECT_TRUE(output.starts_with("rotor: ") && output.ends_with(": File too large\n"))
        << command << ": " << output;
    fs::remove(folder_ /
               (std::string_view(command).starts_with("sweep") ? "t.csv.journal" : "t.csv"));
    EXPECT_EQ(files(), 3) << command;
  }
  remove({"drafts", "s.toml", "sweep.toml"});
}

// Searches for a speed within single turns and over hours, and figures.
TEST_F(Writing, EndsWhateverItDoesWhenInterrupted) {
  write("fig01.toml",
        "columns = [\"time_s\", \"rho_m\"]\nwindow = { from_s = 99999, until_s = 1e5 }\n"
        "[parameters]\nfriction = 0.05\nmass_loss_time = 1\nuntil = 1e5\n");
  for (const char* work :
       {"run --torque 1e-6 --gravity 0 --mass-loss-speed-Hz 1",
        "run --torque 1e-8 --support-damping 0 --start-speed-Hz 55 --mass-loss-speed-Hz 55.003",
        "figure --scenes . --out out"})
    EXPECT_EQ(shell(std::string("timeout --foreground --signal=INT --kill-after=10 0.5 $rotor ") +
                    work + "; echo status $?")
                  .output,
              "rotor: interrupted; no file has been written\nstatus 124\n")
        << work;
  // Even if nobody reads its output.
  EXPECT_TRUE(
      has(shell("mkfifo pipe; exec 4<>pipe; timeout --foreground --signal=INT --kill-after=10 1 "
                "$rotor run --until 1e5 --no-mass-loss --trace pipe; echo status $?")
              .output,
          "interrupted"));
  remove({"fig01.toml", "pipe"});
}

// Relative links from their own folder; also links whose target does not exist yet.
TEST_F(Writing, FollowsLinksAndKeepsTheMode) {
  ASSERT_EQ(shell("mkdir -p other/sub && ln -s target other/link && ln -s other/sub up").status, 0);
  for (const mode_t mode : {0600U, 0664U}) {
    write("other/target", "old");
    ASSERT_EQ(::chmod((folder_ / "other/target").c_str(), mode), 0);
    EXPECT_EQ(shell("umask 077; $rotor " + short_run + " --trace other/link").status, 0);
    EXPECT_EQ(fs::status(folder_ / "other/target").permissions(), fs::perms(mode));
    EXPECT_GT(rows_of("other/target").size(), 10U);
  }
  remove({"other/target"});
  EXPECT_EQ(shell("umask 027; $rotor " + short_run + " --trace other/link").status, 0);
  EXPECT_EQ(fs::status(folder_ / "other/target").permissions(), fs::perms{0640});
  EXPECT_TRUE(fs::is_symlink(folder_ / "other/link"));
  // After a link, two dots are the parent of its target.
  EXPECT_EQ(rotor(short_run + " --trace up/../t.csv").status, 0);
  EXPECT_GT(rows_of("other/t.csv").size(), 10U);
  fs::remove_all(folder_ / "other");
  remove({"up"});
}

// Read-only files, and the file from which the runs are read.
TEST_F(Writing, ReportsThatItsTargetHasBecomeAFolder) {
  {
    OutputFile file(folder_ / "t.csv");
    file.write("x");
    fs::create_directory(folder_ / "t.csv");
    EXPECT_THROW(file.commit(), std::runtime_error);
  }
  remove({"t.csv"});
}

TEST_F(Writing, ReplacesNothingThatItHadBetterKeep) {
  write("t.csv", "precious");
  // A user who may write anywhere, as in containers, gives up that right for this test.
  EXPECT_EQ(shell("chmod 444 t.csv; user=; [ $(id -u) -ne 0 ] || user='setpriv --inh-caps "
                  "-dac_override --bounding-set -dac_override'; $user $rotor " +
                  short_run + " --trace t.csv")
                .status,
            1);
  EXPECT_EQ(content("t.csv"), "precious");
  remove({"t.csv"});
  write("one", "[[axis]]\nquantity = \"mass\"\nvalues = [5]\n");
  expect_refusal("sweep one --out one", "the runs are read from this file");
  write("s.toml", "[parameters]\nuntil = 0.1\n");
  for (const char* outputs : {"run s.toml --trace ./s.toml", "plot s.toml --out s.toml"})
    EXPECT_NE(rotor(outputs).status, 0) << outputs;
  EXPECT_EQ(content("s.toml"), "[parameters]\nuntil = 0.1\n");
  remove({"one", "s.toml"});
}

}  // namespace
}  // namespace rotor
