/// What scene files state; what is refused of them is in approved/refused_scenes.txt.
#include "figures/scenes/scene.hpp"
#include "verification/support/in_folder.hpp"

namespace rotor {
namespace {

// Double has a number near each.
TEST_F(InFolder, ReadsWholeNumbersAsOthers) {
  const Scene scene = read_scene(
      write("s.toml",
            "[parameters]\ncontact_damping = 9007199254740993\nstart_speed_hz = 150\nuntil = 1\n"));
  EXPECT_EQ(scene.runs.front().scenario.parameters.contact_damping, 9007199254740992.);
}

// A [[run]] that says that it loses its mass says nothing of when.
TEST_F(InFolder, KeepsTheTimeOfALossThatARunConfirms) {
  write(
      "s.toml",
      "[parameters]\nseparation_time = 2\nuntil = 3\n[[run]]\nname = \"a\"\nno_separation = false\n"
      "[[run]]\nname = \"b\"\nno_separation = true\n");
  const Scene scene = read_scene(folder_ / "s.toml", {});
  EXPECT_EQ(scene.runs[0].scenario.parameters.separation_time, 2);
  EXPECT_TRUE(scene.runs[0].scenario.parameters.separates);
  EXPECT_FALSE(scene.runs[1].scenario.parameters.separates);
}

}  // namespace
}  // namespace rotor
