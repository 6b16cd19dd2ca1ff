/// The program runs the README's examples.
#include <gtest/gtest.h>

#include <fstream>

#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

class Readme : public CommandLine {};

TEST_F(Readme, HasExamplesThatRun) {
  std::ifstream file(ROTOR_SOURCES "/README.md");
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
  write("my-rotor.toml", scenes.front());
  for (const std::string& scene : scenes) {
    write("scene.toml", scene);
    const bool is_sweep = scene.find("[[axis]]") != std::string::npos;
    EXPECT_EQ(rotor(is_sweep ? "sweep scene.toml --dry-run" : "run --scene scene.toml").status, 0)
        << scene;
  }
  for (const std::string& run : runs) EXPECT_EQ(rotor(run).status, 0) << run;
}

TEST(Citation, HasTheVersionOfTheProgram) {
  std::ifstream file(ROTOR_SOURCES "/CITATION.cff");
  const std::string all{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(all.find("\nversion: " ROTOR_VERSION "\n"), std::string::npos);
}

}  // namespace
}  // namespace rotor
