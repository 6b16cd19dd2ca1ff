/// What long work says of how far it is.
#include <algorithm>

#include "figures/data/text.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

/// A duration as it is said, in whole units: half of one may be missing.
double in_seconds(double duration, std::string_view unit) {
  return duration * (unit == "s" ? 1 : unit == "min" ? 60 : unit == "h" ? 3600 : 86'400);
}

TEST(Duration, IsSaidInAUnitThatSuitsIt) {
  EXPECT_EQ(duration(99), "99 s");
  EXPECT_EQ(duration(120), "2 min");
  EXPECT_EQ(duration(5400), "90 min");
  EXPECT_EQ(duration(7200), "2 h");
  EXPECT_EQ(duration(259'200), "3 days");
  EXPECT_EQ(time_to_go_s(10, 2, 8), 30);
  EXPECT_EQ(time_to_go_s(10, 8, 8), 0);
}

// Progress is for those who wait: on a terminal, a run that is over at once leaves no line.
TEST_F(CommandLine, SaysNothingOfTheProgressOfAQuickRun) {
  if (!has_terminals()) GTEST_SKIP() << "there are no pseudo-terminals";
  const auto [status, output] = shell(
      "script -qec \"$rotor run --separation-time 9.4 --equations published --json 2>&1 >summary\" "
      "/dev/null");
  EXPECT_EQ(status, 0);
  EXPECT_EQ(output, "");
  EXPECT_FALSE(content("summary").empty());
}

// A long one says from the third second how it goes on, once a second at most; in a file, which is
// no terminal, in lines.
TEST_F(CommandLine, SaysTheProgressOfALongRunOnATerminal) {
  if (!has_terminals()) GTEST_SKIP() << "there are no pseudo-terminals";
  const std::string long_run = "$rotor run --until 1e6 --no-separation --tolerance 1e-14";
  const auto [status, output] =
      interrupted_on_terminal(long_run + " 2> log & " + long_run, "in [4-9] s;");
  const std::string log = content("log");  // says it again after four times as long
  EXPECT_TRUE(log.starts_with("rotor: at ")) << log;
  EXPECT_LE(std::ranges::count(log, '\n'), 2) << log;
  EXPECT_EQ(log.find('\r'), std::string::npos) << log;
  EXPECT_NE(status, 0);
  EXPECT_NE(output.find("stops)  ^C\r\nrotor: interrupted; no file has been written\r\n"),
            std::string::npos)
      << output;
  int reports = 0;
  double last_s = 0, at_s = 0, to_go = 0;
  std::array<char, 8> unit{};
  for (std::size_t at = 0; (at = output.find("\rat ", at)) != std::string::npos; ++reports, ++at)
    ASSERT_EQ(std::sscanf(output.c_str() + at,
                          "\rat %lf s of 1e+06 s after %*d steps in %lf s; about %lf %7[a-z] to go",
                          &at_s, &last_s, &to_go, unit.data()),
              4)
        << output;
  EXPECT_NEAR(in_seconds(to_go, unit.data()) / (last_s * (1e6 / at_s - 1)), 1, 0.4) << output;
  EXPECT_GE(reports, 1) << output;
  EXPECT_LE(reports, last_s - 1.5) << output;  // which are rounded
}

// On a terminal, what comes next stands in a line of its own. What is told of those to come is told
// by how many were done since the start; a point that takes long tells nothing.
TEST_F(CommandLine, SaysHowASweepGoesOnATerminal) {
  if (!has_terminals()) GTEST_SKIP() << "there are no pseudo-terminals";
  const std::string quantity = "[[axis]]\nquantity = \"friction\"\n";
  write("s.toml",
        "[parameters]\ntolerance = 1e-13\n" + quantity + "from = 0.1\nto = 0.3\npoints = 200000\n");
  write("slow.toml",
        "stop_on = \"end\"\n[parameters]\ntolerance = 1e-14\nuntil = 1e6\nno_separation = true\n" +
            quantity + "values = [0.1]\n");
  for (const bool is_resumed : {false, true}) {
    double begun = 0;
    if (is_resumed) {  // where half are done
      std::string journal = content("r.csv.journal");
      const std::string row = journal.substr(journal.rfind('\n', journal.size() - 2) + 1);
      begun = static_cast<double>(rows_of("r.csv.journal").size() - 1);
      for (; begun < 100'000; ++begun) journal += row;
      write("r.csv.journal", journal);
    }
    const std::string output =
        interrupted_on_terminal(
            "$rotor sweep slow.toml --out slow.csv 2> log & $rotor sweep s.toml --out r.csv",
            "in [4-9] s,")
            .output;
    EXPECT_EQ(content("log").find(" to go"), std::string::npos) << content("log");
    const auto report = output.rfind(" to go (Ctrl-C stops)");
    ASSERT_NE(report, std::string::npos) << output;
    EXPECT_NE(output.find("stops)  ^C\r\n", report), std::string::npos) << output;
    double done = 0, elapsed_s = 0, rate = 0, to_go = 0;
    std::array<char, 8> unit{};
    const auto said = output.rfind('\r', output.find(" of 200000 points in "));
    ASSERT_EQ(std::sscanf(output.c_str() + said,
                          "\r%lf of 200000 points in %lf s, %lf a second; about %lf %7[a-z] to go",
                          &done, &elapsed_s, &rate, &to_go, unit.data()),
              5)
        << output;
    EXPECT_NEAR(rate * elapsed_s / (done - begun), 1, 0.17) << output;  // of whole seconds
    EXPECT_NEAR(rate * in_seconds(to_go, unit.data()) / (200'000 - done), 1, 0.4) << output;
  }
}

}  // namespace
}  // namespace rotor
