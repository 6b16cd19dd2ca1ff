/// What is left of work that somebody interrupts, or kills.
#include "figures/data/interruption.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "verification/support/writing.hpp"

namespace rotor {
namespace {

using namespace std::chrono_literals;

TEST_F(Writing, LeavesNothingBehindWhenInterrupted) {
  for (const auto& [signal, expected] :
       std::vector<std::pair<std::string, int>>{{"INT", 130}, {"TERM", 143}, {"HUP", 129}}) {
    write("t.csv", "precious");
    const auto [status, output] =
        shell("bash -c 'set -m; \"$0\" " + long_run + " --trace t.csv & " + wait_for_rows +
              "; ls -A | wc -l; kill -" + signal + " %1; wait %1; echo status $?' \"$rotor\"");
    EXPECT_TRUE(output.starts_with("2\n")) << output;  // the draft was there
    EXPECT_NE(output.find("rotor: interrupted; no file has been written"), std::string::npos);
    EXPECT_NE(output.find(fmt::format("status {}\n", expected)), std::string::npos);
    EXPECT_EQ(content("t.csv"), "precious");
    remove("t.csv");
  }
}

// Even if nobody reads what it writes, all of it or a rest.
TEST_F(Writing, EndsWhenInterruptedWhileAPipeIsFull) {
  for (const char* there : {"", "head -c 65536 /dev/zero >&4;"}) {
    const std::string output =
        shell(std::string("rm -f pipe; mkfifo pipe; exec 4<>pipe; ") + there +
              "timeout --foreground --signal=INT --kill-after=10 1 $rotor run --until 1e5 "
              "--no-separation --trace pipe; echo status $?")
            .output;
    EXPECT_EQ(output.find("status 137"), std::string::npos) << output;
    EXPECT_NE(output.find("interrupted"), std::string::npos) << output;
  }
  remove("pipe");
}

// The speed would be reached in hours: that it is not is no finding.
TEST_F(Writing, EndsTheSearchForASpeedWhenInterrupted) {
  const std::string output =
      shell(
          "timeout --foreground --signal=INT --kill-after=10 1 $rotor run --torque 1e-6 --gravity "
          "0 --separation-speed-hz 1; echo status $?")
          .output;
  EXPECT_EQ(output, "rotor: interrupted; no file has been written\nstatus 124\n");
}

// Where the speed ripples it is looked for in parts of a turn, which takes minutes here.
TEST_F(Writing, EndsTheSearchWithinTurnsWhenInterrupted) {
  const std::string output =
      shell(
          "timeout --foreground --signal=INT --kill-after=10 1 $rotor run --torque 1e-8 "
          "--support-damping 0 --start-speed-hz 55 --separation-speed-hz 55.003; echo status $?")
          .output;
  EXPECT_EQ(output, "rotor: interrupted; no file has been written\nstatus 124\n");
}

// Its run would take minutes; what it had computed so far is no figure.
TEST_F(Writing, EndsAFigureWhenInterrupted) {
  write("fig01.toml",
        "columns = [\"time_s\", \"rho_m\"]\nwindow = { from_s = 0, until_s = 1e5 }\n"
        "[parameters]\nfriction = 0.05\nseparation_time = 1\nuntil = 1e5\n");
  const auto [status, output] = shell(
      "timeout --signal=KILL 60 bash -c 'set -m; \"$0\" figure --scenes . --out out & sleep "
      "0.5; kill -INT %1; wait %1; echo status $?' \"$rotor\"");
  EXPECT_NE(output.find("rotor: interrupted; no file has been written"), std::string::npos)
      << output;
  EXPECT_NE(output.find("status 130"), std::string::npos) << output;
  EXPECT_FALSE(fs::exists(folder_ / "out/fig01.csv"));
  remove("fig01.toml");
}

TEST_F(Writing, KeepsWhatWasComputedIfThatIsAskedFor) {
  const auto [status, output] =
      shell("bash -c 'set -m; \"$0\" " + long_run + " --json --keep-partial --trace t.csv & " +
            wait_for_rows + "; kill -INT %1; wait %1' \"$rotor\"");
  EXPECT_EQ(status, 0) << output;
  EXPECT_NE(output.find("\"cut_short_at_s\": "), std::string::npos) << output;
  const std::string trace = content("t.csv");
  EXPECT_NE(trace.find("\n# cut short at "), std::string::npos);
  EXPECT_EQ(trace.back(), '\n');
  EXPECT_GT(rows_of("t.csv").size(), 100U);
  remove("t.csv");
}

TEST_F(Writing, RemovesWhatAKilledRunHasLeft) {
  shell("bash -c '\"$0\" " + long_run + " --trace t.csv & " + wait_for_rows +
        "; kill -KILL $!; wait' \"$rotor\"");
  EXPECT_EQ(files(), 1);  // its draft
  EXPECT_FALSE(fs::exists(folder_ / "t.csv"));
  EXPECT_EQ(rotor(short_run + " --trace t.csv").status, 0);
  remove("t.csv");
}

// Some programs send their signal to a process and then to its group, that is twice.
TEST_F(Writing, TakesTheEchoOfASignalForTheSame) {
  const auto [status, output] = shell("bash -c 'set -m; \"$0\" " + long_run +
                                      " --keep-partial --trace t.csv & " + wait_for_rows +
                                      "; kill -INT %1; kill -TERM %1; wait %1' "
                                      "\"$rotor\"");
  EXPECT_EQ(status, 0) << output;
  EXPECT_NE(output.find("rotor: cut short at "), std::string::npos) << output;
  EXPECT_NE(content("t.csv").find("\n# cut short at "), std::string::npos);
  remove("t.csv");
}

TEST(Interruptions, AreNoHangUpsThatNobodyWantsToHear) {
  const auto hang_up = [] {
    static_cast<void>(std::signal(SIGHUP, SIG_IGN));
    note_interruptions();
    static_cast<void>(std::raise(SIGHUP));
    std::exit(interrupting_signal());
  };
  EXPECT_EXIT(hang_up(), testing::ExitedWithCode(0), "");
}

// What comes later is another one, and ends the program at once.
TEST(Interruptions, AreEchoesForAShortTime) {
  const auto twice = [](std::chrono::milliseconds apart) {
    note_interruptions();
    static_cast<void>(std::raise(SIGINT));
    std::this_thread::sleep_for(apart);
    static_cast<void>(std::raise(SIGTERM));
    std::exit(interrupting_signal());
  };
  EXPECT_EXIT(twice(20ms), testing::ExitedWithCode(SIGINT), "");
  EXPECT_EXIT(twice(400ms), testing::KilledBySignal(SIGTERM), "");
}

// A system has but so many threads.
TEST_F(Writing, SweepsWithTheThreadsThatThereAre) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer takes memory of its own";
#endif
  write("s.toml",
        "[parameters]\nstart_speed_hz = 150\nuntil = 1e-3\n[[axis]]\nquantity = \"friction\"\n"
        "from = 0.1\nto = 0.2\npoints = 5000\n");
  EXPECT_EQ(rotor("sweep s.toml --jobs 1 --out one.csv").status, 0);
  const auto [status, output] =
      shell("ulimit -v 3000000; $rotor sweep s.toml --jobs 4096 --out many.csv");
  EXPECT_EQ(status, 0) << output;
  EXPECT_TRUE(content("one.csv") == content("many.csv"));
  for (const char* name : {"s.toml", "one.csv", "many.csv"}) remove(name);
}

}  // namespace
}  // namespace rotor
