/// The program runs the examples of its instructions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "verification/support/command_line.hpp"
#include "verification/support/content.hpp"
#include "verification/support/pattern.hpp"

namespace rotor {
namespace {

class Readme : public CommandLine, public testing::WithParamInterface<const char*> {};

TEST_P(Readme, HasExamplesThatRun) {
  std::ifstream file(std::string(ROTOR_SOURCES "/") + GetParam());
  std::vector<std::string> scenes;
  std::vector<std::pair<std::string, std::string>> commands;  // and the comments on them
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (inside && line != "```") scenes.back() += line + '\n';
    inside = inside && line != "```";
    if (line == "```toml") inside = true, scenes.emplace_back();
    constexpr std::string_view command = "    build/rotor ";
    if (line.starts_with(command) && line.find("rotor sweep") == std::string::npos)
      commands.emplace_back(line.substr(command.size(), line.find('#') - command.size()),
                            line.substr(std::min(line.size(), line.find('#'))));
  }
  fs::create_directory_symlink(ROTOR_SOURCES "/figures", folder_ / "figures");
  ASSERT_FALSE(scenes.empty());
  EXPECT_FALSE(commands.empty());
  for (const std::string& scene : scenes) {
    const bool is_sweep = scene.find("[[axis]]") != std::string::npos;
    const std::string few = replaced(scene, "count = [0-9]+", "count = 2");
    write(is_sweep ? "damping.toml" : "my-rotor.toml", few);
    EXPECT_EQ(rotor(is_sweep ? "sweep damping.toml --force" : "run my-rotor.toml").status, 0)
        << few;
  }
  for (const auto& [run, says] : commands) {
    const Outcome outcome = rotor(run);
    EXPECT_EQ(outcome.status, 0) << run;
    for (const Match& result : matches(says, "^# (\\w+_m) ([\\d.]+)$"))
      EXPECT_FALSE(matches(outcome.output, result[1] + " +" + result[2] + "\n").empty())
          << outcome.output;
  }
}

TEST_F(CommandLine, MakesTheNumbersOfTheExamples) {
  const std::string all = content_of(ROTOR_SOURCES "/figures/program/README.md");
  const std::size_t scene = all.find("[parameters]");
  write("my-rotor.toml", all.substr(scene, all.find("```", scene) - scene));
  const Json run = summary("my-rotor.toml"),
             law = Json::parse(rotor("estimate my-rotor.toml --json 2>/dev/null").output);
  const auto said = [](const char* form, const Json& speed_Hz, const Json& force_N) {
    return fmt::format(fmt::runtime(form), speed_Hz.get<double>(), force_N.get<double>() / 1e3);
  };
  for (const std::string& sentence :
       {said("rolls from {:.1f} Hz on, largest force {:.1f} kN", run["rolling_onset_speed_Hz"],
             run["peak_normal_force_N"]),
        said("if it rolls, by closed forms: {:.1f} Hz, {:.1f} kN", law["law_rolling_speed_Hz"],
             law["law_peak_force_N"])})
    EXPECT_TRUE(has(all, sentence)) << sentence;
  const auto rows = matches(all, "\\| `(--[^`]*)` \\| (\\w+ \\| \\d+ \\| [\\d.-]+) \\|");
  for (const Match& row : rows) {
    const Json of_row = summary(row[1]), &peak_N = of_row["peak_normal_force_N"];
    EXPECT_EQ(
        fmt::format("{} | {} | {}", of_row["outcome"].get<std::string>(),
                    of_row["touch_downs"].get<int>(),
                    peak_N.is_null() ? "-" : fmt::format("{:.1f}", peak_N.get<double>() / 1e3)),
        row[2]);
  }
  EXPECT_EQ(rows.size(), 3U);
}

INSTANTIATE_TEST_SUITE_P(All, Readme, testing::Values("README.md", "figures/program/README.md"));

TEST(Citation, HasTheVersionOfTheProgram) {
  EXPECT_TRUE(has(content_of(ROTOR_SOURCES "/CITATION.cff"), "\nversion: " ROTOR_VERSION "\n"));
}

}  // namespace
}  // namespace rotor
