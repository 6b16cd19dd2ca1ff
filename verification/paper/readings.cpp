#include "verification/paper/readings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "model/mechanics/mass_loss.hpp"

namespace rotor {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

using Value = std::optional<double>;
using Reading = std::function<Value(PaperRuns&)>;

double energy(const Instant& at) { return kinetic_energy(at.body, at.motion()); }
double rho(const Instant& at) { return at.motion().displacement.norm(); }
double speed_Hz(const Instant& at) { return in_Hz(at.state[5]); }

MassLoss<double> loss(PaperRuns& r) { return MassLoss<double>(r.parameters()); }

/// Eq. (26), Hz.
double rolling_Hz(PaperRuns& r, const Instant& at) {
  return speed_Hz(at) * r.parameters().rotor_radius / rho(at);
}
/// v_O in rolling, m/s.
double rolling_velocity(PaperRuns& r, const Instant& at) {
  return two_pi * rolling_Hz(r, at) * rho(at);
}
/// Eq. (27), J and N.
double translation(PaperRuns& r, const Instant& at) {
  return loss(r).after.mass * std::pow(rolling_velocity(r, at), 2) / 2;
}
double inertia_force(PaperRuns& r, const Instant& at) {
  return loss(r).after.mass * std::pow(two_pi * rolling_Hz(r, at), 2) * rho(at);
}
double force(PaperRuns& r, const Instant& at) {
  const Ring<double> ring(r.parameters());
  return -ring.normal_force(ring.rim_point(at.motion()));
}

/// Of an instant at high friction, if it has occurred.
template <class F>
Reading at_onset(F f) {
  return [f](PaperRuns& r) -> Value {
    const auto& at = r.high().onset();
    return at ? Value(f(r, *at)) : std::nullopt;
  };
}
template <class F>
Reading at_peak(F f) {
  return [f](PaperRuns& r) -> Value {
    const auto at = r.high().at_peak();
    return at ? Value(f(r, *at)) : std::nullopt;
  };
}
/// Of the touch-down with which continuous contact begins.
template <class F>
Reading at_touch_down(std::size_t from_last, F f) {
  return [from_last, f](PaperRuns& r) -> Value {
    const auto at = r.high().touch_down_before_rolling(from_last);
    return at ? Value(f(r, *at)) : std::nullopt;
  };
}
Reading before_loss(const std::function<double(PaperRuns&, const Instant&)>& f) {
  return [f](PaperRuns& r) -> Value { return f(r, r.high().before_loss()); };
}
Reading rolling(double PaperRun::Rolling::*of, bool first_turn, double factor = 1) {
  return [=](PaperRuns& r) -> Value {
    const auto measured = first_turn ? r.high().first_turn() : r.high().first_5_ms();
    return measured ? Value(factor * ((*measured).*of)) : std::nullopt;
  };
}
Reading input(const std::function<double(PaperRuns&)>& f) {
  return [f](PaperRuns& r) -> Value { return f(r); };
}

double energy_before(PaperRuns& r) { return energy(r.high().before_loss()); }
double since_first_contact(PaperRuns& r, const Instant& at) {
  return at.time_s - r.high().summary().first_contact_s.value_or(at.time_s);
}

/// Largest change of a result when a contact parameter is doubled and halved, %.
Reading change(double PaperInputs::*friction, const char* quantity,
               const std::function<Value(const PaperRun&)>& result) {
  return [=](PaperRuns& r) -> Value {
    const double mu = r.inputs().*friction;
    const Value as_it_is = result(r.changed(mu, quantity, 1));
    double largest = 0;
    for (const double factor : {0.5, 2.}) {
      const Value changed = result(r.changed(mu, quantity, factor));
      if (!as_it_is || !changed) return std::nullopt;
      largest = std::max(largest, std::abs(*changed / *as_it_is - 1));
    }
    return 100 * largest;
  };
}
Value peak(const PaperRun& run) { return run.summary().peak_normal_force_N; }
Value time_to_rolling(const PaperRun& run) {
  if (!run.onset()) return std::nullopt;
  return run.onset()->time_s - *run.summary().first_contact_s;
}

/// Of the separate collisions at the three frictions, s.
Reading collision(bool longest) {
  return [longest](PaperRuns& r) -> Value {
    std::vector<double> all;
    for (const PaperRun* run : {&r.high(), &r.intermediate(), &r.low()})
      for (const double duration : run->collision_durations()) all.push_back(duration);
    if (all.empty()) return std::nullopt;
    return longest ? std::ranges::max(all) : std::ranges::min(all);
  };
}
Reading steps_in(const Reading& duration) {
  return [duration](PaperRuns& r) -> Value {
    const Value value = duration(r);
    return value ? Value(*value / Scenario{}.step_rub) : std::nullopt;
  };
}

/// What the rotor and the piece have together after the loss, less what there was before, J.
double gain_by_separation(PaperRuns& r) {
  const PaperRun& run = r.high();
  const auto m = run.before_loss().motion();
  const Vector<double> piece =
      m.velocity + m.speed * quarter_turn(Vector<double>(-r.parameters().rotor_radius, 0));
  return energy(run.after_loss()) + loss(r).lost_mass * piece.squaredNorm() / 2 -
         energy(run.before_loss());
}

/// With the numbers that the text itself uses: 770 Hz, 3.5 mm, 45 Hz.
double printed_translation(PaperRuns& r) {
  return loss(r).after.mass * std::pow(two_pi * 770 * 3.5e-3, 2) / 2;
}

const std::map<std::string, Reading>& readings() {
  static const std::map<std::string, Reading> all = {
      {"speed_rad", input([](PaperRuns& r) { return two_pi * r.parameters().motor_off_Hz; })},
      {"lost_mass", input([](PaperRuns& r) { return loss(r).lost_mass; })},
      {"lost_share", input([](PaperRuns& r) { return 100 * loss(r).lost_mass / r.parameters().mass; })},
      {"inertia_left", input([](PaperRuns& r) { return loss(r).after.inertia; })},
      {"inertia_share",
       input([](PaperRuns& r) { return 100 * (1 - loss(r).after.inertia / r.parameters().inertia); })},
      {"unbalance_before",
       input([](PaperRuns& r) { return 1e5 * loss(r).before.mass * loss(r).before.eccentricity; })},
      {"unbalance_after",
       input([](PaperRuns& r) { return 1e5 * loss(r).after.mass * loss(r).after.eccentricity; })},
      {"eigenfrequency",
       input([](PaperRuns& r) {
         return in_Hz(std::sqrt(r.parameters().support_stiffness / r.parameters().mass));
       })},
      {"translation_printed", input(printed_translation)},
      {"inertia_force_printed",
       input([](PaperRuns& r) {
         return loss(r).after.mass * std::pow(two_pi * 770, 2) * 3.5e-3 / 1e3;
       })},
      {"sum_of_parts_printed",
       input([](PaperRuns& r) {
         return printed_translation(r) + loss(r).after.inertia * std::pow(two_pi * 45, 2) / 2;
       })},
      {"share_printed", input([](PaperRuns&) { return 100 * 1050. / 4000; })},
      {"steps_a_turn", input([](PaperRuns& r) {
         return 1 / (r.parameters().motor_off_Hz * Scenario{}.step_run_up);
       })},

      {"resonance_s", [](PaperRuns& r) -> Value { return r.time_at_critical_speed(); }},
      {"motor_off_s", [](PaperRuns& r) -> Value { return r.high().summary().motor_off_s; }},
      {"speed_at_loss", before_loss([](PaperRuns&, const Instant& at) { return speed_Hz(at); })},
      {"relative_velocity", before_loss([](PaperRuns& r, const Instant& at) {
         return 100 * std::hypot(at.state[3], at.state[4]) /
                (at.state[5] * r.parameters().eccentricity);
       })},
      {"c_radial", before_loss([](PaperRuns&, const Instant& at) {
         return 1e6 * std::abs(at.motion().mass_centre().x());
       })},
      {"c_distance", before_loss([](PaperRuns&, const Instant& at) {
         return 1e6 * at.motion().mass_centre().norm();
       })},
      {"c_share", before_loss([](PaperRuns& r, const Instant& at) {
         return 100 * at.motion().mass_centre().norm() / r.parameters().eccentricity;
       })},
      {"energy_before", before_loss([](PaperRuns&, const Instant& at) { return energy(at); })},
      {"piece_velocity", before_loss([](PaperRuns& r, const Instant& at) {
         return loss(r).piece_velocity(at.state[5]);
       })},
      {"velocity_jump", before_loss([](PaperRuns& r, const Instant& at) {
         return loss(r).velocity_jump(at.state[5]);
       })},
      {"separation_gain",
       [](PaperRuns& r) -> Value { return 100 * gain_by_separation(r) / energy_before(r); }},
      {"loss_of_energy",
       [](PaperRuns& r) -> Value {
         return 100 * (1 - energy(r.high().after_loss()) / energy_before(r));
       }},

      {"to_rolling", at_onset(since_first_contact)},
      {"to_peak", at_peak(since_first_contact)},
      {"hundredths_to_rolling",
       at_onset([](PaperRuns& r, const Instant& at) { return 100 * since_first_contact(r, at); })},
      {"onset_Hz", at_onset([](PaperRuns&, const Instant& at) { return speed_Hz(at); })},
      {"peak_Hz", at_peak([](PaperRuns&, const Instant& at) { return speed_Hz(at); })},
      {"drop_at_onset", at_onset([](PaperRuns& r, const Instant& at) {
         return speed_Hz(r.high().before_loss()) / speed_Hz(at);
       })},
      {"onset_kN", at_onset([](PaperRuns& r, const Instant& at) { return force(r, at) / 1e3; })},
      {"peak_kN", [](PaperRuns& r) -> Value {
         const Value value = peak(r.high());
         return value ? Value(*value / 1e3) : std::nullopt;
       }},
      {"onset_to_peak", at_onset([](PaperRuns& r, const Instant& at) {
         return 100 * (1 - force(r, at) / *peak(r.high()));
       })},
      {"onset_mm", at_onset([](PaperRuns&, const Instant& at) { return 1e3 * rho(at); })},
      {"peak_mm", at_peak([](PaperRuns&, const Instant& at) { return 1e3 * rho(at); })},
      {"onset_rolling_Hz", at_onset(rolling_Hz)},
      {"peak_rolling_Hz", at_peak(rolling_Hz)},
      {"onset_velocity", at_onset(rolling_velocity)},
      {"peak_velocity", at_peak(rolling_velocity)},
      {"onset_translation", at_onset(translation)},
      {"peak_translation", at_peak(translation)},
      {"onset_inertia_kN",
       at_onset([](PaperRuns& r, const Instant& at) { return inertia_force(r, at) / 1e3; })},
      {"peak_inertia_kN",
       at_peak([](PaperRuns& r, const Instant& at) { return inertia_force(r, at) / 1e3; })},
      {"onset_inertia_off", at_onset([](PaperRuns& r, const Instant& at) {
         return 100 * std::abs(inertia_force(r, at) / force(r, at) - 1);
       })},
      {"peak_inertia_off", at_peak([](PaperRuns& r, const Instant& at) {
         return 100 * std::abs(inertia_force(r, at) / force(r, at) - 1);
       })},
      {"onset_energy", at_onset([](PaperRuns&, const Instant& at) { return energy(at); })},
      {"peak_energy", at_peak([](PaperRuns&, const Instant& at) { return energy(at); })},
      {"onset_share_left", at_onset([](PaperRuns& r, const Instant& at) {
         return 100 * energy(at) / energy_before(r);
       })},
      {"onset_share_lost", at_onset([](PaperRuns& r, const Instant& at) {
         return 100 - 100 * energy(at) / energy_before(r);
       })},
      {"friction_share",
       [](PaperRuns& r) -> Value {
         const auto work = r.friction_until_rolling();
         return work ? Value(-100 * *work / energy_before(r)) : std::nullopt;
       }},
      {"translation_share", at_onset([](PaperRuns& r, const Instant& at) {
         return 100 * translation(r, at) / energy(at);
       })},
      {"elastic_N", at_onset([](PaperRuns& r, const Instant& at) {
         return rho(at) * r.parameters().support_stiffness / 2;
       })},
      {"damping_N", at_onset([](PaperRuns& r, const Instant& at) {
         return rolling_velocity(r, at) * r.parameters().support_damping / 2;
       })},

      {"collisions_s_last", at_touch_down(0, since_first_contact)},
      {"collisions_s_last_but_one", at_touch_down(1, since_first_contact)},
      {"collisions_J_last", at_touch_down(0, [](PaperRuns& r, const Instant& at) {
         return energy(r.high().after_loss()) - energy(at);
       })},
      {"collisions_J_last_but_one", at_touch_down(1, [](PaperRuns& r, const Instant& at) {
         return energy(r.high().after_loss()) - energy(at);
       })},
      {"sliding_s_last", at_touch_down(0, [](PaperRuns& r, const Instant& at) {
         return r.high().onset()->time_s - at.time_s;
       })},
      {"sliding_s_last_but_one", at_touch_down(1, [](PaperRuns& r, const Instant& at) {
         return r.high().onset()->time_s - at.time_s;
       })},
      {"sliding_J_last", at_touch_down(0, [](PaperRuns& r, const Instant& at) {
         return energy(at) - energy(*r.high().onset());
       })},
      {"sliding_J_last_but_one", at_touch_down(1, [](PaperRuns& r, const Instant& at) {
         return energy(at) - energy(*r.high().onset());
       })},
      {"force_ratio_last", at_touch_down(0, [](PaperRuns& r, const Instant& at) {
         return *peak(r.high()) / r.high().peak_until(at.time_s);
       })},
      {"force_ratio_last_but_one", at_touch_down(1, [](PaperRuns& r, const Instant& at) {
         return *peak(r.high()) / r.high().peak_until(at.time_s);
       })},

      {"whirl_5_ms", rolling(&PaperRun::Rolling::whirl_Hz, false)},
      {"whirl_turn", rolling(&PaperRun::Rolling::whirl_Hz, true)},
      {"q1_5_ms", rolling(&PaperRun::Rolling::q1_Hz, false)},
      {"q1_turn", rolling(&PaperRun::Rolling::q1_Hz, true)},
      {"q1_off_whirl",
       [](PaperRuns& r) -> Value {
         const auto m = r.high().first_5_ms();
         return m ? Value(100 * std::abs(m->q1_Hz / m->whirl_Hz - 1)) : std::nullopt;
       }},
      {"whirl_period",
       [](PaperRuns& r) -> Value {
         const auto m = r.high().first_5_ms();
         return m ? Value(1 / m->whirl_Hz) : std::nullopt;
       }},
      {"whirl_ratio",
       [](PaperRuns& r) -> Value {
         const auto m = r.high().first_5_ms();
         return m ? Value(m->whirl_Hz / r.parameters().motor_off_Hz) : std::nullopt;
       }},
      {"ripple_5_ms", rolling(&PaperRun::Rolling::ripple, false, 100)},
      {"ripple_turn", rolling(&PaperRun::Rolling::ripple, true, 100)},
      {"decrease_a_turn", rolling(&PaperRun::Rolling::decrease_a_turn, false, 100)},
      {"whirl_sense", at_onset([](PaperRuns&, const Instant& at) {
         const auto m = at.motion();
         return cross(m.displacement, m.velocity) * m.speed > 0 ? 1. : -1.;
       })},

      {"low_collisions_s",
       [](PaperRuns& r) -> Value {
         const auto at = r.low().last_touch_down();
         return at ? Value(at->time_s - *r.low().summary().first_contact_s) : std::nullopt;
       }},
      {"low_force_left",
       [](PaperRuns& r) -> Value {
         const Instant& at = r.low().last();
         if (!at.touches()) return std::nullopt;
         return 100 * force(r, at) / *peak(r.low());
       }},
      {"low_rolls", [](PaperRuns& r) -> Value { return r.low().onset() ? 1. : 0.; }},
      {"shortest_s", collision(false)},
      {"longest_s", collision(true)},
      {"shortest_steps", steps_in(collision(false))},
      {"longest_steps", steps_in(collision(true))},

      {"peak_kN_100",
       [](PaperRuns& r) -> Value {
         const Value value = peak(r.at_100_Hz());
         return value ? Value(*value / 1e3) : std::nullopt;
       }},
      {"peak_kN_75",
       [](PaperRuns& r) -> Value {
         const Value value = peak(r.at_75_Hz());
         return value ? Value(*value / 1e3) : std::nullopt;
       }},
      {"rolls_at_100", [](PaperRuns& r) -> Value { return r.at_100_Hz().onset() ? 1. : 0.; }},
      {"Hz_100", [](PaperRuns& r) -> Value { return speed_Hz(r.at_100_Hz().before_loss()); }},
      {"Hz_75", [](PaperRuns& r) -> Value { return speed_Hz(r.at_75_Hz().before_loss()); }},
      {"Hz_50", [](PaperRuns& r) -> Value { return speed_Hz(r.at_50_Hz().before_loss()); }},
      {"Hz_critical", [](PaperRuns& r) -> Value { return speed_Hz(r.near_critical().before_loss()); }},
      {"collisions_50",
       [](PaperRuns& r) -> Value { return static_cast<double>(r.at_50_Hz().summary().collisions); }},
      {"collisions_critical",
       [](PaperRuns& r) -> Value {
         return static_cast<double>(r.near_critical().summary().collisions);
       }},

      {"k_t_peak", change(&PaperInputs::mu_high, "contact_stiffness", peak)},
      {"k_t_time", change(&PaperInputs::mu_high, "contact_stiffness", time_to_rolling)},
      {"d_t_peak", change(&PaperInputs::mu_high, "contact_damping", peak)},
      {"d_t_time", change(&PaperInputs::mu_high, "contact_damping", time_to_rolling)},
      {"d_t_peak_low", change(&PaperInputs::mu_low, "contact_damping", peak)},
  };
  return all;
}

}  // namespace

std::optional<double> read_off(const std::string& reading, PaperRuns& runs) {
  return readings().at(reading)(runs);
}

std::vector<std::string> all_readings() {
  std::vector<std::string> all;
  for (const auto& [name, reading] : readings()) all.push_back(name);
  return all;
}

}  // namespace rotor
