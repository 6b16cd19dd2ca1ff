/// What the READMEs say in numbers, held against the engine.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "figures/data/csv.hpp"
#include "model/simulation/simulation.hpp"
#include "model/theory/mass_loss_response.hpp"
#include "model/theory/whirl.hpp"
#include "verification/paper/claims_table.hpp"
#include "verification/paper/judged.hpp"
#include "verification/paper/reasons.hpp"
#include "verification/support/markdown_table.hpp"
#include "verification/support/run_summary.hpp"

namespace rotor {
namespace {

std::vector<Cells> table(const std::string& heading, const std::string& readme = "README.md") {
  std::ifstream file(ROTOR_SOURCES "/" + readme);
  return markdown_table({std::istreambuf_iterator<char>(file), {}}, heading);
}

class Readme : public RunSummary {
 protected:
  /// Its words, with single blanks between them.
  static std::string text() {
    std::ifstream file(ROTOR_SOURCES "/README.md");
    std::string all;
    for (std::string word; file >> word;) all += word + ' ';
    return all;
  }
  static void expect_said(const std::string& sentence) {
    EXPECT_NE(text().find(sentence), std::string::npos) << "does not say: " << sentence;
  }

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

TEST_F(Readme, ShowsWhatEachCorrectionDoesOnItsOwn) {
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

TEST_F(Readme, ShowsBothSetsOfEquationsBesideThePaper) {
  const auto rows = table("| mass loss | |");
  ASSERT_EQ(rows.size(), 8U);
  expect_said("before resonance, up to 2.08 s (2.05 s put right), touches the ring too");
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

TEST_F(Readme, ShowsTheDigitsThatItsExampleGives) {
  const std::string example = "--friction 0.05 --until 29.23 --digits 6", key = "final_q2_m";
  const auto [status, printed] = rotor("run " + example + " 2>messages");
  EXPECT_EQ(status, 0);
  std::istringstream line(printed.substr(printed.find(key) + key.size()));
  std::string digits;
  line >> digits;
  expect_said("build/rotor run " + example + " # " + key + ' ' + digits + ' ');
}

TEST_F(Readme, ShowsWhatItsThreeCasesGive) {
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
  for (const std::string& line : commands)  // the one with digits is run for them
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

TEST_F(Readme, SaysHowOftenTheReasonsFail) {
  std::map<std::string, std::string> shares;
  for (const CsvRow& row : read_csv(ROTOR_REFERENCE_DATA "/reasons-tried.csv"))
    shares[row["reason"] + row["equations"]] =
        fmt::format("{:.0f} %", 100 * static_cast<double>(row.number("share")));
  const auto rows = table("| the text, in our words |");
  const auto reasons = read_reasons(ROTOR_REFERENCE_DATA "/reasons.csv");
  ASSERT_EQ(rows.size(), reasons.size());
  for (std::size_t n = 0; n < rows.size(); ++n)
    EXPECT_EQ(rows[n], (Cells{reasons[n].says, shares[reasons[n].id + "published"],
                              shares[reasons[n].id + "consistent"]}));
  EXPECT_EQ(shares["speed_forcepublished"], "0 %");  // without exception
}

TEST_F(Readme, SaysWhereWhirlCanLast) {
  const Whirl whirl(Parameters{});
  const double speed = 2 * std::numbers::pi * 150;
  expect_said(
      fmt::format("could last from mu = {:.4f} on at 150 Hz", whirl.rolling_friction(speed)));
  expect_said(fmt::format("lasts up to mu = {:.3f};", whirl.synchronous_friction(speed)));
  expect_said("the border of contact begins at 51.80 or 94.29 Hz");
  const auto touches = [](Equations set, double speed_Hz) {
    return MassLossResponse({}, set, 2 * std::numbers::pi * speed_Hz).first_contact().has_value();
  };
  for (const auto& [set, border_Hz] :
       {std::pair(Equations::published, 51.80), {Equations::consistent, 94.29}}) {
    EXPECT_FALSE(touches(set, border_Hz - 0.005));
    EXPECT_TRUE(touches(set, border_Hz + 0.005));
  }
  // TheoryOfMaps finds it so; 120, 123 ... 180 Hz are BorderOfFriction's.
  expect_said(
      "above it, in these maps and away from the resonance, every contact ends in backward rolling "
      "or in none");
  expect_said(
      "of 21 speeds from 120 to 180 Hz none rolls at mu = 0.08 and all do at 0.1, with d_t as "
      "printed, but none at 0.15 where d_t is tenfold");
  expect_said(
      "Among these rotors speed raises the force without exception");  // as the table has it
  const Parameters p;
  expect_said(fmt::format("C moves alike to {:.1f} % wherever the piece was",
                          100 * 2 * p.eccentricity / p.rotor_radius));
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

TEST_F(Readme, CountsVerdictsAndWrongChanges) {
  std::map<std::string, int> verdicts;
  int arithmetic = 0;
  const auto& numbers = judged();
  const auto claims = verdicts_of_claims(numbers);
  for (const auto& [claim, verdict] : claims) ++verdicts[verdict];
  for (const Number& number : numbers) arithmetic += number.kind == Kind::arithmetic;
  expect_said(fmt::format(
      "Of the text's {} claims, {} are reproduced, {} lie within the rounding of its inputs, and "
      "{} "
      "are refuted",
      claims.size(), verdicts["reproduced"], verdicts["within rounding"], verdicts["refuted"]));
  expect_said(fmt::format("each of the {} numbers", numbers.size()));
  EXPECT_EQ(figures_without_claim(numbers), (std::vector{8, 9, 15, 16}));
  expect_said("About Figs. 8, 9, 15 and 16 it claims nothing");
  for (const Number& number : numbers)
    if (number.kind == Kind::simulated) {
      EXPECT_EQ(number.readings.front().everything.draws, 10000);
      EXPECT_EQ(number.readings.front().times.draws, 10000);
    }
  expect_said("over 10,000 draws of the printed digits");
  expect_said(fmt::format("{} of them arithmetic on printed numbers", arithmetic));
  const auto converged = [&](const std::string& id) {
    const auto found = std::ranges::find(numbers, id, &Number::id);
    return found->readings.front().converged.value();
  };
  expect_said(
      fmt::format("The frequency of q1 in rolling, {:.0f} Hz, is not that of the whirl, {:.0f} Hz",
                  converged("f_q1"), converged("f_rol")));
  expect_said(fmt::format("at {:.0f} % of it", 100 - converged("onset_at_peak")));
  expect_said(fmt::format(
      "Friction takes {:.0f} % of the energy until rolling, not 75 %: that is what is gone by all "
      "causes, {:.0f} %",
      converged("share_dissipated"), converged("share_lost")));
  expect_said(fmt::format("it changes the largest force by {:.0f} %, but may double the time",
                          converged("location_force")));
  EXPECT_NEAR(converged("location_time"), 100, 10);
  expect_said(fmt::format("Twice and half k_t change the largest force by up to {:.0f} %",
                          converged("stiffness_force")));
  int wrong_changes = 0;
  std::ifstream changes(ROTOR_SOURCES "/verification/robustness/mutants.txt");
  for (std::string line; std::getline(changes, line);) wrong_changes += !line.starts_with('#');
  expect_said(fmt::format("breaks the program on purpose in {} ways", wrong_changes));
}

}  // namespace
}  // namespace rotor
