/// Observers for many tests. The Observer itself asks for nothing.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "model/run/simulation.hpp"

namespace rotor {

inline Observer nobody;  ///< looks at nothing

/// Keeps all events, the instant before the mass loss, and the last instant.
template <class S>
class BasicEventRecorder : public BasicObserver<S> {
 public:
  void on_instant(const BasicInstant<S>& at) override {
    if (at.event == Event::mass_loss) before_loss_ = last_;
    if (at.event != Event::none) events_.push_back(at);
    last_ = at;
  }

  /// In their order.
  const std::vector<BasicInstant<S>>& events() const { return events_; }
  std::vector<BasicInstant<S>> events(Event kind) const {
    std::vector<BasicInstant<S>> found;
    for (const auto& at : events_)
      if (at.event == kind) found.push_back(at);
    return found;
  }
  long count(Event kind) const {
    return std::count_if(events_.begin(), events_.end(),
                         [kind](const auto& at) { return at.event == kind; });
  }
  /// Throws std::bad_optional_access if there is none.
  const BasicInstant<S>& first(Event kind) const {
    for (const auto& at : events_)
      if (at.event == kind) return at;
    throw std::bad_optional_access();
  }
  const BasicInstant<S>& before_mass_loss() const { return before_loss_.value(); }
  const BasicInstant<S>& last() const { return last_; }

 private:
  std::vector<BasicInstant<S>> events_;
  std::optional<BasicInstant<S>> before_loss_;
  BasicInstant<S> last_;
};

using EventRecorder = BasicEventRecorder<double>;

/// The events of a whole run.
inline EventRecorder recorded(const Scenario& scenario) {
  EventRecorder recorder;
  run(scenario, recorder);
  return recorder;
}

/// Looks at the motion between two times wherever it is known.
template <class Look>
class MotionObserver : public Observer {
 public:
  MotionObserver(double from_s, double until_s, Look look)
      : from_s_(from_s), until_s_(until_s), look_(look) {}

  bool wants_dense_output(const double& from_s, const double& until_s) const override {
    return until_s > from_s_ && from_s < until_s_;
  }
  void on_step(const DenseOutput& motion) override { look_(motion); }

 private:
  double from_s_, until_s_;
  Look look_;
};

}  // namespace rotor
