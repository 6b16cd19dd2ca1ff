/// The program runs the examples of its instructions.
#include <gtest/gtest.h>

#include <fstream>

#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

class Readme : public CommandLine, public testing::WithParamInterface<const char*> {};

TEST_P(Readme, HasExamplesThatRun) {
  std::ifstream file(std::string(ROTOR_SOURCES "/") + GetParam());
  std::vector<std::string> scenes, runs;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (inside && line != "```") scenes.back() += line + '\n';
    inside = inside && line != "```";
    if (line == "```toml") inside = true, scenes.emplace_back();
    constexpr std::string_view command = "    build/rotor run ";
    if (line.starts_with(command))
      runs.push_back("run " + line.substr(command.size(), line.find('#') - command.size()));
  }
  ASSERT_FALSE(scenes.empty());
  EXPECT_FALSE(runs.empty());
  for (const std::string& scene : scenes) {
    const bool is_sweep = scene.find("[[axis]]") != std::string::npos;
    write(is_sweep ? "sweep.toml" : "my-rotor.toml", scene);
    EXPECT_EQ(rotor(is_sweep ? "sweep sweep.toml --dry-run" : "run --scene my-rotor.toml").status,
              0)
        << scene;
  }
  for (const std::string& run : runs) EXPECT_EQ(rotor(run).status, 0) << run;
}

INSTANTIATE_TEST_SUITE_P(All, Readme, testing::Values("README.md", "figures/program/README.md"));

TEST(Citation, HasTheVersionOfTheProgram) {
  std::ifstream file(ROTOR_SOURCES "/CITATION.cff");
  const std::string all{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(all.find("\nversion: " ROTOR_VERSION "\n"), std::string::npos);
}

}  // namespace
}  // namespace rotor
