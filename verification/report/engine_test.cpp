/// The engine's interface to the page; `make check-explore` checks the page itself in a browser.
#include <fmt/format.h>

#include "verification/report/engine/explorer.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

class Explore : public CommandLine {
 protected:
  static std::string as_arguments(const Options& options) {
    std::string all;
    for (const auto& [option, text] : options) all += fmt::format(" --{} '{}'", option, text);
    return all;
  }

  Explorer explorer_;
};

/// The results of a run without its cost, which is higher if the motion between steps is observed.
Json findings(Json summary) {
  for (const char* cost : {"right_hand_sides", "contact_evaluations"}) summary.erase(cost);
  return summary;
}

// To the bit, though runs share what they can.
TEST_F(Explore, SaysWhatRotorRunSays) {
  for (const Options& options :
       std::vector<Options>{{{"friction", "0.2"}, {"equations", "published"}},
                            {{"mass-loss-time", "19.1"}},
                            {{"mass-loss-speed-Hz", "75"}, {"unbalance-factor", "4"}},
                            {{"clearance", "1e-3"}, {"mass-loss-time", "19.1"}},
                            {{"method", "rk4"}, {"start-speed-Hz", "100"}}}) {
    const std::string arguments = as_arguments(options);
    EXPECT_EQ(findings(explorer_.run(options).metadata["summary"]),
              findings(Json::parse(rotor("run --json" + arguments + " 2>/dev/null").output)))
        << arguments;
  }
}

TEST_F(Explore, RefusesInTheWordsOfTheCommandLine) {
  explorer_.run({});  // leaves a run-up
  for (const Options& options : std::vector<Options>{{{"friction", "many"}},
                                                     {{"unbalance-factor", "400"}},
                                                     {{"clearance", "-1"}},
                                                     {{"mass-loss-speed-Hz", "200"}}}) {
    std::string refusal;
    try {
      explorer_.run(options);
    } catch (const std::exception& error) {
      refusal = fmt::format("rotor: {}\n", error.what());
    }
    EXPECT_EQ(refusal, rotor("run" + as_arguments(options)).output);
  }
}

}  // namespace
}  // namespace rotor
