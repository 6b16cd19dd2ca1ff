/// What the READMEs say in numbers, held against the engine.
#include "verification/support/readme.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "model/simulation/simulation.hpp"

namespace rotor {
namespace {

class ReadmeResults : public Readme {
 protected:
  /// A summary whose values have so many digits for sure.
  nlohmann::json sure_summary(const std::string& arguments, int digits) const {
    nlohmann::json found = summary(fmt::format("{} --digits {}", arguments, digits));
    for (auto& value : found)
      if (value.is_object() && value.contains("error")) value = nlohmann::json(value["value"]);
    return found;
  }

  std::string force(const nlohmann::json& summary, int digits) const {
    const auto& force = summary["peak_normal_force_N"];
    return force.is_null() ? "" : fmt::format("{:.{}f}", force.get<double>() / 1000, digits);
  }
};

TEST_F(ReadmeResults, ShowsWhatEachCorrectionDoesOnItsOwn) {
  const auto rows = table("| velocity jump | gravity's moment |");
  ASSERT_EQ(rows.size(), 4U);
  std::map<std::string, std::map<std::size_t, double>> forces;
  for (const Cells& row : rows) {
    std::size_t column = 2;
    for (const std::string loss :
         {"--separation-time 29.1", "--separation-time 19.1", "--separation-speed-hz 75"}) {
      const std::string equations =
          fmt::format(" --velocity-jump {} --gravity-moment {}", row[0], row[1]);
      const auto loss_s = summary(loss + equations)["inputs"]["separation_time"].get<double>();
      const auto found = sure_summary(fmt::format("--separation-time {}{}", loss_s, equations), 5);
      const std::string peak = force(found, 2);
      EXPECT_EQ(row[column], peak.empty() ? "no contact" : peak) << row[0] << ' ' << row[1];
      // Gravity's part, between two rows of the same jump.
      if (!peak.empty()) {
        const auto [other, is_first] = forces[row[0]].emplace(column, std::stod(peak));
        EXPECT_LT(std::abs(other->second - std::stod(peak)), 0.05);
      }
      ++column;
    }
  }
  const auto at_100_Hz = summary("--separation-speed-hz 100 --velocity-jump once");
  EXPECT_EQ(at_100_Hz["outcome"], "freed");
  EXPECT_EQ(at_100_Hz["collisions"], 2);
  EXPECT_EQ(force(at_100_Hz, 2), "6.05");
}

TEST_F(ReadmeResults, ShowsBothSetsOfEquationsBesideThePaper) {
  const auto rows = table("| mass loss | |");
  ASSERT_EQ(rows.size(), 8U);
  expect_said("greatest swing, up to 2.08 s (2.05 s put right), touches the ring too");
  for (const char* equations : {"published", "consistent"}) {
    const std::size_t column = equations == std::string("published") ? 3 : 4;
    const auto of = [&](const std::string& options) {
      return sure_summary(fmt::format("{} --equations {}", options, equations), 5);
    };
    const auto touch_downs_and_force = [&](const nlohmann::json& found) {
      return fmt::format("{}, {} kN", found["collisions"].get<int>(), force(found, 1));
    };
    const auto rub = of("");
    const double to_rolling =
        rub["rolling_onset_s"].get<double>() - rub["first_contact_s"].get<double>();
    const auto weak = of("--friction 0.08");
    const auto at_75_Hz = of("--separation-time 14.15");
    const std::string at_75_Hz_force = force(at_75_Hz, 1);
    const Cells expected = {
        rub["collisions"].dump(),
        fmt::format("{:.1f} ms", 1000 * to_rolling),
        force(rub, 1) + " kN",
        touch_downs_and_force(of("--friction 0.2")),
        touch_downs_and_force(weak) + (weak["rolling_onset_s"].is_null() ? ", no rolling" : ""),
        force(of("--separation-time 19.1"), 1) + " kN",
        at_75_Hz_force.empty() ? "no contact" : at_75_Hz_force + " kN",
    };
    for (std::size_t n = 0; n < expected.size(); ++n) EXPECT_EQ(rows[n][column], expected[n]);
    const double lowest_Hz = std::stod(rows.back()[column]), digit_Hz = 0.01;
    const auto touches = [&](const char* loss, double at) {
      return summary(fmt::format("{} {} --equations {}", loss, at, equations))["collisions"] != 0;
    };
    EXPECT_FALSE(touches("--separation-speed-hz", lowest_Hz - digit_Hz)) << equations;
    EXPECT_TRUE(touches("--separation-speed-hz", lowest_Hz + digit_Hz)) << equations;
    const double before_resonance_s = column == 3 ? 2.08 : 2.05;
    EXPECT_TRUE(touches("--separation-time", before_resonance_s)) << equations;
    EXPECT_FALSE(touches("--separation-time", before_resonance_s + 0.01)) << equations;
  }
}

TEST_F(ReadmeResults, ShowsWhatItsThreeCasesGive) {
  const auto rows = table("| `build/rotor run` |");
  ASSERT_EQ(rows.size(), 3U);
  for (const Cells& row : rows) {
    const auto found = summary(row[0]);
    EXPECT_EQ(row[1], found["outcome"]) << row[0];
    EXPECT_EQ(row[2], found["collisions"].dump()) << row[0];
    const std::string peak = force(found, 1);
    EXPECT_EQ(row[3], peak.empty() ? "-" : peak) << row[0];
  }
}

/// Has the largest force located, and nothing else, as the benchmark does.
struct LargestForce : Observer {
  double threshold(Extreme of, const double& from_s, const double& until_s) const override {
    return of == Extreme::normal_force ? largest : Observer::threshold(of, from_s, until_s);
  }
  void on_instant(const Instant& at) override {
    if (at.touches()) largest = std::max(largest, -ring.normal_force(ring.rim_point(at.motion())));
  }
  void on_maximum(const Maximum& maximum) override { on_instant(maximum.at); }

  Ring<double> ring{Parameters{}};
  double largest = 0;
};

TEST_F(Readme, CountsTheRightHandSides) {
  const auto rows =
      table("| mu = 0.3, from the mass loss to 29.2 s |", "verification/benchmark/README.md");
  ASSERT_EQ(rows.size(), 3U);
  std::vector<Scenario> scenarios(rows.size());
  scenarios[0].method = Method::rk4;
  scenarios[1].tolerance = 1e-8;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    scenarios[n].until = 29.2;
    LargestForce observer;
    Simulation simulation(scenarios[n]);
    simulation.pass_mass_loss(observer);
    const long before = simulation.counters().right_hand_sides;
    simulation.finish(observer);
    const long count = simulation.counters().right_hand_sides - before;
    const Cells& row = rows[n];
    const double said =
        std::stod(row[1].substr(0, row[1].find(',')) + row[1].substr(row[1].find(',') + 1));
    EXPECT_NEAR(static_cast<double>(count), said, said / 100) << row[0];  // as compilers may differ
  }
}

// The examples are what the program reads.
TEST_F(Readme, HasExamplesThatRun) {
  std::ifstream file(ROTOR_SOURCES "/README.md");
  std::vector<std::string> examples, commands;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line == "```toml") examples.emplace_back();
    constexpr std::string_view command = "    build/rotor run ";
    if (line.starts_with(command))
      commands.push_back("run " + line.substr(command.size(), line.find('#') - command.size()));
    if (inside && line != "```") examples.back() += line + '\n';
    inside = line == "```toml" || (inside && line != "```");
  }
  ASSERT_EQ(examples.size(), 2U);
  write("my-rotor.toml", examples[0]);
  write("damping.toml", examples[1]);
  for (const std::string& line : commands)  // RunCommand runs that with digits
    EXPECT_TRUE(line.find("--digits") != std::string::npos || rotor(line).status == 0) << line;
  EXPECT_EQ(commands.size(), 3U);
  const auto [status, output] = rotor("sweep damping.toml --dry-run");
  EXPECT_EQ(status, 0) << output;
  EXPECT_TRUE(output.starts_with("21000 points; ")) << output;
}

TEST_F(Readme, AndTheCitationNameTheSamePaperAndNoAuthorsOfIt) {
  const std::string title = "Overcritical high-speed rotor systems, full annular rub and accident";
  expect_said(title + '*');
  expect_said("names neither its authors nor journal and year");
  std::ifstream file(ROTOR_SOURCES "/CITATION.cff");
  std::string citation;
  for (std::string word; file >> word;) citation += word + ' ';
  EXPECT_NE(citation.find("title: " + title + " authors: - name: the authors of the paper"),
            std::string::npos);
  EXPECT_NE(citation.find("names neither its authors nor journal and year"), std::string::npos);
}

TEST(Citation, HasTheVersionOfTheProgram) {
  std::ifstream file(ROTOR_SOURCES "/CITATION.cff");
  const std::string all{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(all.find("\nversion: " ROTOR_VERSION "\n"), std::string::npos);
}

TEST_F(Readme, SaysWhenARunEnds) {
  const Scenario scenario;
  expect_said(fmt::format("A run ends {:.2f} s after the mass loss",
                          scenario.until - scenario.parameters.separation_time));
}

}  // namespace
}  // namespace rotor
