/// The engine's interface to the page; `make check-explore` checks the page itself in a browser.
#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>

#include "verification/report/engine/explorer.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

std::vector<CsvRow> printed_inputs() {
  return read_csv(fs::path(ROTOR_REFERENCE_DATA) / "printed-inputs.csv");
}

class Explore : public CommandLine {
 protected:
  static std::string as_arguments(const Options& options) {
    std::string all;
    for (const auto& [option, text] : options)
      all += fmt::format(" --{}{}", option, text.empty() ? "" : " '" + text + "'");
    return all;
  }

  Observer null_observer_;
  Explorer explorer_{printed_inputs()};
};

/// The results of a run without its cost, which is higher if the motion between steps is observed.
Json findings(Json summary) {
  summary.erase("right_hand_sides");
  return summary;
}

// To the bit, though runs share what they can.
TEST_F(Explore, SaysWhatRotorRunSays) {
  const auto summary = [&](const Options& options) {
    return findings(explorer_.run(options, null_observer_).metadata["summary"]);
  };
  const auto printed = [&](const std::string& arguments) {
    return findings(Json::parse(rotor("run --json" + arguments + " 2>/dev/null").output));
  };
  for (const Options& options : std::vector<Options>{
           {{"friction", "0.2"}, {"equations", "consistent"}},
           {{"mass-loss-time", "19.1"}, {"velocity-jump", "once"}},
           {{"mass-loss-speed-hz", "75"}, {"gravity-moment", "balanced"}},
           {{"clearance", "1e-3"}, {"start-speed-hz", "60"}},
           {{"no-mass-loss", ""}, {"until", "3"}},
           {{"mass-loss-time", "2"}, {"until", "3"}},
           {{"torque", "0.5"}, {"lost-mass", "+0.03"}},
       }) {
    const std::string arguments = as_arguments(options);
    EXPECT_EQ(summary(options), printed(" --energy" + arguments)) << arguments;
  }
  const Options by_rk4 = {{"method", "rk4"}, {"start-speed-hz", "100"}};
  EXPECT_EQ(summary(by_rk4), printed(as_arguments(by_rk4)));
}

TEST_F(Explore, RefusesInTheWordsOfTheCommandLine) {
  explorer_.run({}, null_observer_);  // leaves a run-up
  for (const Options& options : std::vector<Options>{
           {{"friction", "many"}},
           {{"until", "1e999"}},
           {{"unbalance-factor", "400"}},
           {{"stator-radius", "0.05"}},
           {{"clearance", "1e-3"}, {"stator-radius", "0.07"}},
           {{"mass-loss-speed-hz", "200"}},
           {{"no-mass-loss", ""}, {"until", "3"}, {"mass-loss-time", "1"}},
           {{"equations", "printed"}},
           {{"velocity-jump", "thrice"}},
           {{"from", "40"}},
           {{"from", "soon"}},
       }) {
    std::string refusal;
    try {
      explorer_.run(options, null_observer_);
    } catch (const std::exception& error) {
      refusal = fmt::format("rotor: {}\n", error.what());
    }
    const std::string trace = options.contains("from") ? " --trace t.csv" : "";
    EXPECT_EQ(refusal, rotor("run" + trace + as_arguments(options)).output);
  }
}

// A window may start before the checkpoints of the last run.
TEST_F(Explore, SavesTheTraceThatRotorRunWrites) {
  for (const char* from : {"29.1", "27.9", "29.099"}) {
    const Options options = {{"friction", "0.2"}, {"until", "29.11"}, {"from", from}};
    EXPECT_EQ(rotor("run --trace t.csv" + as_arguments(options)).status, 0);
    EXPECT_TRUE(explorer_.trace(options, null_observer_) == content("t.csv")) << from;  // megabytes
  }
}

// The works of the energy balance over time: at the end they are those of the summary.
TEST_F(Explore, TellsHowTheWorksGrow) {
  const Picture picture = explorer_.run({}, null_observer_);
  const Json& energy = picture.metadata["summary"]["energy_J"]["until_end"];
  EXPECT_GE(picture.works.row(0)[0], picture.metadata["from_s"]);  // not from the start of the run
  EXPECT_LE(picture.works.row(0)[0], picture.metadata["mass_loss_s"]);
  const auto last = picture.works.row(picture.works.rows() - 1);
  for (std::size_t i = 1; i < picture.works.columns(); ++i)
    EXPECT_EQ(last[i], energy[picture.metadata["works"][i].get<std::string>()]) << i;
  double friction = 0;
  for (std::size_t i = 0; i < picture.works.rows(); ++i) {
    EXPECT_LE(picture.works.row(i)[5], friction);  // it only takes
    friction = picture.works.row(i)[5];
  }
  EXPECT_LT(friction, -1000);
}

/// What is drawn for these settings, as "quantity least greatest".
std::set<std::string> drawn(const Options& options) {
  std::set<std::string> all;
  const Sweep sweep = over_printed_digits(settings_of(options).spec, printed_inputs(), 1);
  for (const Draw& draw : sweep.sample.over)
    all.insert(fmt::format("{} {} {}", draw.quantity, draw.a, draw.b));
  return all;
}

// A value other than the printed one is not varied.
TEST_F(Explore, DrawsThePrintedInputsThatAreInEffect) {
  const auto all = drawn({});
  EXPECT_TRUE(drawn({{"friction", "0.08"}}).contains("friction 0.075 0.085"));
  EXPECT_EQ(drawn({{"clearance", "0.003"}}), all);
  const std::vector<std::pair<Options, std::string>> without = {
      {{{"friction", "0.15"}}, "friction 0.25 0.35"},
      {{{"stator-radius", "0.063"}}, "clearance 0.0025 0.0035"},
      {{{"unbalance-factor", "3"}}, "lost_mass 0.02475 0.02485"},
      {{{"mass-loss-speed-hz", "100"}}, "mass_loss_time 29.05 29.15"},
      {{{"start-speed-hz", "60"}}, "mass_loss_time 29.05 29.15"}};
  for (const auto& [options, missing] : without) {
    auto expected = all;
    EXPECT_EQ(expected.erase(missing), 1U) << missing;
    EXPECT_EQ(drawn(options), expected) << missing;
  }
}

TEST_F(Explore, ShowsTheSamePartOfEachDraw) {
  const Options options = {{"until", "29.12"}};
  std::set<double> losses;
  for (long n = 0; n < 3; ++n) {
    const Picture draw = explorer_.draw(options, n, 3, null_observer_);
    const double loss_s = draw.metadata["mass_loss_s"];
    losses.insert(loss_s);
    constexpr double rounding = 1e-9;
    EXPECT_NEAR(draw.metadata["from_s"].get<double>() - loss_s, -0.02, rounding);
    EXPECT_NEAR(draw.metadata["until_s"].get<double>() - loss_s, 0.02, rounding);
    EXPECT_EQ(draw.metadata["summary"]["inputs"]["tolerance"], 1e-8);
    EXPECT_EQ(draw.metadata["drawn"].size(), drawn({}).size());
  }
  EXPECT_EQ(losses.size(), 3U);
}

// The page's scripts read only existing columns of the motion and keys of the summary.
TEST_F(Explore, ReadsNothingOfARunThatThereIsNot) {
  const Picture picture = explorer_.run({{"friction", "0.2"}}, null_observer_);
  const Json& motion = picture.metadata["motion"];
  for (const auto& entry : fs::directory_iterator(ROTOR_SOURCES "/verification/report/script")) {
    std::ifstream stream(entry.path());
    const std::string script{std::istreambuf_iterator<char>(stream), {}};
    const std::regex read(R"(\b(motion|summary|s)\.(?!js)(\w+))");
    for (std::sregex_iterator found(script.begin(), script.end(), read), end; found != end;
         ++found) {
      const std::string name = (*found)[2];
      const bool is_column = (*found)[1] == "motion";
      EXPECT_TRUE(is_column ? std::ranges::find(motion, Json(name)) != motion.end()
                            : name.find('_') == std::string::npos ||
                                  picture.metadata["summary"].contains(name))
          << entry << name;
    }
  }
}

}  // namespace
}  // namespace rotor
