/// Adapts phases to the integration library.
#pragma once

#include <array>
#include <optional>

#include "model/integration/first_event.hpp"
#include "model/scenario/counters.hpp"

namespace rotor {

/// A phase as a system of the integration library. Counts its evaluations.
template <class S, class Phase>
class PhaseSystem {
 public:
  using Unknowns = typename Phase::Unknowns;
  static constexpr std::size_t event_count = Phase::event_count;

  PhaseSystem(const Phase& phase, Counters& counters) : phase_(phase), counters_(counters) {}

  const Phase& phase() const { return phase_; }

  void operator()(const Unknowns& x, Unknowns& rates, const S& time) const {
    ++counters_.right_hand_sides;
    if constexpr (Phase::contact_in_rates) ++counters_.contact_evaluations;
    phase_(x, rates, time);
  }
  S event(std::size_t i, const Unknowns& x) const {
    if (phase_.guard_takes_loads(i)) ++counters_.contact_evaluations;
    return phase_.guard(i, x);
  }
  using Point = rotor::Point<S, Unknowns>;
  auto bounds(const Point& from, const Point& to) const { return phase_.bounds(from, to); }
  Unknowns scale(const Unknowns& x) const { return phase_.scale(x); }

 private:
  const Phase& phase_;
  Counters& counters_;
};

}  // namespace rotor
