/// The paper's figures: their scenes and scripts, and what they share.
#include "figures/scenes/production.hpp"
#include "figures/scenes/scene.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

fs::path figure_file(int number, std::string_view ending) {
  return fs::path(ROTOR_SCENES) /
         ("fig" + std::to_string(number / 10) + std::to_string(number % 10) + std::string(ending));
}

class FigureData : public CommandLine {};

TEST_F(FigureData, DoNotDependOnWhichFiguresAreAskedForTogether) {
  EXPECT_EQ(rotor("figure --out all").status, 0);
  for (int number = 2; number <= 17; ++number) {
    EXPECT_EQ(rotor("figure --out one " + std::to_string(number)).status, 0);
    const std::string name = figure_file(number, ".csv").filename();
    EXPECT_FALSE(content("one/" + name).empty());
    EXPECT_EQ(content("one/" + name), content("all/" + name)) << name;
  }
}

// Numbers begin with zeros as files do, and are not octal.
TEST_F(FigureData, AreNumberedInTens) {
  EXPECT_EQ(rotor("figure --out zeros 08 010").status, 0);
  for (const char* name : {"zeros/fig08.csv", "zeros/fig10.csv"})
    EXPECT_FALSE(content(name).empty()) << name;
}

// Without being told where, they stand where make looks for them.
TEST_F(FigureData, StandInTheFolderThatMakeHas) {
  EXPECT_EQ(rotor("figure 2").status, 0);
  EXPECT_FALSE(content("build/figures/fig02.csv").empty());
}

// All of this one's way is a run-up, of which nothing is left for a run behind it.
TEST_F(FigureData, AreSaidToHaveTakenWhatTheirPartsTook) {
  write("fig31.toml", "[parameters]\nstart_speed_hz = 100\nno_separation = true\nuntil = 5\n");
  const std::string output = rotor("figure 31 --scenes . --out .").output;
  double run_up_s = 0, after_s = 0;
  ASSERT_EQ(std::sscanf(output.c_str(),
                        "data of 1 figure(s): 1 run-up(s) in %lf s, 1 run(s) after it in %lf s",
                        &run_up_s, &after_s),
            2)
      << output;
  EXPECT_GT(run_up_s, 10 * after_s);
}

TEST_F(FigureData, AreThoseOfScenesThatAreNamedLikeThemAlone) {
  for (const char* name : {"fig31-old.toml", "31.toml", "fig3.toml", "afig31.toml", "fig31.toml~"})
    write(name, "[parameters]\nstart_speed_hz = 150\nuntil = 0.01\n");
  expect_refusal("figure --scenes . --out o", "there is no figNN.toml in this folder");
}

TEST(Figures, OfThePaperEachHaveASceneAndAScript) {
  for (int number = 2; number <= 17; ++number) {
    EXPECT_NO_THROW(read_scene(figure_file(number, ".toml"))) << number;
    EXPECT_TRUE(fs::exists(figure_file(number, ".gp"))) << number;
  }
}

TEST(Figures, ShareTheirRunUpsAndTheirEqualRuns) {
  Observer null_observer;
  std::vector<Request> requests;
  for (int number = 2; number <= 17; ++number)
    for (const SceneRun& run : read_scene(figure_file(number, ".toml")).runs)
      requests.push_back({run.scenario, null_observer});
  const ProductionReport report = produce(requests);
  EXPECT_EQ(requests.size(), 30U);
  EXPECT_EQ(report.run_ups, 2);  // one by each method
  // Four ends without mass loss or with one of its own (Figs. 2, 17 b; 12; 13), Figs. 14-16, Fig.
  // 17 a, and at 29.1 s three frictions and two more stiffnesses; the three frictions by rk4 too.
  EXPECT_EQ(report.runs, 11 + 3);
}

}  // namespace
}  // namespace rotor
