/// The engine against the proven values of reference-data/proven.csv, which verification/proof/
/// computes by ball arithmetic from independent equations.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>

#include "figures/data/read_csv.hpp"
#include "figures/results/json.hpp"
#include "model/digits/digits.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/pattern.hpp"

namespace rotor {
namespace {

constexpr int number_of_inputs = 16;

class Proven : public CommandLine {
 protected:
  /// What the program finds of a run that something is proven of.
  const Json& run_of(const std::string& command) {
    Json& found = runs_[command];
    if (!found.is_null()) return found;
    // Nine digits of a run from rest at mu = 0.08 take the engine half a minute.
    const int digits = command.find("--start-speed-Hz") == std::string::npos ? 6 : 9;
    const std::string without_provers_own =
        replaced(command, " --(bits|rounding) \\S+|^build/prove", "");
    const auto [status, output] =
        rotor(fmt::format("run {} --digits {} --json 2>errors", without_provers_own, digits));
    EXPECT_EQ(status, 0) << output;
    found = Json::parse(output);
    int touch_downs = 0;
    for (const Json events = found.at("events"); const Json& event : events)
      if (event.at("event") == "touch_down") {
        const std::string name = fmt::format("touch_down_{}_s", ++touch_downs);
        found[name] = event.at("time_s");
        found["errors"][name] = event.at("errors").at("time_s");
      }
    return found;
  }

 private:
  std::map<std::string, Json> runs_;
};

TEST_F(Proven, IntervalsHoldTheSureDigits) {
  const auto rows = read_csv(ROTOR_REFERENCE_DATA "/proven.csv");
  EXPECT_GT(rows.size(), 50U);
  for (const CsvRow& row : rows) {
    const Json& run = run_of(row["command"]);
    const double value = run.at(row["quantity"]).get<double>();
    const bool is_count = !run.at("errors").contains(row["quantity"]);
    // What the program's digits leave open, and that the prover's inputs are not the decimals but
    // the doubles next to them: contacts multiply the difference as they do a tolerance.
    const double tolerance = Comparison::finer * run.at("tolerance").get<double>();
    const double allowed =
        is_count ? 0
                 : run.at("errors").at(row["quantity"]).get<double>() *
                       (1 + number_of_inputs * std::numeric_limits<double>::epsilon() / tolerance);
    const std::string what = fmt::format("{} of {}", row["quantity"], row["command"]);
    EXPECT_GE(value + allowed, static_cast<double>(row.number("lower"))) << what;
    EXPECT_LE(value - allowed, static_cast<double>(row.number("upper"))) << what;
    EXPECT_LT(allowed, is_count ? 1 : std::abs(value) * 1e-5) << what;  // or it would say nothing
  }
}

}  // namespace
}  // namespace rotor
