/// The numbers in the page's texts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures/data/csv.hpp"
#include "figures/input/names.hpp"
#include "model/mechanics/mass_loss.hpp"
#include "verification/report/document.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/onset_speed.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

Json number_or_nothing(const std::optional<double>& value, double scale) {
  return value ? Json(*value * scale) : Json();
}

Json run_json(const Summary& s) {
  Json all = {{"outcome", name_of(s.outcome)},
              {"touch_downs", s.touch_downs},
              {"peak_kN", number_or_nothing(s.peak_normal_force_N, 1e-3)},
              {"onset_Hz", number_or_nothing(s.rolling_onset_speed_Hz, 1)},
              {"onset_kN", number_or_nothing(s.rolling_onset_force_N, 1e-3)},
              {"speed_at_loss_Hz", number_or_nothing(s.speed_at_mass_loss_Hz, 1)},
              {"greatest_rho_mm", number_or_nothing(s.max_displacement_m, 1e3)},
              {"greatest_rho_before_mm", 1e3 * s.max_displacement_before_loss_m}};
  if (s.rolling_onset_s && s.first_contact_s)
    all["to_rolling_ms"] = 1e3 * (*s.rolling_onset_s - *s.first_contact_s);
  if (s.rolling_onset_s && s.peak_time_s)
    all["onset_to_peak_ms"] = 1e3 * (*s.peak_time_s - *s.rolling_onset_s);
  return all;
}

/// Runs in a set of equations.
auto runs_in(const Equations& equations) {
  return [equations](const Parameters& parameters, double until_s) {
    return run_json(
        summary_of({.parameters = parameters, .equations = equations, .until = until_s}));
  };
}

/// The runs of the paper in a set of equations.
Json runs_json(const Equations& equations) {
  const auto run_of = runs_in(equations);
  const auto [least_Hz, greatest_Hz] = onset_speeds_by_place(equations);
  const Json by_place = {{"least", least_Hz}, {"greatest", greatest_Hz}};
  return {{"name", name_of(equations)},
          {"mu_03", run_of({.friction = 0.3}, 29.35)},
          {"mu_008", run_of({.friction = 0.08}, 29.35)},
          {"mu_008_dies", run_of({.contact_damping = 1.2e4, .friction = 0.08}, 29.35)},
          {"mu_008_rolls", run_of({.contact_damping = 9510, .friction = 0.08}, 29.35)},
          {"t_19", run_of({.mass_loss_time = 19.1}, 19.35)},
          {"t_14", run_of({.mass_loss_time = 14.15}, 14.4)},
          {"t_9", run_of({.mass_loss_time = 9.4}, 11)},
          {"t_2", run_of({.mass_loss_time = 2.2}, 4)},
          {"t_2_earlier", run_of({.mass_loss_time = 2}, 6)},
          {"lowest_Hz", onset_speed_Hz(equations)},
          {"near_resonance_Hz", near_resonance_Hz(equations)},
          {"lowest_by_place_Hz", by_place}};
}

/// With gravity's moment balanced, everything else as printed.
Json balanced_json() {
  const auto run_of = runs_in({VelocityJump::twice, GravityMoment::balanced});
  return {{"mu_03", run_of({.friction = 0.3}, 29.35)},
          {"mu_008", run_of({.friction = 0.08}, 29.35)}};
}

/// What the second jump adds to the rotor's momentum, and to the energy of rotor and piece.
Json mass_loss_json() {
  Scenario scenario;
  scenario.until = scenario.parameters.mass_loss_time;
  EventRecorder seen;
  run(scenario, seen);
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

/// In percent with its standard error, or of how many if it is the same in all.
std::string with_error(double percent, double count) {
  if (percent == 0 || percent == 100) return fmt::format("{:.0f} % of {:.0f}", percent, count);
  const double error = std::sqrt(percent * (100 - percent) / count);
  return fmt::format("{:.{}f} +- {:.{}f} %", percent, error < 0.05 ? 2 : 1, error,
                     error < 0.05 ? 2 : 1);
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
    if (of->contains("runs"))
      (*of)["agree"] = with_error(100 * of->at("agree").get<double>(), of->at("runs"));
  }
  return all;
}

Json values_json(const std::vector<Number>& numbers) {
  Json readings, corrected, printed, shares;
  long draws = 0;
  for (const Number& number : numbers) {
    printed[number.id] = number.printed;
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
          {"holds_in_percent", shares},
          {"published", runs_json(Equations::published)},
          {"consistent", runs_json(Equations::consistent)},
          {"balanced", balanced_json()},
          {"draws", draws},
          {"mass_loss", mass_loss_json()}};
}

}  // namespace rotor
