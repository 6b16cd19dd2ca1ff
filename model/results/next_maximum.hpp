/// The first maximum of the normal force from some instant on.
#pragma once

#include <optional>

#include "model/scenario/observer.hpp"

namespace rotor {

template <class S>
class NextMaximum {
 public:
  explicit NextMaximum(const Scenario& scenario)
      : has_fixed_steps_(scenario.method == Method::rk4), ring_(scenario.parameters) {}

  /// From the present instant on. The first call counts.
  void await() { awaited_ = true; }
  bool is_awaited() const { return awaited_ && !found_; }
  bool is_found() const { return found_; }

  /// Fixed steps show no maxima: there, the force falls after it has risen.
  void on_instant(const BasicInstant<S>& at) {
    if (!has_fixed_steps_ || !is_awaited()) return;
    const S force = at.contact_force(ring_, at.motion());
    found_ = rises_ && force < *last_force_;
    rises_ = last_force_ && (rises_ || force > *last_force_);
    last_force_ = force;
  }
  void on_maximum(const BasicMaximum<S>& maximum) {
    if (maximum.of == Extreme::normal_force && awaited_) found_ = true;
  }

 private:
  bool has_fixed_steps_;
  Ring<S> ring_;
  bool awaited_ = false, found_ = false, rises_ = false;
  std::optional<S> last_force_;
};

}  // namespace rotor
