/// The results of a run, and how they are gathered from what an observer is shown.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <variant>

#include "model/mechanics/mass_loss.hpp"
#include "model/results/outcome.hpp"
#include "model/scenario/observer.hpp"

namespace rotor {

/// The results in `summary_fields`. Empty: has not happened. Forces are magnitudes.
template <class S>
struct BasicSummary {
  Outcome outcome = Outcome::undecided;
  long touch_downs = 0, touch_downs_before_loss = 0, touch_downs_to_rolling = 0;
  std::optional<S> first_contact_s;
  std::optional<S> rolling_onset_s, rolling_onset_speed_Hz, rolling_onset_force_N, rolling_until_s;
  std::optional<S> peak_force_to_rolling_N;
  std::optional<S> peak_normal_force_N, peak_time_s, peak_normal_force_before_loss_N;
  std::optional<S> peak_displacement_m;
  S peak_displacement_before_loss_m{0};
  S contact_time_s{0};
  S peak_bearing_force_N{0};
  std::optional<S> whirl_frequency_Hz, whirl_from_s, whirl_until_s;
  std::optional<S> motor_off_s;
  std::optional<S> speed_at_mass_loss_Hz, speed_ratio_at_mass_loss;
  S final_time_s{0}, final_speed_Hz{0}, final_kinetic_energy_J{0}, final_q1_m{0}, final_q2_m{0};
  S critical_speed_Hz{0};
  std::optional<S> damping_ratio;
  std::optional<S> lost_mass_kg, inertia_after_loss_kg_m2;
  bool mass_loss_reached = false;
};

/// The reference of a result's relative error.
enum class ErrorScale {
  own,     ///< its magnitude
  length,  ///< the same, but at least a length that is negligible beside the clearance
  force,   ///< the same, but at least the supports' force at that length
  exact    ///< no error: it is stated, not computed
};

/// What decides a result, so that the rest of a run cannot change it; the latest one last.
enum class Settled {
  once_known,   ///< nothing but its own event: empty until then
  by_loss,      ///< the mass loss
  by_contacts,  ///< the last contact
  by_end,       ///< the end of the run
  by_stop       ///< where the run ends, early or not
};

/// One result. Text, JSON and its schema, the columns of sweeps and estimated digits all follow
/// from the table below.
template <class S>
struct SummaryField {
  using Of = BasicSummary<S>;

  std::string_view key;  ///< with its unit
  std::string_view meaning;
  std::variant<Outcome Of::*, long Of::*, bool Of::*, S Of::*, std::optional<S> Of::*> value;
  ErrorScale scale = ErrorScale::own;
  /// The larger quantity of which it is a part or difference.
  S (*error_base)(const Of&) = nullptr;
  Settled settled = Settled::once_known;

  /// Whether a run that stopped as soon as its outcome was decided has the whole run's value.
  bool is_settled(const Of& of) const {
    switch (settled) {
      case Settled::once_known:
      case Settled::by_stop:
        return true;
      case Settled::by_loss:
        return of.speed_at_mass_loss_Hz.has_value();
      case Settled::by_contacts:
        return of.outcome == Outcome::freed || of.outcome == Outcome::no_contact;
      case Settled::by_end:
        return false;
    }
    return false;
  }
};

template <class S>
inline constexpr auto summary_fields = [] {
  using Of = BasicSummary<S>;
  using enum ErrorScale;
  constexpr Settled loss = Settled::by_loss, contacts = Settled::by_contacts, end = Settled::by_end;
  constexpr auto rho = [](const Of& s) { return S(Vector<S>(s.final_q1_m, s.final_q2_m).norm()); };
  return std::to_array<SummaryField<S>>({
      {"outcome", "What became of the rotor, in one word", &Of::outcome},
      {"first_contact_s", "Time of the first touch-down", &Of::first_contact_s},
      {"touch_downs_to_rolling",
       "Number of touch-downs until rolling sets in, or all of them if it does not",
       &Of::touch_downs_to_rolling},
      {"touch_downs", "Number of touch-downs", &Of::touch_downs, own, nullptr, contacts},
      {"rolling_onset_s", "Onset of rolling: first time without slip that friction can hold",
       &Of::rolling_onset_s},
      {"rolling_onset_speed_Hz", "Rotation speed at the onset of rolling",
       &Of::rolling_onset_speed_Hz},
      {"rolling_onset_force_N", "Normal force at the onset of rolling", &Of::rolling_onset_force_N},
      {"rolling_until_s", "End of the last interval of rolling; null while the rotor rolls",
       &Of::rolling_until_s, own, nullptr, end},
      {"peak_force_to_rolling_N",
       "Largest normal force up to its first maximum after the onset of rolling, or of the whole "
       "run if rolling does not set in",
       &Of::peak_force_to_rolling_N},
      {"peak_normal_force_N", "Largest normal force", &Of::peak_normal_force_N, own, nullptr,
       contacts},
      {"peak_time_s", "Time of the largest normal force", &Of::peak_time_s, own, nullptr, contacts},
      {"peak_displacement_m",
       "Largest distance of O from O_a, the centre of the ring, after the mass loss, or in a run "
       "without one",
       &Of::peak_displacement_m, length, nullptr, end},
      {"touch_downs_before_loss",
       "Touch-downs before the mass loss; all of them in a run without one",
       &Of::touch_downs_before_loss, own, nullptr, loss},
      {"peak_normal_force_before_loss_N", "Largest normal force before the mass loss",
       &Of::peak_normal_force_before_loss_N, own, nullptr, loss},
      {"peak_displacement_before_loss_m", "Largest distance of O from O_a before the mass loss",
       &Of::peak_displacement_before_loss_m, length, nullptr, loss},
      {"contact_time_s", "Time spent sliding and rolling", &Of::contact_time_s, own,
       [](const Of& s) { return s.contact_time_s > 0 ? s.final_time_s : S(0); }, contacts},
      {"peak_bearing_force_N",
       "Largest |k r_O + d v_O|, of the supports together, without the weight, with r_O from the "
       "position of rest",
       &Of::peak_bearing_force_N, force, nullptr, end},
      {"whirl_frequency_Hz",
       "Whirl frequency of O about O_a, negative against the rotation: mean over the last interval "
       "of rolling, from whirl_from_s to whirl_until_s",
       &Of::whirl_frequency_Hz, own,
       [](const Of& s) {
         using std::abs;
         if (!s.whirl_frequency_Hz) return S(0);
         const S until = *s.whirl_until_s;
         return S(abs(*s.whirl_frequency_Hz) * until / (until - *s.whirl_from_s));
       },
       end},
      {"whirl_from_s", "Start of the interval of whirl_frequency_Hz", &Of::whirl_from_s, own,
       nullptr, end},
      {"whirl_until_s", "End of the interval of whirl_frequency_Hz", &Of::whirl_until_s, own,
       nullptr, end},
      {"motor_off_s", "Time at which the motor is switched off; null at constant speed",
       &Of::motor_off_s},
      {"speed_at_mass_loss_Hz", "Rotation speed at the mass loss", &Of::speed_at_mass_loss_Hz},
      {"speed_ratio_at_mass_loss",
       "Rotation speed at the mass loss over the critical speed; null if k = 0",
       &Of::speed_ratio_at_mass_loss},
      {"final_time_s", "End of the run, or where it stopped", &Of::final_time_s, exact, nullptr,
       Settled::by_stop},
      {"final_speed_Hz", "Rotation speed at the end", &Of::final_speed_Hz, own, nullptr, end},
      {"final_kinetic_energy_J",
       "Kinetic energy T of the rotor at the end; without that of the rotation at constant speed",
       &Of::final_kinetic_energy_J, own, nullptr, end},
      {"final_q1_m", "Coordinate of O along x of the rotating axes at the end", &Of::final_q1_m,
       length, rho, end},
      {"final_q2_m", "Coordinate of O along y of the rotating axes at the end", &Of::final_q2_m,
       length, rho, end},
      {"critical_speed_Hz", "Critical speed sqrt(k/m) / 2 pi before the mass loss",
       &Of::critical_speed_Hz},
      {"damping_ratio", "Damping ratio d / (2 sqrt(k m)) before the mass loss; null if k = 0",
       &Of::damping_ratio},
      {"lost_mass_kg", "Lost mass m_u, Eq. (5); null without mass loss", &Of::lost_mass_kg},
      {"inertia_after_loss_kg_m2",
       "Moment of inertia I_C1; null without mass loss, or at constant speed",
       &Of::inertia_after_loss_kg_m2},
      {"mass_loss_reached", "Whether mass has been lost", &Of::mass_loss_reached, own, nullptr,
       loss},
  });
}();

template <class S>
void keep_greatest(std::optional<S>& greatest, const S& value) {
  if (!greatest || value > *greatest) greatest = value;
}

/// Gathers a summary from what it is shown.
template <class S>
class BasicSummaryObserver : public BasicObserver<S> {
 public:
  explicit BasicSummaryObserver(const Scenario& scenario)
      : ring_(scenario.parameters),
        supports_(scenario.parameters),
        watch_(scenario),
        in_rolling_(scenario) {
    note_parameters(scenario.parameters);
  }

  /// The same for a run that another scenario continues, which must not have differed so far: clear
  /// of the ring, and before its mass loss and time_of_speed_s().
  BasicSummaryObserver branch(const Scenario& scenario) const {
    BasicSummaryObserver other = *this;
    other.ring_ = Ring<S>(scenario.parameters);
    other.in_rolling_ = NextMaximum<S>(scenario);
    other.watch_ = BasicOutcomeWatch<S>(scenario);
    other.note_parameters(scenario.parameters);
    return other;
  }

  /// Time of the speed that decides whether the rotor stalls, s.
  const S& time_of_speed_s() const { return watch_.time_of_speed_s(); }

  /// To be called with the instants of a run in order, from the start on.
  void on_instant(const BasicInstant<S>& at) override {
    const Motion<S> motion = at.motion();
    const bool has_motor = !at.body.has_constant_speed();
    if (has_motor && !at.motor_on && !summary_.motor_off_s) summary_.motor_off_s = at.time_s;
    if (at.mass_lost && !summary_.speed_at_mass_loss_Hz) {
      summary_.speed_at_mass_loss_Hz = in_Hz(motion.speed);
      if (summary_.critical_speed_Hz > 0)
        summary_.speed_ratio_at_mass_loss =
            *summary_.speed_at_mass_loss_Hz / summary_.critical_speed_Hz;
    }
    note_extremes(at, motion);
    note_contact(at, motion);
    in_rolling_.on_instant(at);
    watch_.note(at);
    last_ = at;

    summary_.outcome = watch_.outcome();
    summary_.mass_loss_reached = at.mass_lost && *summary_.lost_mass_kg > 0;
    summary_.final_time_s = at.time_s;
    summary_.final_speed_Hz = in_Hz(motion.speed);
    summary_.final_kinetic_energy_J = kinetic_energy(at.body, motion);
    summary_.final_q1_m = at.state[0];
    summary_.final_q2_m = at.state[1];
  }

  bool wants_dense_output(const S& from_s, const S& until_s) const override {
    const S time_s = watch_.time_of_speed_s();
    return last_.motor_on && from_s <= time_s && time_s < until_s;
  }

  void on_step(const BasicDenseOutput<S>& step) override {
    watch_.note_speed(step.at(watch_.time_of_speed_s()).state[5]);
  }

  /// Leaves the maxima of a quantity unlocated: the results that follow from them will not be read.
  void ignore_maxima_of(Extreme of) { ignored_ = of; }

  S threshold(Extreme of, const S& from_s, const S& until_s) const override {
    if (of == ignored_) return BasicObserver<S>::threshold(of, from_s, until_s);
    switch (of) {
      case Extreme::displacement:
        return last_.mass_lost ? summary_.peak_displacement_m.value_or(S(0))
                               : summary_.peak_displacement_before_loss_m;
      case Extreme::bearing_force:
        return summary_.peak_bearing_force_N;
      case Extreme::normal_force:
        return in_rolling_.is_awaited() ? S(0) : summary_.peak_normal_force_N.value_or(S(0));
    }
    return BasicObserver<S>::threshold(of, from_s, until_s);
  }

  void on_maximum(const BasicMaximum<S>& maximum) override {
    note_extremes(maximum.at, maximum.at.motion());
    in_rolling_.on_maximum(maximum);
  }

  bool should_continue(const BasicProgress<S>& now) override {
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
      summary_.whirl_frequency_Hz = in_Hz((now.whirl_angle - rolls_since_->whirl_angle) /
                                          (now.time_s - rolls_since_->time_s));
    }
    return true;
  }

  const BasicSummary<S>& summary() const { return summary_; }

 private:
  void note_parameters(const Parameters& p) {
    const S mass = as_typed<S>(p.mass), natural = natural_frequency(supports_.stiffness, mass);
    summary_.critical_speed_Hz = in_Hz(natural);
    if (natural > 0) summary_.damping_ratio = supports_.damping / (2 * mass * natural);
    loses_mass_ = p.loses_mass;
    if (!p.loses_mass) return;
    const MassLoss<S> loss(p);
    summary_.lost_mass_kg = loss.lost_mass;
    if (!loss.after.has_constant_speed()) summary_.inertia_after_loss_kg_m2 = loss.after.inertia;
  }

  void note_extremes(const BasicInstant<S>& at, const Motion<S>& motion) {
    const S displacement = motion.displacement.norm();
    if (at.mass_lost || !loses_mass_) keep_greatest(summary_.peak_displacement_m, displacement);
    if (!at.mass_lost)
      summary_.peak_displacement_before_loss_m =
          std::max(summary_.peak_displacement_before_loss_m, displacement);
    const S bearings = supports_.bearing_force(motion).norm();
    summary_.peak_bearing_force_N = std::max(summary_.peak_bearing_force_N, bearings);
    if (!at.touches()) return;
    const S force = at.contact_force(ring_, motion);
    if (!at.mass_lost) keep_greatest(summary_.peak_normal_force_before_loss_N, force);
    if (!in_rolling_.is_found()) keep_greatest(summary_.peak_force_to_rolling_N, force);
    if (force > summary_.peak_normal_force_N.value_or(S(0))) {
      summary_.peak_normal_force_N = force;
      summary_.peak_time_s = at.time_s;
    }
  }

  void note_contact(const BasicInstant<S>& at, const Motion<S>& motion) {
    if (last_.touches()) summary_.contact_time_s += at.time_s - last_.time_s;
    if (touch_downs_.begins_with(at.contact)) {
      ++summary_.touch_downs;
      if (!at.mass_lost) ++summary_.touch_downs_before_loss;
      if (!summary_.rolling_onset_s) ++summary_.touch_downs_to_rolling;
      if (!summary_.first_contact_s) summary_.first_contact_s = at.time_s;
    }
    const bool rolls = at.contact == ContactState::rolling;
    if (rolls && !summary_.rolling_onset_s) {
      in_rolling_.await();
      summary_.rolling_onset_s = at.time_s;
      summary_.rolling_onset_speed_Hz = in_Hz(motion.speed);
      summary_.rolling_onset_force_N = at.contact_force(ring_, motion);
    }
    const bool was_free = last_.contact == ContactState::free;
    if (at.contact != ContactState::free && (was_free || at.event == Event::mass_loss)) {
      const BasicProgress<S> here{at.time_s, motion.speed, RotatingFrame<S>::angle(at.state)};
      if (rolls_since_ && whirl_)
        rolls_since_->whirl_angle += here.whirl_angle - whirl_->whirl_angle;
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

  Ring<S> ring_;
  Supports<S> supports_;
  BasicOutcomeWatch<S> watch_;
  NextMaximum<S> in_rolling_;  ///< of the normal force
  std::optional<Extreme> ignored_;
  BasicInstant<S> last_;
  TouchDowns touch_downs_;
  bool rolls_ = false, loses_mass_ = true;
  std::optional<BasicProgress<S>> last_progress_;
  std::optional<BasicProgress<S>> whirl_;        ///< where the angle was last known
  std::optional<BasicProgress<S>> rolls_since_;  ///< its angle counted like the present one
  BasicSummary<S> summary_;
};

using Summary = BasicSummary<double>;
using SummaryObserver = BasicSummaryObserver<double>;
extern template class BasicSummaryObserver<double>;

}  // namespace rotor
