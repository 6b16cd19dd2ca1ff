#include "model/simulation/summary.hpp"

#include <algorithm>
#include <numbers>

namespace rotor {
namespace {

double in_Hz(double speed) { return speed / (2 * std::numbers::pi); }

}  // namespace

void SummaryObserver::on_instant(const Instant& at) {
  const Motion<double> motion = at.motion();
  if (!at.motor_on && !summary_.motor_off_s) summary_.motor_off_s = at.time_s;
  if (at.separated && !summary_.speed_at_separation_Hz)
    summary_.speed_at_separation_Hz = in_Hz(motion.speed);
  note_extremes(at, motion);
  if (at.contact != ContactState::free) note_contact(at, motion);
  touching_ = at.contact != ContactState::free;
  separated_ = at.separated;

  summary_.final_speed_Hz = in_Hz(motion.speed);
  summary_.final_kinetic_energy_J = kinetic_energy(at.body, motion);
  summary_.final_q1_m = at.state[0];
  summary_.final_q2_m = at.state[1];
}

void SummaryObserver::on_maximum(const Maximum& maximum) {
  note_extremes(maximum.at, maximum.at.motion());
}

double SummaryObserver::threshold(Extreme of, const double& from_s, const double& until_s) const {
  switch (of) {
    case Extreme::displacement:
      if (separated_) return summary_.max_displacement_m.value_or(0);
      break;
    case Extreme::normal_force:
      return summary_.peak_normal_force_N.value_or(0);
  }
  return Observer::threshold(of, from_s, until_s);
}

void SummaryObserver::note_extremes(const Instant& at, const Motion<double>& motion) {
  if (at.separated)
    summary_.max_displacement_m =
        std::max(summary_.max_displacement_m.value_or(0), motion.displacement.norm());
  if (at.contact == ContactState::free) return;
  const double force = -ring_.normal_force(ring_.rim_point(motion));
  if (force > summary_.peak_normal_force_N.value_or(0)) {
    summary_.peak_normal_force_N = force;
    summary_.peak_time_s = at.time_s;
  }
}

void SummaryObserver::note_contact(const Instant& at, const Motion<double>& motion) {
  if (!touching_) ++summary_.collisions;
  if (!summary_.first_contact_s) summary_.first_contact_s = at.time_s;
  if (at.contact == ContactState::rolling && !summary_.rolling_onset_s) {
    summary_.rolling_onset_s = at.time_s;
    summary_.rolling_onset_speed_Hz = in_Hz(motion.speed);
    summary_.rolling_onset_force_N = -ring_.normal_force(ring_.rim_point(motion));
  }
}

}  // namespace rotor
