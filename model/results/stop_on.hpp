/// Early ends of a run.
#pragma once

#include <cmath>

#include "model/results/outcome.hpp"
#include "model/scenario/observer.hpp"

namespace rotor {

/// Where a run may end. outcome: as soon as the mass loss, a later event or the end of a step in
/// flight decides it, whatever speeds the rotor can still have. rolling: at the first maximum of
/// the force after the onset of rolling; so does outcome. rest: after a second below 0.1 Hz, which
/// counts after the mass loss or, in a run without one, after a motor, if it has a torque, has
/// driven the rotor faster than that.
enum class StopOn { outcome, rolling, rest };

/// Whether such a run cannot end before its mass loss.
constexpr bool awaits_mass_loss(StopOn stop_on) { return stop_on == StopOn::outcome; }

class StopObserver : public Observer {
 public:
  /// Not in rolling, if a run to its outcome awaits the last contact.
  StopObserver(StopOn stop_on, const Scenario& scenario, bool awaits_last_contact = false)
      : stop_on_(stop_on),
        awaits_last_contact_(awaits_last_contact),
        loses_mass_(scenario.loses_mass()),
        watch_(scenario),
        in_rolling_(scenario),
        force_(scenario),
        has_turned_(
            !(ActingLoads<double>(scenario.parameters, scenario.equations).constant_moment(true) >
              0)) {}

  StopOn stop_on() const { return stop_on_; }
  bool is_reached() const { return reached_ || force_.is_found(); }

  void on_instant(const Instant& at) override {
    watch_.note(at);
    if (at.event == Event::mass_loss) slow_since_s_ = at.time_s;
    mass_lost_ = at.mass_lost;
    is_free_ = at.contact == ContactState::free;
    if (at.contact == ContactState::rolling) rolled_ = true;
    if (rolled_) in_rolling_.await();
    in_rolling_.on_instant(at);
    if (rolled_ && (stop_on_ == StopOn::rolling ||
                    (stop_on_ == StopOn::outcome && loss_is_over() && !awaits_last_contact_)))
      force_.await();
    force_.on_instant(at);
    if (stop_on_ != StopOn::outcome || !loss_is_over() || (rolled_ && awaits_last_contact_)) return;
    const bool rolled_before =
        at.event == Event::mass_loss && in_rolling_.is_found() && !at.touches();
    reached_ = reached_ || rolled_before || (at.event != Event::none && stays_clear());
  }

  bool wants_dense_output(const double& /*from_s*/, const double& /*until_s*/) const override {
    return stop_on_ == StopOn::outcome && loss_is_over() && is_free_ && !rolled_;
  }
  void on_step(const DenseOutput& step) override {
    watch_.note(step.at(step.until_s));
    reached_ = reached_ || stays_clear();
  }

  double threshold(Extreme of, const double& from_s, const double& until_s) const override {
    return of == Extreme::normal_force && (in_rolling_.is_awaited() || force_.is_awaited())
               ? 0
               : Observer::threshold(of, from_s, until_s);
  }
  void on_maximum(const Maximum& maximum) override {
    in_rolling_.on_maximum(maximum);
    force_.on_maximum(maximum);
  }

  bool should_continue(const Progress& now) override {
    constexpr double slow = 0.1 * two_pi, for_s = 1;
    const bool is_slow = std::abs(now.speed) < slow;
    has_turned_ = has_turned_ || !is_slow;
    const bool may_rest = loses_mass_ ? mass_lost_ : has_turned_;
    if (!(may_rest && is_slow)) slow_since_s_ = now.time_s;
    if (stop_on_ == StopOn::rest && now.time_s - slow_since_s_ >= for_s) reached_ = true;
    return !is_reached();
  }
  bool may_stop_early() const override { return !awaits_mass_loss(stop_on_) || loss_is_over(); }

 private:
  bool loss_is_over() const { return mass_lost_ || !loses_mass_; }
  bool stays_clear() const {
    const Outcome outcome = watch_.outcome();
    return (outcome == Outcome::freed || outcome == Outcome::no_contact) && watch_.stays_clear();
  }

  StopOn stop_on_;
  bool awaits_last_contact_;
  bool loses_mass_;
  OutcomeWatch watch_;
  NextMaximum<double> in_rolling_;  ///< up to which the summary has results of its own
  NextMaximum<double> force_;       ///< at which the run ends
  double slow_since_s_ = 0;
  bool has_turned_;
  bool mass_lost_ = false, is_free_ = false, rolled_ = false, reached_ = false;
};

}  // namespace rotor
