/// The program, and bad input to it.
#include <array>
#include <cstdio>
#include <sstream>

#include "verification/support/in_folder.hpp"

namespace rotor {
namespace {

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
