#include "figures/record/columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rotor {
namespace {

double slip_velocity(InstantView& view) {
  const bool centred = view.motion().displacement.squaredNorm() == 0;  // K is undefined
  return centred ? std::numeric_limits<double>::quiet_NaN() : view.rim_point().slip_velocity;
}

double whirl_frequency(InstantView& view) {
  const Motion<double>& m = view.motion();
  const double square = m.displacement.squaredNorm();
  return square == 0 ? std::numeric_limits<double>::quiet_NaN()
                     : in_Hz(cross(m.displacement, m.velocity) / square);
}

constexpr std::array table = {
    Column{"time_s", "time; rows with the same time are before and after an event",
           [](InstantView& v) { return v.at().time_s; }},
    Column{"q1_m", "O along x of the rotating axes",
           [](InstantView& v) { return v.at().state[0]; }},
    Column{"q2_m", "O along y of the rotating axes",
           [](InstantView& v) { return v.at().state[1]; }},
    Column{"q3_rad", "angle of the rotor", [](InstantView& v) { return v.at().state[2]; }},
    Column{"q1_rate_m_per_s", "rate of q1", [](InstantView& v) { return v.at().state[3]; }},
    Column{"q2_rate_m_per_s", "rate of q2", [](InstantView& v) { return v.at().state[4]; }},
    Column{"q3_rate_rad_per_s", "rate of q3", [](InstantView& v) { return v.at().state[5]; }},
    Column{"rho_m", "distance of O from O_a, the centre of the ring",
           [](InstantView& v) { return Vector<double>(v.at().state[0], v.at().state[1]).norm(); },
           Extreme::displacement},
    Column{"x_a_m", "O along x_a (down) in the stator's frame",
           [](InstantView& v) { return v.displacement_in_stator_frame().x(); }},
    Column{"y_a_m", "O along y_a in the stator's frame",
           [](InstantView& v) { return v.displacement_in_stator_frame().y(); }},
    Column{"x_a_rate_m_per_s", "velocity of O along x_a in the stator's frame",
           [](InstantView& v) { return v.velocity_in_stator_frame().x(); }},
    Column{"y_a_rate_m_per_s", "velocity of O along y_a in the stator's frame",
           [](InstantView& v) { return v.velocity_in_stator_frame().y(); }},
    Column{"speed_Hz", "rotation speed f", [](InstantView& v) { return in_Hz(v.at().state[5]); }},
    Column{"normal_force_N", "F_n on the rotor, negative in compression",
           [](InstantView& v) { return v.normal_force(); }, Extreme::normal_force},
    Column{"friction_force_N", "F_tau on the rotor, positive in the sense of q3",
           [](InstantView& v) { return v.friction(); }},
    Column{"slip_velocity_m_per_s", "v_Ktau of the rim relative to the ring", slip_velocity},
    Column{"kinetic_energy_J", "T of the rotor",
           [](InstantView& v) { return kinetic_energy(v.at().body, v.motion()); }},
    Column{"bearing_force_N",
           "magnitude of k r_O + d v_O of the supports, r_O from the position of rest",
           [](InstantView& v) { return v.acting().supports.bearing_force(v.motion()).norm(); },
           Extreme::bearing_force},
    Column{"whirl_frequency_Hz", "whirl frequency of O about O_a, negative against the rotation",
           whirl_frequency},
    Column{"contact_angle_rad", "direction of O from O_a in the stator's frame, from x_a",
           [](InstantView& v) {
             const Vector<double> at = v.displacement_in_stator_frame();
             return std::atan2(at.y(), at.x());
           }},
    Column{"motor_power_W",
           "power of the motor; 0 at constant speed, which is held whatever power that takes",
           [](InstantView& v) { return v.acting().motor.power(v.motion(), v.at().motor_on); }},
    Column{"support_damping_power_W", "power of the supports' dampers, negative",
           [](InstantView& v) { return v.acting().supports.power(v.at().body, v.motion()); }},
    Column{"friction_power_W", "power of F_tau at the rim, negative",
           [](InstantView& v) {
             return v.at().touches() ? v.friction() * v.rim_point().slip_velocity : 0;
           }},
    Column{"contact_damping_power_W",
           "power of the contact's damper, negative; also while the ring springs back",
           [](InstantView& v) { return v.ring().damping_power(v.rim_point(), v.at().contact); }},
    Column{"support_energy_J", "potential energy of the supports' springs",
           [](InstantView& v) { return v.acting().supports.potential(v.at().body, v.motion()); }},
    Column{"contact_energy_J", "potential energy of the indented ring",
           [](InstantView& v) { return v.ring().energy(v.rim_point(), v.at().contact); }},
    Column{"contact_state", "0 free, 1 sliding, 2 rolling, 3 free with the ring still indented",
           [](InstantView& v) { return static_cast<double>(v.at().contact); }},
};

}  // namespace

double InstantView::friction() {
  if (!at_.touches()) return 0;
  if (at_.contact == ContactState::rolling && context_.rolls)
    return friction_without_slip(at_.body, ring(), motion(), rim_point(),
                                 acting().loads(at_.body, motion(), at_.motor_on), normal_force());
  const int own = rim_point().slip_velocity > 0 ? 1 : -1;
  return ring().sliding_friction(normal_force(), at_.slip_sign == 0 ? own : at_.slip_sign);
}

std::vector<const Column*> all_columns() {
  std::vector<const Column*> all;
  for (const Column& column : table) all.push_back(&column);
  return all;
}

const Column* find_column(std::string_view name) {
  const auto* const found =
      std::find_if(table.begin(), table.end(), [name](const Column& c) { return c.name == name; });
  return found == table.end() ? nullptr : found;
}

}  // namespace rotor
