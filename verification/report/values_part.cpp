/// The numbers in the page's texts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures/data/read_csv.hpp"
#include "figures/results/run_result.hpp"
#include "model/mechanics/mass_loss.hpp"
#include "verification/paper/words.hpp"
#include "verification/report/document.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/onset_speed.hpp"

namespace rotor {
namespace {

/// The results of a run by their keys, and the durations between them.
Json run_json(const Scenario& scenario) {
  const RunResult result = complete_run(RunUpCheckpoint(scenario), scenario, std::nullopt, nobody);
  const Summary& s = result.summary;
  Json all = to_json(result);
  if (s.rolling_onset_s && s.first_contact_s)
    all["to_rolling_s"] = *s.rolling_onset_s - *s.first_contact_s;
  if (s.rolling_onset_s && s.peak_time_s)
    all["onset_to_peak_s"] = *s.peak_time_s - *s.rolling_onset_s;
  return all;
}

/// The runs of the paper in a set of equations; only the main ones where one error is corrected.
Json runs_json(const Equations& equations, bool are_all) {
  const auto run_of = [&](const Parameters& parameters, double until_s) {
    return run_json({.parameters = parameters, .equations = equations, .until = until_s});
  };
  Json all = {{"mu_03", run_of({.friction = 0.3}, 29.35)},
              {"mu_008", run_of({.friction = 0.08}, 29.35)},
              {"t_19", run_of({.mass_loss_time = 19.1}, 19.35)},
              {"t_14", run_of({.mass_loss_time = 14.15}, 14.4)}};
  if (!are_all) return all;
  all["mu_008_dies"] = run_of({.contact_damping = 1.2e4, .friction = 0.08}, 29.35);
  all["mu_008_rolls"] = run_of({.contact_damping = 9510, .friction = 0.08}, 29.35);
  all["t_9"] = run_of({.mass_loss_time = 9.4}, 11);
  all["t_2"] = run_of({.mass_loss_time = 2.2}, 4);
  all["t_2_earlier"] = run_of({.mass_loss_time = 2}, 6);
  all["lowest_Hz"] = onset_speed_Hz(equations);
  all["near_resonance_Hz"] = near_resonance_Hz(equations);
  const auto [least_Hz, greatest_Hz] = onset_speeds_by_place(equations);
  all["lowest_by_place_Hz"] = {{"least", least_Hz}, {"greatest", greatest_Hz}};
  return all;
}

/// What the second jump adds to the rotor's momentum, and to the energy of rotor and piece.
Json mass_loss_json() {
  Scenario scenario;
  scenario.until = scenario.parameters.mass_loss_time;
  const EventRecorder seen = recorded(scenario);
  const auto before = seen.before_mass_loss().motion();
  const MassLoss<double> loss(scenario.parameters);
  const double jump = loss.velocity_jump(before.speed);
  const double v = before.mass_centre_velocity().y() + jump;  // of C_1, counted once
  return {{"jump", jump},
          {"momentum", loss.after.mass * jump},
          {"energy", loss.after.mass * jump * (v + jump / 2)},
          {"off_axis_radial_um", 1e6 * std::abs(before.mass_centre().x())},
          {"off_axis_across_um", 1e6 * std::abs(before.mass_centre().y())},
          {"off_axis_um", 1e6 * before.mass_centre().norm()}};
}

/// A rounded share in percent with its standard error, or of how many if it is the same in all.
std::string with_error(double share, double count) {
  const double percent = 100 * std::round(share * count) / count;
  if (percent == 0 || percent == 100) return fmt::format("{:.0f} % of {:.0f}", percent, count);
  const double error = std::sqrt(percent * (100 - percent) / count);
  const int decimals = error < 0.005 ? 3 : error < 0.05 ? 2 : 1;
  return fmt::format("{:.{}f} +- {:.{}f} %", percent, decimals, error, decimals);
}

}  // namespace

Json rows_by(const std::filesystem::path& csv, const std::vector<const char*>& keys) {
  Json all;
  for (const CsvRow& row : read_csv(csv)) {
    Json* of = &all;
    for (const char* key : keys)
      if (std::string text = row[key]; !text.empty()) {
        std::ranges::replace(text, '.', '_');
        of = &(*of)[text];
      }
    for (const std::string& column : row.headings()) {
      const Json number = Json::parse(row[column], nullptr, false);
      (*of)[column] = number.is_number() ? number : Json(row[column]);
    }
    if (of->contains("runs")) (*of)["agree"] = with_error(of->at("agree"), of->at("runs"));
  }
  return all;
}

Json values_json(const std::vector<Number>& numbers) {
  Json readings, corrected, printed, paper, shares;
  long draws = 0;
  for (const Number& number : numbers) {
    printed[number.id] = number.printed;
    paper[number.id] = rotor::printed(number);
    for (std::size_t set = 0; set < sets.size(); ++set) {
      const Reading::InSet& in = number.readings.front().in[set];
      shares[sets[set].name][number.id] = {{"a", 100 * in.a.holds}, {"b", 100 * in.b.holds}};
      draws = std::max(draws, in.b.spread.draws);
    }
    for (const Reading& reading : number.readings) {
      const Reading::InSet& in = reading.in[0];
      if (in.converged) readings[reading.name] = *in.converged;
      if (in.by_rk4) readings[reading.name + "_by_rk4"] = *in.by_rk4;
      if (reading.in[1].converged) corrected[reading.name] = *reading.in[1].converged;
    }
  }
  return {{"reading", readings},
          {"reading_corrected", corrected},
          {"printed", printed},
          {"paper", paper},
          {"holds_in_percent", shares},
          {"published", runs_json(Equations::published, true)},
          {"corrected", runs_json(Equations::corrected, true)},
          {"balanced", runs_json({VelocityJump::twice, GravityMoment::balanced}, false)},
          {"once", runs_json({VelocityJump::once, GravityMoment::whole}, false)},
          {"draws", draws},
          {"mass_loss", mass_loss_json()}};
}

}  // namespace rotor
