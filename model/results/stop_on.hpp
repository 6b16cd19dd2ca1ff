/// Early ends of a run.
#pragma once

#include <cmath>
#include <optional>

#include "model/results/outcome.hpp"
#include "model/scenario/observer.hpp"

namespace rotor {

/// Where a run may end. outcome: as soon as the mass loss or a later event decides it, whatever
/// speeds the rotor can still have. rolling: at the first maximum of the force after the onset of
/// rolling; so does outcome. rest: after a second below 0.1 Hz, which counts after the mass loss
/// or, in a run without one, after a motor has driven the rotor faster than that.
enum class StopOn { outcome, rolling, rest };

class StopObserver : public Observer {
 public:
  StopObserver(StopOn stop_on, const Scenario& scenario)
      : stop_on_(stop_on),
        loses_mass_(scenario.loses_mass()),
        has_fixed_steps_(scenario.method == Method::rk4),
        ring_(scenario.parameters),
        watch_(scenario),
        has_turned_(!(scenario.parameters.torque > 0)) {}

  bool is_reached() const { return reached_; }

  void on_instant(const Instant& at) override {
    watch_.note(at);
    if (at.event == Event::mass_loss) slow_since_s_ = at.time_s;
    mass_lost_ = at.mass_lost;
    if (at.contact == ContactState::rolling) rolled_ = true;
    if (has_fixed_steps_) note_force(at);
    if (stop_on_ != StopOn::outcome || !loss_is_over()) return;
    const Outcome outcome = watch_.outcome();
    const bool rolled_before = at.event == Event::mass_loss && rolled_ && !at.touches();
    reached_ =
        reached_ || rolled_before ||
        (at.event != Event::none && (outcome == Outcome::freed || outcome == Outcome::no_contact) &&
         watch_.stays_clear());
  }

  double threshold(Extreme of, const double& from_s, const double& until_s) const override {
    return of == Extreme::normal_force && awaits_maximum()
               ? 0
               : Observer::threshold(of, from_s, until_s);
  }
  void on_maximum(const Maximum& maximum) override {
    if (maximum.of == Extreme::normal_force && awaits_maximum()) reached_ = true;
  }

  bool goes_on(const Progress& now) override {
    constexpr double slow = 0.1 * two_pi, for_s = 1;
    const bool is_slow = std::abs(now.speed) < slow;
    has_turned_ = has_turned_ || !is_slow;
    const bool may_rest = loses_mass_ ? mass_lost_ : has_turned_;
    if (!(may_rest && is_slow)) slow_since_s_ = now.time_s;
    if (stop_on_ == StopOn::rest && now.time_s - slow_since_s_ >= for_s) reached_ = true;
    return !reached_;
  }

 private:
  /// For fixed steps, which show no maxima: the force falls after it has risen.
  void note_force(const Instant& at) {
    if (!awaits_maximum()) return;
    const double force = -ring_.normal_force(ring_.rim_point(at.motion()));
    const bool falls = last_force_ && force < *last_force_;
    if (falls && rises_) reached_ = true;
    rises_ = last_force_ && (rises_ || force > *last_force_);
    last_force_ = force;
  }
  bool loss_is_over() const { return mass_lost_ || !loses_mass_; }
  bool awaits_maximum() const {
    const bool rolling_decides =
        stop_on_ == StopOn::rolling || (stop_on_ == StopOn::outcome && loss_is_over());
    return rolling_decides && rolled_ && !reached_;
  }

  StopOn stop_on_;
  bool loses_mass_, has_fixed_steps_;
  Ring<double> ring_;
  OutcomeWatch watch_;
  double slow_since_s_ = 0;
  std::optional<double> last_force_;  ///< while its maximum is awaited
  bool has_turned_;
  bool rises_ = false, mass_lost_ = false, rolled_ = false, reached_ = false;
};

}  // namespace rotor
