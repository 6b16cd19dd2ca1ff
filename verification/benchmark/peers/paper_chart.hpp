/// The paper's own coordinates as a chart of model/phases: O in the axes that turn with the rotor,
/// and the rotor's angle.
#pragma once

#include "model/mechanics/rotating_frame.hpp"
#include "model/phases/rotor_system.hpp"

namespace rotor {

template <class S>
class PaperChart {
 public:
  using Unknowns = State<S>;

  struct Kinematics {
    Motion<S> motion;
  };

  PaperChart(const RotorSystem<S>& rotor, const State<S>& /*q*/)
      : body_(rotor.body), ring_(rotor.ring) {}

  Unknowns unknowns(const State<S>& q) const { return q; }
  State<S> state(const Unknowns& x) const { return x; }
  S speed(const Unknowns& x) const { return x[5]; }
  Kinematics kinematics(const Unknowns& x) const { return {RotatingFrame<S>::motion(body_, x)}; }
  RimPoint<S> rim_point(const Unknowns& x) const {
    return ring_.rim_point(RotatingFrame<S>::motion(body_, x));
  }
  Unknowns rates(const Unknowns& x, const Kinematics& at, const Acceleration<S>& a) const {
    return RotatingFrame<S>::rates(at.motion, x, a);
  }
  Unknowns scale(const S& length, const S& frequency, const S& speed) const {
    return {length, length, S(1), length * frequency, length * frequency, speed};
  }
  /// The slip is not one of these coordinates: it is only as small as the integrator keeps it.
  Unknowns without_slip(const Unknowns& x) const { return x; }

 private:
  Body<S> body_;
  Ring<S> ring_;
};

}  // namespace rotor
