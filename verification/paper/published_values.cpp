#include "verification/paper/published_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>

#include "figures/data/csv.hpp"
#include "model/mechanics/mass_loss.hpp"
#include "model/simulation/simulation.hpp"
#include "model/simulation/summary.hpp"

namespace rotor {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// A run with all its events, and O's polar angles in the first 5 ms of rolling.
class Run : public SummaryObserver {
 public:
  explicit Run(const Scenario& scenario) : SummaryObserver(scenario) {
    last = run(scenario, *this).last;
  }

  void on_instant(const Instant& at) override {
    SummaryObserver::on_instant(at);
    if (at.event == Event::none) {
      before_event_ = at;
      return;
    }
    if (at.event == Event::mass_loss) {
      before_loss = before_event_;
      after_loss = at;
    }
    if (at.event == Event::rolling_onset && !onset) onset = at;
    events.push_back(at);
  }
  bool wants_dense_output(const double& from_s, const double&) const override {
    return onset && from_s < onset->time_s + early_s;
  }
  void on_step(const DenseOutput& motion) override {
    constexpr int parts = 16;  // of a step of a turn at most
    for (int i = 0; i < parts; ++i) {
      const Instant at = motion.at(motion.from_s + (motion.until_s - motion.from_s) * i / parts);
      const double angle = std::atan2(at.state[1], at.state[0]);
      if (times_.size() > 0) turned_ += std::remainder(angle - angle_, two_pi);
      angle_ = angle;
      times_.push_back(at.time_s);
      last_q3_ = at.state[2];
    }
  }

  /// Mean frequency of O's turn in the rotating axes, Hz.
  double early_frequency() const {
    return std::abs(turned_) / (times_.back() - times_.front()) / two_pi;
  }
  /// Mean frequency of the whirl seen from the stator, Hz.
  double early_whirl() const {
    return std::abs(turned_ + last_q3_ - onset->state[2]) / (times_.back() - times_.front()) /
           two_pi;
  }

  const Instant& last_touch_down() const {
    return *std::find_if(events.rbegin(), events.rend(),
                         [](const Instant& at) { return at.event == Event::touch_down; });
  }

  /// The touch-down from which on the text counts continuous contact: the flight before the seventh
  /// lasts 0.2 ms.
  const Instant& lasting_touch_down() const {
    int number = 0;
    return *std::ranges::find_if(
        events, [&](const Instant& at) { return at.event == Event::touch_down && ++number == 6; });
  }

  /// Of the separate collisions, s.
  std::vector<double> collision_durations() const {
    std::vector<double> durations;
    double since = 0;
    for (const Instant& at : events) {
      if (at.event == Event::touch_down) since = at.time_s;
      if (at.event == Event::release) durations.push_back(at.time_s - since);
    }
    return durations;
  }

  std::vector<Instant> events;
  Instant before_loss, after_loss, last;
  std::optional<Instant> onset;  ///< of rolling

 private:
  static constexpr double early_s = 5e-3;

  Instant before_event_;
  std::vector<double> times_;
  double angle_ = 0, turned_ = 0, last_q3_ = 0;
};

/// N.
double peak(const Run& run) { return *run.summary().peak_normal_force_N; }

/// Runs that are computed when they are first needed, each once.
class Runs {
 public:
  const Run& rub(double friction) { return rub({.friction = friction}); }
  const Run& rub(const Parameters& parameters) { return get({.parameters = parameters}); }
  const Run& loss_at(double time_s, double until_s) {
    return get({.parameters = {.separation_time = time_s}, .until = until_s});
  }
  /// Largest normal force at a friction until a time, N.
  double peak_until(double friction, double until_s) {
    return peak(get({.parameters = {.friction = friction}, .until = until_s}));
  }

  /// Of all separate collisions at the three frictions, s.
  std::pair<double, double> shortest_and_longest_collision() {
    std::vector<double> all;
    for (const double friction : {0.3, 0.2, 0.08})
      for (const double duration : rub(friction).collision_durations()) all.push_back(duration);
    const auto [least, greatest] = std::ranges::minmax(all);
    return {least, greatest};
  }

 private:
  const Run& get(const Scenario& scenario) {
    const auto found = std::ranges::find(runs_, scenario, &Entry::scenario);
    return found != runs_.end() ? found->run : runs_.emplace_back(scenario).run;
  }

  struct Entry {
    Scenario scenario;
    Run run;
    explicit Entry(const Scenario& of) : scenario(of), run(of) {}
  };
  std::deque<Entry> runs_;  // which stay where they are
};

/// Largest relative change of a result when one parameter is doubled and halved, %.
template <class Result>
double largest_change(Runs& runs, double friction, double Parameters::*of, const Result& result) {
  const double as_it_is = result(runs.rub(friction));
  double largest = 0;
  for (const double factor : {0.5, 2.}) {
    Parameters changed{.friction = friction};
    changed.*of *= factor;
    largest = std::max(largest, std::abs(result(runs.rub(changed)) / as_it_is - 1));
  }
  return 100 * largest;
}

double time_to_rolling(const Run& run) {
  return *run.summary().rolling_onset_s - *run.summary().first_contact_s;
}

double energy(const Instant& at) { return kinetic_energy(at.body, at.motion()); }

const Parameters parameters{};
const MassLoss<double> loss(parameters);
const double read_off_whirl = two_pi * 770, read_off_rho = 3.5e-3;  // what Eq. (27) is fed with

/// v_O in rolling: r q3'.
double rolling_velocity(const Run& run) { return parameters.rotor_radius * run.onset->state[5]; }

double rolling_rho(const Run& run) { return run.onset->motion().displacement.norm(); }

/// Eq. (26), Hz.
double rolling_frequency(const Run& run) {
  return *run.summary().rolling_onset_speed_Hz * parameters.rotor_radius / rolling_rho(run);
}

double gain_by_separation(const Run& run) {
  const Instant after = *std::ranges::find(run.events, Event::mass_loss, &Instant::event);
  const auto m = run.before_loss.motion();
  const Vector<double> piece =
      m.velocity + m.speed * quarter_turn(Vector<double>(-parameters.rotor_radius, 0));
  return energy(after) + loss.lost_mass * piece.squaredNorm() / 2 - energy(run.before_loss);
}

using Computation = std::function<double(Runs&)>;

/// By id, in the unit of the row.
const std::map<std::string, Computation>& computations() {
  static const std::map<std::string, Computation> all = {
      {"f_max_rad", [](Runs&) { return two_pi * parameters.motor_off_Hz; }},
      {"m_u", [](Runs&) { return loss.lost_mass; }},
      {"m_u_g", [](Runs&) { return 1e3 * loss.lost_mass; }},
      {"m_u_share", [](Runs&) { return 100 * loss.lost_mass / parameters.mass; }},
      {"I_C1", [](Runs&) { return loss.after.inertia; }},
      {"I_C1_share", [](Runs&) { return 100 * (1 - loss.after.inertia / parameters.inertia); }},
      {"v_DC", [](Runs& r) { return loss.piece_velocity(r.rub(0.3).before_loss.state[5]); }},
      {"delta_vy", [](Runs& r) { return loss.velocity_jump(r.rub(0.3).before_loss.state[5]); }},
      {"unbalance_before", [](Runs&) { return 1e5 * loss.before.mass * loss.before.eccentricity; }},
      {"unbalance_after", [](Runs&) { return 1e5 * loss.after.mass * loss.after.eccentricity; }},
      {"eigenfrequency",
       [](Runs&) { return std::sqrt(parameters.support_stiffness / parameters.mass) / two_pi; }},
      {"motor_off", [](Runs& r) { return *r.rub(0.3).summary().motor_off_s; }},
      {"f_at_loss", [](Runs& r) { return *r.rub(0.3).summary().speed_at_separation_Hz; }},
      {"c_offset",
       [](Runs& r) { return 1e6 * r.rub(0.3).before_loss.motion().mass_centre().norm(); }},
      {"loss_energy", [](Runs& r) { return gain_by_separation(r.rub(0.3)); }},
      {"first_to_rolling", [](Runs& r) { return time_to_rolling(r.rub(0.3)); }},
      {"f_at_onset", [](Runs& r) { return *r.rub(0.3).summary().rolling_onset_speed_Hz; }},
      {"speed_drop",
       [](Runs& r) {
         const Summary& s = r.rub(0.3).summary();
         return *s.speed_at_separation_Hz / *s.rolling_onset_speed_Hz;
       }},
      {"F_n_onset_range",
       [](Runs& r) { return *r.rub(0.3).summary().rolling_onset_force_N / 1e3; }},
      {"F_n_onset", [](Runs& r) { return *r.rub(0.3).summary().rolling_onset_force_N / 1e3; }},
      {"F_n_peak", [](Runs& r) { return *r.rub(0.3).summary().peak_normal_force_N / 1e3; }},
      {"f_rol", [](Runs& r) { return r.rub(0.3).early_whirl(); }},
      {"f_q1", [](Runs& r) { return r.rub(0.3).early_frequency(); }},
      {"f_rol_26", [](Runs& r) { return rolling_frequency(r.rub(0.3)); }},
      {"rho_rolling", [](Runs& r) { return 1e3 * rolling_rho(r.rub(0.3)); }},
      {"whirl_period", [](Runs& r) { return 1 / r.rub(0.3).early_whirl(); }},
      {"v_O", [](Runs& r) { return rolling_velocity(r.rub(0.3)); }},
      {"T_tra",
       [](Runs&) { return loss.after.mass * std::pow(read_off_whirl * read_off_rho, 2) / 2; }},
      {"F_in",
       [](Runs&) {
         return loss.after.mass * read_off_whirl * read_off_whirl * read_off_rho / 1e3;
       }},
      {"T_tra_run",
       [](Runs& r) { return loss.after.mass * std::pow(rolling_velocity(r.rub(0.3)), 2) / 2; }},
      {"F_in_run",
       [](Runs& r) {
         const double whirl = two_pi * rolling_frequency(r.rub(0.3));
         return loss.after.mass * whirl * whirl * rolling_rho(r.rub(0.3)) / 1e3;
       }},
      {"T_before", [](Runs& r) { return energy(r.rub(0.3).before_loss); }},
      {"collisions_last",
       [](Runs& r) {
         return r.rub(0.3).lasting_touch_down().time_s - *r.rub(0.3).summary().first_contact_s;
       }},
      {"collisions_cost",
       [](Runs& r) {
         return energy(r.rub(0.3).after_loss) - energy(r.rub(0.3).lasting_touch_down());
       }},
      {"sliding_lasts",
       [](Runs& r) { return r.rub(0.3).onset->time_s - r.rub(0.3).lasting_touch_down().time_s; }},
      {"sliding_costs",
       [](Runs& r) { return energy(r.rub(0.3).lasting_touch_down()) - energy(*r.rub(0.3).onset); }},
      {"T_at_onset", [](Runs& r) { return energy(*r.rub(0.3).onset); }},
      {"T_share",
       [](Runs& r) { return 100 * energy(*r.rub(0.3).onset) / energy(r.rub(0.3).before_loss); }},
      {"T_dissipated",
       [](Runs& r) {
         return 100 - 100 * energy(*r.rub(0.3).onset) / energy(r.rub(0.3).before_loss);
       }},
      {"bearing_elastic",
       [](Runs& r) { return rolling_rho(r.rub(0.3)) * parameters.support_stiffness / 2; }},
      {"bearing_damping",
       [](Runs& r) { return rolling_velocity(r.rub(0.3)) * parameters.support_damping / 2; }},
      {"collisions_008",
       [](Runs& r) {
         return r.rub(0.08).last_touch_down().time_s - *r.rub(0.08).summary().first_contact_s;
       }},
      {"collision_shortest", [](Runs& r) { return r.shortest_and_longest_collision().first; }},
      {"collision_longest", [](Runs& r) { return r.shortest_and_longest_collision().second; }},
      {"steps_shortest",
       [](Runs& r) { return r.shortest_and_longest_collision().first / Scenario{}.step_rub; }},
      {"steps_longest",
       [](Runs& r) { return r.shortest_and_longest_collision().second / Scenario{}.step_rub; }},
      {"steps_per_turn",
       [](Runs&) { return 1 / (parameters.motor_off_Hz * Scenario{}.step_run_up); }},
      {"F_n_100",
       [](Runs& r) { return *r.loss_at(19.1, 19.35).summary().peak_normal_force_N / 1e3; }},
      {"F_n_75",
       [](Runs& r) { return *r.loss_at(14.15, 14.4).summary().peak_normal_force_N / 1e3; }},
      {"f_19", [](Runs& r) { return *r.loss_at(19.1, 19.35).summary().speed_at_separation_Hz; }},
      {"f_14", [](Runs& r) { return *r.loss_at(14.15, 14.4).summary().speed_at_separation_Hz; }},
      {"f_9", [](Runs& r) { return *r.loss_at(9.4, 11).summary().speed_at_separation_Hz; }},
      {"f_2", [](Runs& r) { return *r.loss_at(2.2, 4).summary().speed_at_separation_Hz; }},
      {"contacts_9",
       [](Runs& r) { return static_cast<double>(r.loss_at(9.4, 11).summary().collisions); }},
      {"contacts_2",
       [](Runs& r) { return static_cast<double>(r.loss_at(2.2, 4).summary().collisions); }},
      {"force_ratio",
       [](Runs& r) {
         return peak(r.rub(0.3)) / r.peak_until(0.3, r.rub(0.3).lasting_touch_down().time_s);
       }},
      {"whirl_sense",
       [](Runs& r) {
         const auto m = r.rub(0.3).onset->motion();
         return cross(m.displacement, m.velocity) * m.speed > 0 ? 1 : -1;
       }},
      {"whirl_ratio", [](Runs& r) { return r.rub(0.3).early_whirl() / parameters.motor_off_Hz; }},
      {"F_n_008",
       [](Runs& r) {
         const Run& run = r.rub(0.08);
         const Ring<double> ring(parameters);
         return 100 * -ring.normal_force(ring.rim_point(run.last.motion())) / peak(run);
       }},
      {"onset_at_peak",
       [](Runs& r) {
         return 100 * *r.rub(0.3).summary().rolling_onset_force_N / peak(r.rub(0.3));
       }},
      {"stiffness_effect",
       [](Runs& r) { return largest_change(r, 0.3, &Parameters::contact_stiffness, peak); }},
      {"damping_effect",
       [](Runs& r) { return largest_change(r, 0.3, &Parameters::contact_damping, peak); }},
      {"damping_time",
       [](Runs& r) {
         return largest_change(r, 0.3, &Parameters::contact_damping, time_to_rolling);
       }},
      {"damping_effect_008",
       [](Runs& r) { return largest_change(r, 0.08, &Parameters::contact_damping, peak); }},
  };
  return all;
}

std::string verdict(const PublishedValue& value) {
  constexpr double close = 0.05;  // of the value printed, by the table's own rule
  const double off = std::max({value.least - value.computed, value.computed - value.greatest, 0.});
  if (off == 0) return "reproduced";
  if (!value.refuted_by.empty()) return "refuted";
  return off <= close * std::abs(value.least + value.greatest) / 2 ? "close" : "differs";
}

}  // namespace

std::vector<PublishedValue> published_values(const std::filesystem::path& table) {
  std::vector<PublishedValue> values;
  Runs runs;
  for (const CsvRow& row : read_csv(table)) {
    PublishedValue value{.id = row["id"],
                         .place = row["place"],
                         .kind = row["kind"],
                         .quantity = row["quantity"],
                         .printed = row["printed"],
                         .unit = row["unit"],
                         .least = static_cast<double>(row.number("least")),
                         .greatest = static_cast<double>(row.number("greatest")),
                         .expected_verdict = row["expected_verdict"],
                         .refuted_by = row["refuted_by"],
                         .reason = row["reason"],
                         .verdict = {}};
    const auto computation = computations().find(value.id);
    if (computation == computations().end()) row.fail("nothing computes the id " + value.id);
    value.computed = computation->second(runs);
    value.verdict = verdict(value);
    values.push_back(value);
  }
  return values;
}

std::vector<std::string> computed_ids() {
  std::vector<std::string> ids;
  for (const auto& [id, computation] : computations()) ids.push_back(id);
  return ids;
}

std::string to_csv(const std::vector<PublishedValue>& values) {
  std::string csv = "id,kind,printed,unit,computed,least,greatest,verdict,reason\n";
  for (const PublishedValue& v : values)
    csv += fmt::format("{},{},{},{},{:.6g},{},{},{},{}\n", v.id, v.kind, v.printed, v.unit,
                       v.computed, v.least, v.greatest, v.verdict, v.reason);
  return csv;
}

}  // namespace rotor
