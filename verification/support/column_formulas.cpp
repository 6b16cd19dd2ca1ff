#include "verification/support/column_formulas.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "verification/support/contact_formulas.hpp"
#include "verification/support/place_of_loss.hpp"

namespace rotor {
namespace {

constexpr double pi = 3.14159265358979323846;

/// The rotor in the stator's axes, x_a down.
struct Rotor {
  Rotor(const Instant& instant, const Scenario& scenario)
      : at(instant), p(scenario.parameters), scenario_(scenario) {
    const auto& q = at.state;
    const double c = std::cos(q[2]), s = std::sin(q[2]);
    x = c * q[0] - s * q[1];
    y = s * q[0] + c * q[1];
    w = q[5];
    // The rates of q1 and q2 are those seen from axes that turn.
    v_x = c * q[3] - s * q[4] - w * y;
    v_y = s * q[3] + c * q[4] + w * x;
    rho = std::sqrt(q[0] * q[0] + q[1] * q[1]);

    m = p.mass;
    inertia = p.inertia;
    e = p.eccentricity;
    if (at.mass_lost) {
      const double m_u = lost_mass_by_formula(p);
      const double e_1 = (m * e + m_u * p.rotor_radius) / (m - m_u);
      m -= m_u;
      inertia -= m_u * std::pow(p.rotor_radius + e, 2) + m * std::pow(e_1 - e, 2);
      e = e_1;
    }
    e_x = e * c;
    e_y = e * s;
    pressed = at.contact == ContactState::sliding || at.contact == ContactState::rolling;
  }

  /// From the position of rest.
  double off_x() const { return x + p.ring_offset_x; }
  double off_y() const { return y + p.ring_offset_y; }
  double delta() const { return rho - (p.stator_radius - p.rotor_radius); }
  double delta_rate() const { return (x * v_x + y * v_y) / rho; }
  double slip() const { return (x * v_y - y * v_x) / rho + p.rotor_radius * w; }
  double normal_force() const {
    if (!pressed) return 0;
    return std::min(0., -spring_force_by_formula(p, delta()) - p.contact_damping * delta_rate());
  }

  double friction() const {
    if (!pressed) return 0;
    const bool constrained = at.contact == ContactState::rolling;
    if (constrained && scenario_.method == Method::event) return holding_friction();
    return slip() > 0 ? p.friction * normal_force() : -p.friction * normal_force();
  }

  /// Newton's and Euler's laws and constant slip, solved together for the accelerations of O and of
  /// the angle, and for the friction.
  double holding_friction() const {
    const double r = p.rotor_radius, n_x = x / rho, n_y = y / rho, t_x = -n_y, t_y = n_x;
    const double force = normal_force();
    const double f_x = -p.support_stiffness * off_x() - p.support_damping * v_x;
    const double f_y = -p.support_stiffness * off_y() - p.support_damping * v_y;
    // About C: the supports act at O, F_n at K, which lies r from O; both arms are seen from C.
    double moment = -(e_x * f_y - e_y * f_x) + force * (-e_x * n_y + e_y * n_x);
    if (at.motor_on) moment += p.torque;
    const bool whole = scenario_.equations.gravity_moment == GravityMoment::whole;
    moment -= m * p.gravity * (whole ? y + e_y : e_y);  // about O_a, a couple: Q_1, Q_2 have none
    const double arm = (r * n_x - e_x) * t_y - (r * n_y - e_y) * t_x;
    Eigen::Matrix4d of;
    Eigen::Vector4d is;
    of << m, 0, -m * e_y, -t_x,  //
        0, m, m * e_x, -t_y,     //
        0, 0, inertia, -arm,     //
        -y / rho, x / rho, r, 0;
    is << f_x + force * n_x + m * w * w * e_x,  //
        f_y + force * n_y + m * w * w * e_y,    //
        moment,                                 //
        (x * v_y - y * v_x) / (rho * rho) * delta_rate();
    return of.fullPivLu().solve(is)[3];
  }

  const Instant& at;
  const Parameters& p;
  double x, y, w, v_x, v_y, rho, m, inertia, e, e_x, e_y;
  bool pressed;

 private:
  const Scenario& scenario_;
};

double contact_damping_power(const Rotor& r) {
  if (r.pressed) return -r.p.contact_damping * r.delta_rate() * r.delta_rate();
  // Without a force the ring's spring and its damper keep each other's balance.
  if (r.at.contact == ContactState::indented)
    return spring_force_by_formula(r.p, r.delta()) * r.delta_rate();
  return 0;
}

double kinetic_energy_of(const Rotor& r) {
  const double v_x = r.v_x - r.w * r.e_y, v_y = r.v_y + r.w * r.e_x;
  const double rotation = r.p.drive == Drive::constant_speed ? 0 : 0.5 * r.inertia * r.w * r.w;
  return 0.5 * r.m * (v_x * v_x + v_y * v_y) + rotation;
}

double contact_number(ContactState contact) {
  if (contact == ContactState::free) return 0;
  return contact == ContactState::sliding ? 1 : contact == ContactState::rolling ? 2 : 3;
}

using Formula = double (*)(const Rotor&);
constexpr double none = std::numeric_limits<double>::quiet_NaN();

const std::map<std::string, Formula, std::less<>>& formulas() {
  static const std::map<std::string, Formula, std::less<>> all = {
      {"time_s", [](const Rotor& r) { return r.at.time_s; }},
      {"q1_m", [](const Rotor& r) { return r.at.state[0]; }},
      {"q2_m", [](const Rotor& r) { return r.at.state[1]; }},
      {"q3_rad", [](const Rotor& r) { return r.at.state[2]; }},
      {"q1_rate_m_per_s", [](const Rotor& r) { return r.at.state[3]; }},
      {"q2_rate_m_per_s", [](const Rotor& r) { return r.at.state[4]; }},
      {"q3_rate_rad_per_s", [](const Rotor& r) { return r.at.state[5]; }},
      {"rho_m", [](const Rotor& r) { return r.rho; }},
      {"x_a_m", [](const Rotor& r) { return r.x; }},
      {"y_a_m", [](const Rotor& r) { return r.y; }},
      {"x_a_rate_m_per_s", [](const Rotor& r) { return r.v_x; }},
      {"y_a_rate_m_per_s", [](const Rotor& r) { return r.v_y; }},
      {"speed_Hz", [](const Rotor& r) { return r.w / (2 * pi); }},
      {"normal_force_N", [](const Rotor& r) { return r.normal_force(); }},
      {"friction_force_N", [](const Rotor& r) { return r.friction(); }},
      {"slip_velocity_m_per_s", [](const Rotor& r) { return r.rho == 0 ? none : r.slip(); }},
      {"kinetic_energy_J", kinetic_energy_of},
      {"bearing_force_N",
       [](const Rotor& r) {
         return std::hypot(r.p.support_stiffness * r.off_x() + r.p.support_damping * r.v_x,
                           r.p.support_stiffness * r.off_y() + r.p.support_damping * r.v_y);
       }},
      {"whirl_frequency_Hz",
       [](const Rotor& r) {
         return r.rho == 0 ? none : (r.x * r.v_y - r.y * r.v_x) / (r.rho * r.rho) / (2 * pi);
       }},
      {"contact_angle_rad", [](const Rotor& r) { return std::atan2(r.y, r.x); }},
      {"motor_power_W", [](const Rotor& r) { return r.at.motor_on ? r.p.torque * r.w : 0; }},
      {"support_damping_power_W",
       [](const Rotor& r) { return -r.p.support_damping * (r.v_x * r.v_x + r.v_y * r.v_y); }},
      {"friction_power_W", [](const Rotor& r) { return r.pressed ? r.friction() * r.slip() : 0; }},
      {"contact_damping_power_W", contact_damping_power},
      {"support_energy_J",
       [](const Rotor& r) {
         return 0.5 * r.p.support_stiffness * (r.off_x() * r.off_x() + r.off_y() * r.off_y());
       }},
      {"contact_energy_J",
       [](const Rotor& r) {
         return contact_energy_by_formula(r.p, r.at.contact == ContactState::free ? 0 : r.delta());
       }},
      {"contact_state", [](const Rotor& r) { return contact_number(r.at.contact); }},
  };
  return all;
}

}  // namespace

double column_by_formula(std::string_view column, const Instant& at, const Scenario& scenario) {
  const auto found = formulas().find(column);
  if (found == formulas().end())
    throw std::out_of_range("there is no formula for the column " + std::string(column));
  return found->second(Rotor(at, scenario));
}

}  // namespace rotor
