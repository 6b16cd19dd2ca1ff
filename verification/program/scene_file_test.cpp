/// Scene files, and mistakes in them.
#include "figures/scenes/scene.hpp"
#include "verification/support/in_folder.hpp"

namespace rotor {
namespace {

struct BadScene {
  std::string_view content;
  std::string_view message;  ///< what stands behind the file's name
};

void PrintTo(const BadScene& scene, std::ostream* out) { *out << '"' << scene.message << '"'; }

class SceneWithAMistake : public InFolder, public testing::WithParamInterface<BadScene> {};

TEST_P(SceneWithAMistake, IsRefusedWithLineKeyAndRemedy) {
  const fs::path file = write("scene.toml", GetParam().content);
  try {
    read_scene(file);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.substr(0, file.string().size()), file.string());
    EXPECT_NE(message.find(GetParam().message), std::string::npos) << message;
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, SceneWithAMistake,
    testing::Values(
        BadScene{"colums = []",
                 ":1: colums: unknown key; did you mean columns?; allowed here: title"},
        BadScene{"[parameters]\nmass = \"5\"",
                 ":2: mass: must be a finite number greater than 0 kg"},
        BadScene{"[parameters]\nmass = true",
                 ":2: mass: must be a finite number greater than 0 kg"},
        BadScene{"[parameters]\ninertia = 0",
                 ":2: inertia: must be a finite number greater than 0"},
        BadScene{"[parameters]\nfriction = -0.1",
                 ":2: friction: must be a finite number not below 0"},
        BadScene{"[parameters]\nfriction = nan",
                 ":2: friction: must be a finite number not below 0"},
        BadScene{"[parameters]\nuntil = inf",
                 ":2: until: must be a finite number greater than 0 s"},
        BadScene{"[parameters]\nunbalance_factor = 0.5", "must be a finite number not below 1"},
        BadScene{"title = \"\"\n[parameters]\nstator_radius = 0.06",
                 ":2: parameters: stator_radius = 0.06 m: must be larger than rotor_radius"},
        BadScene{"[parameters]\ncontact_stiffness = 0",
                 ":2: contact_stiffness: must be a finite number greater than 0 N/m"},
        BadScene{"[parameters]\ntolerance = 0.1",
                 ":2: tolerance: must be a finite number not below 1e-15 and not above 0.001"},
        BadScene{"[parameters]\nmethod = \"rk4\"\nstep_rub = 1e-20",
                 "step_rub = 1e-20 s: must be long enough"},
        BadScene{"[parameters]\ninertia = 5e-5", "moment of inertia left by the mass loss"},
        BadScene{"[parameters]\nequations = \"best\"", "must be one of: published, consistent"},
        BadScene{"columns = [\"time_s\", \"rho\"]",
                 ":1: columns: there is no column \"rho\"; did you mean rho_m?"},
        BadScene{"columns = []", ":1: columns: must be a list"},
        BadScene{"columns = [\"time_s\"]",
                 ":1: columns: must begin with \"time_s\" and have another"},
        BadScene{"columns = [\"time_s\", \"rho_m\", \"rho_m\"]",
                 ":1: columns: column \"rho_m\" stands twice"},
        BadScene{"[parameters]\nno_separation = 1", ":2: no_separation: must be true or false"},
        BadScene{"window = { from_s = 40 }", ":1: window: must lie inside the run"},
        BadScene{"columns = [\"rho_m\"]", ":1: columns: must begin with \"time_s\""},
        BadScene{"window = { from_s = 3, until_s = 30 }", ":1: window: must lie inside the run"},
        BadScene{"window = { from_s = 3, until_s = 2 }", ":1: window: must lie inside the run"},
        BadScene{"window = { from_s = 3, until_s = 3 }", ":1: window: must lie inside the run"},
        BadScene{"window = { from = \"impact\" }", ":1: from: must be \"rolling_onset\""},
        BadScene{"window = { from = \"rolling_onset\", length_s = 1e-3, from_s = 3 }",
                 ":1: window: from goes with length_s, and nothing else"},
        BadScene{"window = { until_s = 5 }\n[parameters]\nseparation_time = 1\n[[run]]\nname = "
                 "\"a\"\nuntil = 6\n[[run]]\nname = \"b\"\nuntil = 4",
                 ":1: window: must lie inside the run, with 0 <= from_s < until_s <= 4 s"},
        BadScene{"window = { from = \"rolling_onset\", length_s = inf }",
                 ":1: length_s: must be a finite number not below 0 s, not inf"},
        BadScene{"[[run]]\nfriction = 0.1", ":1: name: every [[run]] needs a name"},
        BadScene{"[[run]]\nname = \"\"", ":1: name: every [[run]] needs a name"},
        BadScene{"[[run]]\nname = \"a\"\n[[run]]\nname = \"a\"", ":3: name: there is a run \"a\""},
        BadScene{"title = ", ":1: "}),
    [](const auto& scene) { return "No" + std::to_string(scene.index); });

TEST(Scene, ThatDoesNotExistIsRefused) {
  EXPECT_THROW(read_scene("/nowhere/scene.toml"), InputError);
}

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
