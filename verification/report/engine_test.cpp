/// The engine's interface to the page; `make check-explore` checks the page itself in a browser.
#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "verification/report/engine/explorer.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

class Explore : public CommandLine {
 protected:
  static std::string as_arguments(const Options& options) {
    std::string all;
    for (const auto& [option, text] : options)
      all += fmt::format(" --{}{}", option, text.empty() ? "" : " '" + text + "'");
    return all;
  }

  Observer null_observer_;
  Explorer explorer_;
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
