#include "model/simulation/summary.hpp"

#include <algorithm>

namespace rotor {
namespace {

void raise(std::optional<double>& greatest, double value) {
  if (!greatest || value > *greatest) greatest = value;
}

}  // namespace

SummaryObserver SummaryObserver::with(const Scenario& scenario) const {
  SummaryObserver branch = *this;
  branch.ring_ = Ring<double>(scenario.parameters);
  branch.watch_ = OutcomeWatch(scenario);
  return branch;
}

void SummaryObserver::on_instant(const Instant& at) {
  const Motion<double> motion = at.motion();
  if (!at.motor_on && !summary_.motor_off_s) summary_.motor_off_s = at.time_s;
  if (at.separated && !summary_.speed_at_separation_Hz)
    summary_.speed_at_separation_Hz = in_Hz(motion.speed);
  note_extremes(at, motion);
  note_contact(at, motion);
  watch_.note(at);
  last_ = at;
  begun_ = true;

  summary_.outcome = watch_.outcome();
  summary_.final_speed_Hz = in_Hz(motion.speed);
  summary_.final_kinetic_energy_J = kinetic_energy(at.body, motion);
  summary_.final_q1_m = at.state[0];
  summary_.final_q2_m = at.state[1];
}

bool SummaryObserver::wants_dense_output(const double& from_s, const double& until_s) const {
  const double time_s = watch_.time_of_speed_s();
  return last_.motor_on && from_s <= time_s && time_s < until_s;
}

void SummaryObserver::on_step(const DenseOutput& step) {
  watch_.note_speed(step.at(watch_.time_of_speed_s()).state[5]);
}

bool SummaryObserver::goes_on(const Progress& now) {
  last_progress_ = now;
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

void SummaryObserver::on_maximum(const Maximum& maximum) {
  note_extremes(maximum.at, maximum.at.motion());
}

double SummaryObserver::threshold(Extreme of, const double& /*from_s*/,
                                  const double& /*until_s*/) const {
  switch (of) {
    case Extreme::displacement:
      return last_.separated ? summary_.max_displacement_m.value_or(0)
                             : summary_.max_displacement_before_loss_m;
    case Extreme::bearing_force:
      return summary_.peak_bearing_force_N;
    default:
      return summary_.peak_normal_force_N.value_or(0);
  }
}

void SummaryObserver::note_extremes(const Instant& at, const Motion<double>& motion) {
  const double displacement = motion.displacement.norm();
  if (at.separated)
    raise(summary_.max_displacement_m, displacement);
  else
    summary_.max_displacement_before_loss_m =
        std::max(summary_.max_displacement_before_loss_m, displacement);
  const Vector<double> bearings = supports_.bearing_force(motion.displacement, motion.velocity);
  summary_.peak_bearing_force_N = std::max(summary_.peak_bearing_force_N, bearings.norm());
  if (!at.touches()) return;
  const double force = -ring_.touching_force(ring_.rim_point(motion));
  if (!at.separated) raise(summary_.peak_normal_force_before_loss_N, force);
  if (force > summary_.peak_normal_force_N.value_or(0)) {
    summary_.peak_normal_force_N = force;
    summary_.peak_time_s = at.time_s;
  }
}

void SummaryObserver::note_contact(const Instant& at, const Motion<double>& motion) {
  if (begun_ && last_.touches()) summary_.contact_time_s += at.time_s - last_.time_s;
  if (at.contact != ContactState::free) {
    if (!begun_ || last_.contact == ContactState::free) {
      ++summary_.collisions;
      if (!at.separated) ++summary_.collisions_before_loss;
    }
    if (!summary_.first_contact_s) summary_.first_contact_s = at.time_s;
  }
  const bool rolls = at.contact == ContactState::rolling;
  if (rolls && !summary_.rolling_onset_s) {
    summary_.rolling_onset_s = at.time_s;
    summary_.rolling_onset_speed_Hz = in_Hz(motion.speed);
    summary_.rolling_onset_force_N = -ring_.touching_force(ring_.rim_point(motion));
  }
  if (rolls) summary_.rolling_until_s = std::nullopt;
  if (rolls_ && !rolls) summary_.rolling_until_s = at.time_s;
  if (!rolls) {
    rolls_since_ = std::nullopt;
  } else if (!rolls_ && begun_ && last_.contact != ContactState::free && last_progress_ &&
             last_progress_->time_s == at.time_s) {
    rolls_since_ = last_progress_;  // else from the next step on, whose angle is known
  }
  rolls_ = rolls;
}

}  // namespace rotor
