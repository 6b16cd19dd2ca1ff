/// Scene files, and bad input to the command line.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "figures/csv.hpp"
#include "figures/production.hpp"
#include "figures/scene.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

fs::path figure_file(int number, std::string_view ending) {
  return fs::path(ROTOR_SCENES) /
         ("fig" + std::to_string(number / 10) + std::to_string(number % 10) + std::string(ending));
}

TEST(Figures, AreSixteenEachWithASceneAndAScript) {
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator(ROTOR_SCENES))
    scenes += entry.path().extension() == ".toml";
  EXPECT_EQ(scenes, 16);
  for (int number = 2; number <= 17; ++number) {
    EXPECT_NO_THROW(read_scene(figure_file(number, ".toml"))) << number;
    EXPECT_TRUE(fs::exists(figure_file(number, ".gp"))) << number;
  }
}

TEST(Figures, ShareTheirRunUpsAndTheirEqualRuns) {
  struct : Observer {
    using Observer::see;
    void see(const Instant&) override {}
  } blind;
  std::vector<Request> requests;
  for (int number = 2; number <= 17; ++number)
    for (const SceneRun& run : read_scene(figure_file(number, ".toml")).runs)
      requests.push_back({run.scenario, blind});
  const ProductionReport report = produce(requests);
  EXPECT_EQ(requests.size(), 30U);
  EXPECT_EQ(report.run_ups, 2);  // one by each method
  // Four ends without mass loss or with one of its own (Figs. 2, 17 b; 12; 13), Figs. 14-16, Fig.
  // 17 a, and at 29.1 s three frictions and two more stiffnesses; the three frictions by rk4 too.
  EXPECT_EQ(report.runs, 11 + 3);
}

TEST(Thinning, KeepsEveryColumnWithinItsTolerance) {
  Table full(3);
  for (int i = 0; i <= 20000; ++i) {
    const double t = i * 1e-4;
    full.add(t);
    full.add(std::sin(300 * t));
    full.add(i % 5000 == 777 ? 1 : 0);  // impacts that last a single sample
  }
  constexpr double tolerance = 1e-3;
  const Table thin = thinned(full, tolerance);
  EXPECT_LT(thin.rows(), full.rows() / 3);
  std::size_t next = 1;
  for (std::size_t i = 0; i < full.rows(); ++i) {
    while (thin.row(next)[0] < full.row(i)[0]) ++next;
    const auto a = thin.row(next - 1), b = thin.row(next);
    const double part = (full.row(i)[0] - a[0]) / (b[0] - a[0]);
    for (const std::size_t column : {1U, 2U}) {
      const double range = column == 1 ? 2 : 1;
      EXPECT_NEAR(full.row(i)[column], a[column] + part * (b[column] - a[column]),
                  1.001 * tolerance * range);
    }
  }
}

TEST(Thinning, KeepsWhatIsBesideAGap) {
  Table full(2);
  for (int i = 0; i <= 100; ++i) {
    full.add(i);
    full.add(i < 50 ? std::numeric_limits<double>::quiet_NaN() : i * i);
  }
  const Table thin = thinned(full, 1e-3);
  EXPECT_GT(thin.rows(), 10U);
  EXPECT_TRUE(std::isnan(thin.row(0)[1]));
  EXPECT_EQ(thin.row(1)[0], 49);
  EXPECT_EQ(thin.row(2)[0], 50);
  EXPECT_EQ(thin.row(thin.rows() - 1)[1], 10000);
}

/// A folder of its own, removed afterwards.
class InFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("rotor-test-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(std::string_view name, std::string_view content) const {
    std::ofstream(folder_ / name) << content;
    return folder_ / name;
  }

  fs::path folder_;
};

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
        BadScene{"colums = []", ":1: colums: unknown key; allowed here: title, columns"},
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
                 ":2: tolerance: must be a finite number greater than 0 and not above 0.001"},
        BadScene{"[parameters]\nmethod = \"rk4\"\nstep_rub = 1e-20",
                 "step_rub = 1e-20 s: must be long enough"},
        BadScene{"[parameters]\ninertia = 5e-5", "moment of inertia left by the mass loss"},
        BadScene{"[parameters]\nequations = \"best\"", "must be one of: published, consistent"},
        BadScene{"columns = [\"time_s\", \"rho\"]",
                 ":1: columns: there is no column \"rho\"; there are"},
        BadScene{"columns = []", ":1: columns: must be a list"},
        BadScene{"columns = [\"rho_m\"]", ":1: columns: must begin with \"time_s\""},
        BadScene{"title = \"a\\nb\"", ":1: title: must be a single line"},
        BadScene{"window = { from_s = 3, until_s = 30 }", ":1: window: must lie inside the run"},
        BadScene{"window = { from_s = 3, until_s = 2 }", ":1: window: must lie inside the run"},
        BadScene{"window = { from = \"impact\" }", ":1: from: must be \"rolling_onset\""},
        BadScene{"[[run]]\nfriction = 0.1", ":1: name: every [[run]] needs a name"},
        BadScene{"[[run]]\nname = \"# a\"", ":1: name: every [[run]] needs a name"},
        BadScene{"[[run]]\nname = \"a\"\n[[run]]\nname = \"a\"", ":3: name: there is a run \"a\""},
        BadScene{"title = ", ":1: "}),
    [](const auto& scene) { return "No" + std::to_string(scene.index); });

TEST(Scene, ThatDoesNotExistIsRefused) {
  EXPECT_THROW(read_scene("/nowhere/scene.toml"), InputError);
}

class CommandLine : public InFolder {
 protected:
  struct Outcome {
    int status;
    std::string output;
  };

  /// Runs the program in the folder. Standard error comes with the output.
  Outcome rotor(const std::string& arguments) const {
    const std::string command =
        "cd '" + folder_.string() + "' && '" ROTOR_PROGRAM "' " + arguments + " 2>&1";
    FILE* pipe = ::popen(command.c_str(), "r");
    std::string output;
    std::array<char, 4096> buffer{};
    while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), pipe))
      output.append(buffer.data(), size);
    return {::pclose(pipe), output};
  }

  /// Of a CSV in the folder: the header row, then the data.
  std::vector<std::string> rows_of(std::string_view name) const {
    std::ifstream file(folder_ / name);
    std::vector<std::string> rows;
    for (std::string line; std::getline(file, line);)
      if (!line.starts_with("# ")) rows.push_back(line);
    return rows;
  }

  void expect_refusal(const std::string& arguments, std::string_view message) const {
    const auto [status, output] = rotor(arguments);
    EXPECT_NE(status, 0) << arguments;
    EXPECT_NE(output.find(message), std::string::npos) << arguments << ": " << output;
    EXPECT_TRUE(fs::is_empty(folder_)) << arguments;
  }
};

TEST_F(CommandLine, RefusesBadInputAndWritesNothing) {
  expect_refusal("run --mass 0 --trace t.csv", "--mass: must be a finite number greater than 0 kg");
  expect_refusal("run --friction nan --trace t.csv",
                 "--friction: must be a finite number not below 0");
  expect_refusal("run --friction high --trace t.csv", "--friction: must be a finite number");
  expect_refusal("run --stator-radius 0.05 --trace t.csv", "must be larger than rotor_radius");
  expect_refusal("run --equations newton --trace t.csv", "must be one of: published, consistent");
  expect_refusal("run --weight 5 --trace t.csv", "--weight");
  expect_refusal("run --columns time --trace t.csv",
                 "there is no column \"time\"; there are: time_s");
  expect_refusal("run --until 1 --from 2 --trace t.csv", "--from 2: must lie inside the run");
  expect_refusal("run --scene nowhere.toml", "nowhere.toml");
  expect_refusal("run --until 0.1 --trace .", "it is a directory");
  expect_refusal("run --until 0.1 --columns time_s", "--columns requires --trace");
  expect_refusal("run --until 0.1 --method rk4 --events e.csv", "only --method event");
  expect_refusal("run --until 0.1 --trace a/t.csv --events a/t.csv", "asked for twice");
  expect_refusal("figure 18 --out f", "the figures are 2, 3, 4");
  expect_refusal("figure --scenes nowhere --out f", "--scenes nowhere: there is no such folder");
}

TEST_F(CommandLine, LeavesAnExistingFileAloneWhenARunFails) {
  write("t.csv", "precious");
  EXPECT_NE(rotor("run --method rk4 --contact-stiffness 1e13 --trace t.csv").status, 0);
  std::string content;
  std::ifstream(folder_ / "t.csv") >> content;
  EXPECT_EQ(content, "precious");
}

TEST_F(CommandLine, ListsTheEventsOfARun) {
  const auto [status, output] = rotor("run --until 29.11 --events e.csv --json");
  EXPECT_EQ(status, 0) << output;
  EXPECT_NE(output.find("\"located_events\": 4"), std::string::npos) << output;
  std::string kinds;
  for (const std::string& row : rows_of("e.csv")) kinds += row.substr(0, row.find(',')) + ' ';
  EXPECT_EQ(kinds, "event motor_off mass_loss touch_down release ring_clear ");
}

TEST_F(CommandLine, SummarisesARunAsJsonAndTracesIt) {
  const auto [status, output] =
      rotor("run --method rk4 --until 0.01 --trace t.csv --columns time_s,rho_m --json");
  EXPECT_EQ(status, 0) << output;
  EXPECT_NE(output.find("\"first_contact_s\": null"), std::string::npos) << output;
  const auto rows = rows_of("t.csv");
  ASSERT_EQ(rows.size(), 1U + 101);  // 100 steps and the start
  EXPECT_EQ(rows[0], "run,time_s,rho_m");
}

TEST_F(CommandLine, TracesWhatTheSceneSays) {
  write("scene.toml",
        "columns = [\"time_s\", \"rho_m\"]\nwindow = { from_s = 0.01, until_s = 0.02 }\n"
        "[parameters]\nuntil = 0.03\nmethod = \"rk4\"");
  const auto [status, output] = rotor("run --scene scene.toml --mass 6 --trace t.csv");
  EXPECT_EQ(status, 0) << output;
  const auto rows = rows_of("t.csv");
  ASSERT_EQ(rows.size(), 1U + 101);  // 100 steps of 1e-4 s and the start
  EXPECT_EQ(rows[0], "run,time_s,rho_m");
  EXPECT_TRUE(rows[1].starts_with("run,0.01,")) << rows[1];
}

TEST_F(CommandLine, LeavesAFiguresSceneItsOwnMethod) {
  write("fig21.toml",
        "[parameters]\nuntil = 0.1\n[[run]]\nname = \"located\"\n[[run]]\nname = "
        "\"fixed\"\nmethod = \"rk4\"");
  const auto [status, output] = rotor("figure --scenes . --out . --method event");
  EXPECT_EQ(status, 0) << output;
  std::stringstream csv;
  csv << std::ifstream(folder_ / "fig21.csv").rdbuf();
  EXPECT_NE(csv.str().find("fixed: equations published, method rk4"), std::string::npos);
  EXPECT_NE(csv.str().find("located: equations published, method event"), std::string::npos);
}

}  // namespace
}  // namespace rotor
