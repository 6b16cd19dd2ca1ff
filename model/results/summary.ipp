/// Definitions of summary.hpp, for instantiation.
#pragma once

#include <algorithm>

#include "model/mechanics/mass_loss.hpp"
#include "model/results/outcome.ipp"
#include "model/results/summary.hpp"

namespace rotor {

template <class S>
void raise(std::optional<S>& greatest, const S& value) {
  if (!greatest || value > *greatest) greatest = value;
}

template <class S>
BasicSummaryObserver<S>::BasicSummaryObserver(const Scenario& scenario)
    : ring_(scenario.parameters),
      supports_(scenario.parameters, scenario.equations),
      watch_(scenario) {
  note_parameters(scenario.parameters);
}

template <class S>
void BasicSummaryObserver<S>::note_parameters(const Parameters& p) {
  using std::sqrt;
  const S mass = stated<S>(p.mass),
          natural = sqrt(S(supports_.springs.tangent_stiffness(S(0)) / mass));
  summary_.critical_speed_Hz = in_Hz(natural);
  if (natural > 0) summary_.damping_ratio = supports_.damping / (2 * mass * natural);
  loses_mass_ = p.loses_mass;
  if (!p.loses_mass) return;
  const MassLoss<S> loss(p);
  summary_.lost_mass_kg = loss.lost_mass;
  summary_.inertia_after_loss_kg_m2 = loss.after.inertia;
}

template <class S>
BasicSummaryObserver<S> BasicSummaryObserver<S>::with(const Scenario& scenario) const {
  BasicSummaryObserver branch = *this;
  branch.ring_ = Ring<S>(scenario.parameters);
  branch.watch_ = BasicOutcomeWatch<S>(scenario);
  branch.watch_.note_speed(watch_.early_speed());
  branch.note_parameters(scenario.parameters);
  return branch;
}

template <class S>
void BasicSummaryObserver<S>::on_instant(const BasicInstant<S>& at) {
  const Motion<S> motion = at.motion();
  if (!at.motor_on && !summary_.motor_off_s) summary_.motor_off_s = at.time_s;
  if (at.mass_lost && !summary_.speed_at_mass_loss_Hz) {
    summary_.speed_at_mass_loss_Hz = in_Hz(motion.speed);
    summary_.speed_ratio_at_mass_loss =
        *summary_.speed_at_mass_loss_Hz / summary_.critical_speed_Hz;
  }
  note_extremes(at, motion);
  note_contact(at, motion);
  watch_.note(at);
  last_ = at;
  begun_ = true;

  summary_.outcome = watch_.outcome();
  summary_.mass_loss_reached = at.mass_lost && *summary_.lost_mass_kg > 0;
  summary_.motor_off_reached = !at.motor_on;
  summary_.final_time_s = at.time_s;
  summary_.final_speed_Hz = in_Hz(motion.speed);
  summary_.final_kinetic_energy_J = kinetic_energy(at.body, motion);
  summary_.final_q1_m = at.state[0];
  summary_.final_q2_m = at.state[1];
}

template <class S>
bool BasicSummaryObserver<S>::wants_dense_output(const S& from_s, const S& until_s) const {
  const S time_s = watch_.time_of_speed_s();
  return last_.motor_on && from_s <= time_s && time_s < until_s;
}

template <class S>
void BasicSummaryObserver<S>::on_step(const BasicDenseOutput<S>& step) {
  watch_.note_speed(step.at(watch_.time_of_speed_s()).state[5]);
}

template <class S>
bool BasicSummaryObserver<S>::goes_on(const BasicProgress<S>& now) {
  // Fixed steps have no dense output: the speed at the end of the step before is taken.
  const S& time_s = watch_.time_of_speed_s();
  if (!watch_.early_speed() && last_progress_ && last_progress_->time_s <= time_s &&
      time_s < now.time_s)
    watch_.note_speed(last_progress_->speed);
  last_progress_ = whirl_ = now;
  if (!rolls_) return true;
  if (!rolls_since_) rolls_since_ = now;
  if (now.time_s > rolls_since_->time_s) {
    summary_.whirl_from_s = rolls_since_->time_s;
    summary_.whirl_until_s = now.time_s;
    summary_.whirl_frequency_Hz =
        in_Hz((now.whirl_angle - rolls_since_->whirl_angle) / (now.time_s - rolls_since_->time_s));
  }
  return true;
}

template <class S>
void BasicSummaryObserver<S>::on_maximum(const BasicMaximum<S>& maximum) {
  note_extremes(maximum.at, maximum.at.motion());
}

template <class S>
S BasicSummaryObserver<S>::threshold(Extreme of, const S& /*from_s*/, const S& /*until_s*/) const {
  switch (of) {
    case Extreme::displacement:
      return last_.mass_lost ? summary_.max_displacement_m.value_or(S(0))
                             : summary_.max_displacement_before_loss_m;
    case Extreme::bearing_force:
      return summary_.peak_bearing_force_N;
    default:
      return summary_.peak_normal_force_N.value_or(S(0));
  }
}

template <class S>
void BasicSummaryObserver<S>::note_extremes(const BasicInstant<S>& at, const Motion<S>& motion) {
  const S displacement = motion.displacement.norm();
  if (at.mass_lost || !loses_mass_) raise(summary_.max_displacement_m, displacement);
  if (!at.mass_lost)
    summary_.max_displacement_before_loss_m =
        std::max(summary_.max_displacement_before_loss_m, displacement);
  const Vector<S> bearings = supports_.bearing_force(motion.displacement, motion.velocity);
  summary_.peak_bearing_force_N = std::max(summary_.peak_bearing_force_N, S(bearings.norm()));
  if (!at.touches()) return;
  const S force = -ring_.touching_force(ring_.rim_point(motion));
  if (!at.mass_lost) raise(summary_.peak_normal_force_before_loss_N, force);
  if (force > summary_.peak_normal_force_N.value_or(S(0))) {
    summary_.peak_normal_force_N = force;
    summary_.peak_time_s = at.time_s;
  }
}

template <class S>
void BasicSummaryObserver<S>::note_contact(const BasicInstant<S>& at, const Motion<S>& motion) {
  if (begun_ && last_.touches()) summary_.contact_time_s += at.time_s - last_.time_s;
  const bool begins =
      at.contact != ContactState::free && (!begun_ || last_.contact == ContactState::free);
  if (begins) {
    ++summary_.touch_downs;
    if (!at.mass_lost) ++summary_.touch_downs_before_loss;
    if (!summary_.first_contact_s) summary_.first_contact_s = at.time_s;
  }
  const bool rolls = at.contact == ContactState::rolling;
  if (rolls && !summary_.rolling_onset_s) {
    summary_.rolling_onset_s = at.time_s;
    summary_.rolling_onset_speed_Hz = in_Hz(motion.speed);
    summary_.rolling_onset_force_N = -ring_.touching_force(ring_.rim_point(motion));
  }
  if (begins || (at.event == Event::mass_loss && at.contact != ContactState::free)) {
    const BasicProgress<S> here{at.time_s, motion.speed, RotatingFrame<S>::angle(at.state)};
    if (rolls_since_ && whirl_) rolls_since_->whirl_angle += here.whirl_angle - whirl_->whirl_angle;
    whirl_ = here;
  }
  if (rolls) summary_.rolling_until_s = std::nullopt;
  if (rolls_ && !rolls) summary_.rolling_until_s = at.time_s;
  if (!rolls) {
    rolls_since_ = std::nullopt;
  } else if (!rolls_ && whirl_ && whirl_->time_s == at.time_s) {
    rolls_since_ = whirl_;  // otherwise from the end of the step
  }
  rolls_ = rolls;
}

}  // namespace rotor
