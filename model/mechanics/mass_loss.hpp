/// Loss of a piece of the rim, on the side opposite to the unbalance. Source: "Overcritical
/// high-speed rotor systems, full annular rub and accident", Sec. 2.2, Eqs. (5)-(14).
#pragma once

#include "model/mechanics/rotating_frame.hpp"

namespace rotor {

template <class S>
struct MassLoss {
  S lost_mass;       ///< m_u, kg
  Body<S> before;    ///< m, I_C, e_x
  Body<S> after;     ///< m_1, I_C1, e_x1
  S piece_distance;  ///< r + e_x, of the piece from C, m
  S time_s;          ///< t_1

  explicit MassLoss(const Parameters& p)
      : before(Body<S>::of(p)), time_s(as_typed<S>(p.mass_loss_time)) {
    const S r = as_typed<S>(p.rotor_radius), m = before.mass, e = before.eccentricity;
    const std::optional<double> stated = p.stated_lost_mass();
    // A balanced rotor gets its eccentricity from the piece alone.
    const S e_1 = e > 0 || !stated ? S(unbalance_factor(p) * e)
                                   : S(as_typed<S>(*stated) * r / (m - as_typed<S>(*stated)));
    piece_distance = r + e;
    lost_mass = m * (e_1 - e) / (r + e_1);  // Eq. (5)
    after.mass = m - lost_mass;
    after.eccentricity = e_1;
    after.inertia = before.inertia - lost_mass * piece_distance * piece_distance -
                    after.mass * (e_1 - e) * (e_1 - e);  // Eqs. (8), (11), (12)
  }

  static S unbalance_factor(const Parameters& p) {
    const std::optional<double> stated = p.stated_lost_mass();
    return stated ? unbalance_factor(p, *stated) : as_typed<S>(p.unbalance_factor);
  }

  /// k_u that follows from a lost mass; 1 for a balanced rotor.
  static S unbalance_factor(const Parameters& p, double lost_mass_kg) {
    const S m = as_typed<S>(p.mass), e = as_typed<S>(p.eccentricity),
            lost = as_typed<S>(lost_mass_kg);
    if (!(lost > 0 && e > 0)) return S(1);
    return 1 + lost * (e + as_typed<S>(p.rotor_radius)) / ((m - lost) * e);  // Eq. (5); >= 1
  }

  /// v_DC: speed of the piece relative to C at the mass loss, m/s.
  S piece_velocity(const S& speed) const { return speed * piece_distance; }  // Eq. (7)

  /// Delta_vy: change of the mass centre's velocity as the centre moves from C to C_1, m/s.
  S velocity_jump(const S& speed) const {
    return lost_mass * piece_velocity(speed) / after.mass;  // Eqs. (13), (14)
  }

  /// The state just after the mass loss. The body keeps its velocity field when the piece lets go,
  /// so that q1', q2', q3' do not change (Eq. (10)), and Eq. (1) alone, with e_x1 for e_x, raises
  /// the velocity of the mass centre by Delta_vy. As printed, q2' is raised by Delta_vy once more.
  State<S> lose_mass(State<S> q, Equations equations) const {
    if (equations.velocity_jump == VelocityJump::twice) q[4] += velocity_jump(q[5]);
    return q;
  }
};

}  // namespace rotor
