#include "verification/paper/readings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "model/mechanics/mass_loss.hpp"
#include "verification/support/place_of_loss.hpp"

namespace rotor {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

using Value = std::optional<double>;
using Formula = std::function<Value(PaperRuns&)>;

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

double indentation(PaperRuns& r, const Instant& at) {
  return Ring<double>(r.parameters()).rim_point(at.motion()).indentation;
}

/// Of an instant at high friction, if it has occurred.
template <class F>
Formula at_onset(F f) {
  return [f](PaperRuns& r) -> Value {
    const auto& at = r.high().onset();
    return at ? Value(f(r, *at)) : std::nullopt;
  };
}
template <class F>
Formula at_peak(F f) {
  return [f](PaperRuns& r) -> Value {
    const auto at = r.high().at_peak();
    return at ? Value(f(r, *at)) : std::nullopt;
  };
}
/// Of the touch-down with which continuous contact begins.
template <class F>
Formula at_touch_down(std::size_t from_last, F f) {
  return [from_last, f](PaperRuns& r) -> Value {
    const auto at = r.high().touch_down_before_rolling(from_last);
    return at ? Value(f(r, *at)) : std::nullopt;
  };
}
Formula before_loss(const std::function<double(PaperRuns&, const Instant&)>& f) {
  return [f](PaperRuns& r) -> Value { return f(r, r.high().before_loss()); };
}
Formula rolling(double PaperRun::Rolling::*of, bool first_turn, double factor = 1) {
  return [=](PaperRuns& r) -> Value {
    const auto measured = first_turn ? r.high().first_turn() : r.high().first_5_ms();
    return measured ? Value(factor * ((*measured).*of)) : std::nullopt;
  };
}
Formula input(const std::function<double(PaperRuns&)>& f) {
  return [f](PaperRuns& r) -> Value { return f(r); };
}

double energy_before(PaperRuns& r) { return energy(r.high().before_loss()); }
double since_first_contact(PaperRuns& r, const Instant& at) {
  return at.time_s - r.high().summary().first_contact_s.value_or(at.time_s);
}

/// Largest change of a result when a contact parameter is doubled and halved, %.
Formula change(double PaperInputs::*friction, const char* quantity,
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
Formula collision(bool longest) {
  return [longest](PaperRuns& r) -> Value {
    std::vector<double> all;
    for (const PaperRun* run : {&r.high(), &r.intermediate(), &r.low()})
      for (const double duration : run->collision_durations()) all.push_back(duration);
    if (all.empty()) return std::nullopt;
    return longest ? std::ranges::max(all) : std::ranges::min(all);
  };
}
/// The separation: what the rotor and the piece have together after it, less what there was before.
struct Gain {
  double energy;            ///< J
  Vector<double> momentum;  ///< N s
  double angular_momentum;  ///< about where C is, N m s
};
Gain gain_by_separation(PaperRuns& r) {
  const PaperRun& run = r.high();
  const MassLoss<double> its = loss(r);
  const auto before = run.before_loss().motion(), after = run.after_loss().motion();
  const Vector<double> from_O(-r.parameters().rotor_radius, 0), c = before.mass_centre();
  const Vector<double> piece = before.velocity + before.speed * quarter_turn(from_O);
  const Vector<double> momentum = its.after.mass * after.mass_centre_velocity();
  const Vector<double> arm = after.mass_centre() - c;
  const Vector<double> arm_of_piece = before.displacement + from_O - c;
  return {energy(run.after_loss()) + its.lost_mass * piece.squaredNorm() / 2 -
              energy(run.before_loss()),
          momentum + its.lost_mass * piece - its.before.mass * before.mass_centre_velocity(),
          its.after.inertia * after.speed + cross(arm, momentum) +
              its.lost_mass * cross(arm_of_piece, piece) - its.before.inertia * before.speed};
}

/// What friction takes until continuous contact begins, or from there to rolling, J.
Formula friction_work(bool sliding, std::size_t from_last) {
  return [=](PaperRuns& r) -> Value {
    const auto& work = r.friction_work();
    if (!work || work->until_touch_downs.size() <= from_last) return std::nullopt;
    const double until = *(work->until_touch_downs.rbegin() + static_cast<long>(from_last));
    return sliding ? work->until_rolling - until : until;
  };
}

/// Largest change of a result when the piece leaves from elsewhere on the rim, %.
Formula elsewhere(const std::function<Value(const Summary&)>& result) {
  return [=](PaperRuns& r) -> Value {
    const Value opposite = result(r.lost_at(0));
    double largest = 0;
    for (const int quarters : {1, 2, 3}) {
      const Value changed = result(r.lost_at(quarters * two_pi / 4));
      if (!opposite || !changed) return std::nullopt;
      largest = std::max(largest, std::abs(*changed / *opposite - 1));
    }
    return 100 * largest;
  };
}

/// By the paper's method and steps, relative to the converged value, %.
Formula off_by_own_method(const std::function<Value(const PaperRun&)>& result) {
  return [=](PaperRuns& r) -> Value {
    const Value own = result(r.high_by(Method::rk4)), converged = result(r.high_by(Method::event));
    if (!own || !converged) return std::nullopt;
    return 100 * std::abs(*own / *converged - 1);
  };
}

/// Where on the rim the loss leaves the largest unbalance: degrees from opposite to the first one.
double place_of_largest_unbalance(PaperRuns& r) {
  int best = 0;
  const auto unbalance = [&](int degrees) {
    return PlaceOfLoss(r.parameters(), degrees * two_pi / 360).unbalance();
  };
  for (int degrees = -179; degrees <= 180; ++degrees)
    if (unbalance(degrees) > unbalance(best)) best = degrees;
  return best;
}

/// With the numbers that the text itself uses: 770 Hz, 3.5 mm, 45 Hz.
double printed_translation(PaperRuns& r) {
  return loss(r).after.mass * std::pow(two_pi * 770 * 3.5e-3, 2) / 2;
}

const std::map<std::string, Formula>& readings() {
  static const std::map<std::string, Formula> all = {
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
      {"rolling_Hz_printed",
       input([](PaperRuns& r) { return 45 * r.parameters().rotor_radius / 3.5e-3; })},
      {"velocity_printed", input([](PaperRuns&) { return two_pi * 770 * 3.5e-3; })},
      {"damping_N_printed", input([](PaperRuns& r) {
         return two_pi * 770 * 3.5e-3 * r.parameters().support_damping / 2;
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
      {"energy_gain",
       [](PaperRuns& r) -> Value { return 100 * gain_by_separation(r).energy / energy_before(r); }},
      {"momentum_gain", before_loss([](PaperRuns& r, const Instant& at) {
         return 100 * gain_by_separation(r).momentum.norm() /
                (loss(r).lost_mass * loss(r).piece_velocity(at.state[5]));
       })},
      {"angular_momentum_gain", before_loss([](PaperRuns& r, const Instant& at) {
         return 100 * gain_by_separation(r).angular_momentum / (at.body.inertia * at.state[5]);
       })},
      {"speed_gain", before_loss([](PaperRuns& r, const Instant& at) {
         return 100 * (r.high().after_loss().state[5] / at.state[5] - 1);
       })},
      {"place_of_largest_unbalance", input(place_of_largest_unbalance)},
      {"elsewhere_peak", elsewhere([](const Summary& s) { return s.peak_normal_force_N; })},
      {"elsewhere_time", elsewhere([](const Summary& s) -> Value {
         if (!s.rolling_onset_s) return std::nullopt;
         return *s.rolling_onset_s - *s.first_contact_s;
       })},
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
      {"peak_share_left", at_peak([](PaperRuns& r, const Instant& at) {
         return 100 * energy(at) / energy_before(r);
       })},
      {"peak_share_lost", at_peak([](PaperRuns& r, const Instant& at) {
         return 100 - 100 * energy(at) / energy_before(r);
       })},
      {"onset_share_lost", at_onset([](PaperRuns& r, const Instant& at) {
         return 100 - 100 * energy(at) / energy_before(r);
       })},
      {"friction_share",
       [](PaperRuns& r) -> Value {
         const auto& work = r.friction_work();
         return work ? Value(100 * work->until_rolling / energy_before(r)) : std::nullopt;
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
      {"collisions_friction_last", friction_work(false, 0)},
      {"collisions_friction_last_but_one", friction_work(false, 1)},
      {"sliding_friction_last", friction_work(true, 0)},
      {"sliding_friction_last_but_one", friction_work(true, 1)},
      {"rolls", [](PaperRuns& r) -> Value { return r.high().onset() ? 1. : 0.; }},
      {"before_the_last", at_touch_down(0, [](PaperRuns& r, const Instant&) {
         return static_cast<double>(r.high().touch_downs_before_rolling()) - 1;
       })},
      {"before_the_last_but_one", at_touch_down(1, [](PaperRuns& r, const Instant&) {
         return static_cast<double>(r.high().touch_downs_before_rolling()) - 2;
       })},
      {"indentation_of_radius", at_peak([](PaperRuns& r, const Instant& at) {
         return 100 * indentation(r, at) / r.parameters().rotor_radius;
       })},
      {"indentation_of_clearance", at_peak([](PaperRuns& r, const Instant& at) {
         return 100 * indentation(r, at) / (rho(at) - indentation(r, at));
       })},
      {"speed_in_flight", [](PaperRuns& r) -> Value {
         double greatest = 0;
         for (const PaperRun* run : {&r.high(), &r.intermediate(), &r.low()})
           greatest = std::max(greatest, run->change_of_speed_in_flight());
         return 100 * greatest;
       }},
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
      {"low_lasts", [](PaperRuns& r) -> Value { return r.low().last().touches() ? 1. : 0.; }},
      {"low_slows_a_turn", [](PaperRuns& r) -> Value {
         const Instant& end = r.low().last();
         const auto from = r.low().last_touch_down();
         if (!from || !end.touches()) return std::nullopt;
         const double turns = (end.state[2] - from->state[2]) / two_pi;
         return 100 * (1 - end.state[5] / from->state[5]) / turns;
       }},
      {"low_rolls", [](PaperRuns& r) -> Value { return r.low().onset() ? 1. : 0.; }},
      {"shortest_s", collision(false)},
      {"longest_s", collision(true)},
      {"shortest_steps", input([](PaperRuns&) { return 1e-4 / Scenario{}.step_rub; })},
      {"longest_steps", input([](PaperRuns&) { return 3e-4 / Scenario{}.step_rub; })},
      {"whirl_off", off_by_own_method([](const PaperRun& run) -> Value {
         const auto m = run.first_5_ms();
         return m ? Value(m->whirl_Hz) : std::nullopt;
       })},
      {"final_speed_off",
       off_by_own_method([](const PaperRun& run) { return Value(speed_Hz(run.last())); })},

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
      {"rolls_at_75", [](PaperRuns& r) -> Value { return r.at_75_Hz().onset() ? 1. : 0.; }},
      {"collisions_100", [](PaperRuns& r) -> Value {
         const auto count = r.at_100_Hz().touch_downs_before_rolling();
         return count > 0 ? Value(count) : std::nullopt;
       }},
      {"rises_with_speed", [](PaperRuns& r) -> Value {
         const auto force = [](const PaperRun& run) { return peak(run).value_or(0); };
         return force(r.at_75_Hz()) < force(r.at_100_Hz()) && force(r.at_100_Hz()) < force(r.high())
                    ? 1.
                    : 0.;
       }},
      {"Hz_100", [](PaperRuns& r) -> Value { return speed_Hz(r.at_100_Hz().before_loss()); }},
      {"Hz_75", [](PaperRuns& r) -> Value { return speed_Hz(r.at_75_Hz().before_loss()); }},
      {"Hz_50", [](PaperRuns& r) -> Value { return speed_Hz(r.at_50_Hz().before_loss()); }},
      {"Hz_critical", [](PaperRuns& r) -> Value { return speed_Hz(r.near_critical().before_loss()); }},
      {"collisions_50",
       [](PaperRuns& r) -> Value { return static_cast<double>(r.at_50_Hz().summary().collisions); }},
      {"settled_50", [](PaperRuns& r) -> Value {
         const Instant& at = r.at_50_Hz().last();
         return 100 * std::abs(rho(at) / at.body.eccentricity - 1);
       }},
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
