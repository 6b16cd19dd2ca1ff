/// Observers of a run, and what they are shown.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <optional>
#include <vector>

#include "model/scenario/instant.hpp"

namespace rotor {

/// What a run has cost.
struct Counters {
  long steps = 0;             ///< accepted ones
  long right_hand_sides = 0;  ///< in all steps, accepted or not
  /// Evaluations of all loads in contact, Eqs. (15)-(25), in right-hand sides and in guards.
  long contact_evaluations = 0;
  long located_events = 0;
};

/// A smooth part of a run, known at any time within it.
template <class S>
struct BasicDenseOutput {
  S from_s, until_s;
  long arcs;  ///< parts of equal length in which its curves swing by at most a radian

  virtual ~BasicDenseOutput() = default;
  virtual BasicInstant<S> at(const S& time_s) const = 0;

 protected:
  BasicDenseOutput(const S& from, const S& until, long arcs_in_it)
      : from_s(from), until_s(until), arcs(arcs_in_it) {}
};

/// A located maximum, on the curve of the dense output.
template <class S>
struct BasicMaximum {
  Extreme of;
  S value;  ///< m or N
  BasicInstant<S> at;
};

/// How far a run has got after a step.
template <class S>
struct BasicProgress {
  S time_s;
  S speed;  ///< rad/s
  /// Angle of O about O_a, rad; 0 in flight. q3 + atan2(q2, q1) where a contact begins or mass is
  /// lost in contact, and continuous from there on.
  S whirl_angle;
};

/// Watches a run. It is shown, in order: the start, both sides of every event, the end, and what it
/// asks for; the maxima in a step come before the step. A method with fixed steps shows the end of
/// every step, but nothing in between.
template <class S>
class BasicObserver {
 public:
  virtual ~BasicObserver() = default;

  virtual void on_instant(const BasicInstant<S>& /*at*/) {}

  /// Called after every step; the run ends there if it returns false.
  virtual bool should_continue(const BasicProgress<S>& /*now*/) { return true; }
  /// Whether the run may end there with what was asked of it. Others are refused as soon as it is
  /// clear that their end is too many steps away.
  virtual bool may_stop_early() const { return false; }

  /// Whether on_step() is to show the motion between those times.
  virtual bool wants_dense_output(const S& /*from_s*/, const S& /*until_s*/) const { return false; }
  virtual void on_step(const BasicDenseOutput<S>& /*step*/) {}

  /// on_maximum() shows maxima between those times that are above this (m or N).
  virtual S threshold(Extreme /*of*/, const S& /*from_s*/, const S& /*until_s*/) const {
    return std::numeric_limits<S>::infinity();
  }
  virtual void on_maximum(const BasicMaximum<S>& /*maximum*/) {}
};

using DenseOutput = BasicDenseOutput<double>;
using Maximum = BasicMaximum<double>;
using Progress = BasicProgress<double>;
using Observer = BasicObserver<double>;

/// Several observers as one. Each is shown what it would be shown on its own.
class ObserverGroup : public Observer {
 public:
  ObserverGroup(std::initializer_list<Observer*> all = {}) : all_(all) {}

  void add(Observer& observer) { all_.push_back(&observer); }

  void on_instant(const Instant& at) override {
    for (Observer* observer : all_) observer->on_instant(at);
  }

  bool should_continue(const Progress& now) override {
    bool all = true;
    for (Observer* observer : all_) all = observer->should_continue(now) && all;
    return all;
  }
  bool may_stop_early() const override {
    return std::any_of(all_.begin(), all_.end(),
                       [](const Observer* observer) { return observer->may_stop_early(); });
  }

  bool wants_dense_output(const double& from_s, const double& until_s) const override {
    return std::any_of(all_.begin(), all_.end(), [&](const Observer* observer) {
      return observer->wants_dense_output(from_s, until_s);
    });
  }
  void on_step(const DenseOutput& step) override {
    for (Observer* observer : all_)
      if (observer->wants_dense_output(step.from_s, step.until_s)) observer->on_step(step);
  }

  double threshold(Extreme of, const double& from_s, const double& until_s) const override {
    double least = Observer::threshold(of, from_s, until_s);
    for (const Observer* observer : all_)
      least = std::min(least, observer->threshold(of, from_s, until_s));
    return least;
  }
  void on_maximum(const Maximum& maximum) override {
    for (Observer* observer : all_)
      if (maximum.value > observer->threshold(maximum.of, maximum.at.time_s, maximum.at.time_s))
        observer->on_maximum(maximum);
  }

 private:
  std::vector<Observer*> all_;
};

/// The first maximum of the normal force from some instant on: one within a step of a located
/// method, or where the force falls after it has risen, at an event or between fixed steps.
template <class S>
class NextMaximum {
 public:
  explicit NextMaximum(const Scenario& scenario) : ring_(scenario.parameters) {}

  /// From the present instant on. The first call counts.
  void await() { awaited_ = true; }
  bool is_awaited() const { return awaited_ && !found_; }
  bool is_found() const { return found_; }

  void on_instant(const BasicInstant<S>& at) {
    if (!is_awaited()) return;
    const S force = at.contact_force(ring_, at.motion());
    largest_ = std::max(largest_, force);
    if (last_force_) {
      const S change = force - *last_force_;
      found_ = rises_ && change < -rounding();
      rises_ = rises_ || change > rounding();
    }
    last_force_ = force;
  }
  void on_maximum(const BasicMaximum<S>& maximum) {
    if (maximum.of == Extreme::normal_force && awaited_ && maximum.value > rounding())
      found_ = true;
  }

 private:
  /// More than rounding makes of a force, also of none where a contact begins or ends.
  S rounding() const { return S(1e-9) * largest_; }

  Ring<S> ring_;
  bool awaited_ = false, found_ = false, rises_ = false;
  std::optional<S> last_force_;
  S largest_{0};  ///< of the instants so far
};

}  // namespace rotor
