#include "figures/scenes/columns.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

namespace rotor {
namespace {

double slip_velocity(View& view) {
  const bool centred = view.motion().displacement.squaredNorm() == 0;  // no point K is nearest
  return centred ? std::numeric_limits<double>::quiet_NaN() : view.rim_point().slip_velocity;
}

constexpr std::array columns = {
    Column{"time_s", "time", [](View& v) { return v.at().time_s; }},
    Column{"q1_m", "O along x of the rotating axes", [](View& v) { return v.at().state[0]; }},
    Column{"q2_m", "O along y of the rotating axes", [](View& v) { return v.at().state[1]; }},
    Column{"q3_rad", "angle of the rotor", [](View& v) { return v.at().state[2]; }},
    Column{"q1_rate_m_per_s", "rate of q1", [](View& v) { return v.at().state[3]; }},
    Column{"q2_rate_m_per_s", "rate of q2", [](View& v) { return v.at().state[4]; }},
    Column{"q3_rate_rad_per_s", "rate of q3", [](View& v) { return v.at().state[5]; }},
    Column{"rho_m", "distance of O from O_a",
           [](View& v) { return Vector<double>(v.at().state[0], v.at().state[1]).norm(); },
           Extreme::displacement},
    Column{"x_a_m", "O along x_a (down) in the stator's frame",
           [](View& v) { return v.displacement_in_stator_frame().x(); }},
    Column{"y_a_m", "O along y_a in the stator's frame",
           [](View& v) { return v.displacement_in_stator_frame().y(); }},
    Column{"speed_Hz", "rotation speed f",
           [](View& v) { return v.at().state[5] / (2 * std::numbers::pi); }},
    Column{"normal_force_N", "F_n on the rotor, negative in compression",
           [](View& v) { return v.normal_force(); }, Extreme::normal_force},
    Column{"friction_force_N", "F_tau on the rotor, positive in the sense of q3",
           [](View& v) { return v.friction(); }},
    Column{"slip_velocity_m_per_s", "v_Ktau of the rim relative to the ring", slip_velocity},
    Column{"kinetic_energy_J", "T of the rotor",
           [](View& v) { return kinetic_energy(v.at().body, v.motion()); }},
    Column{"contact_state", "0 free, 1 sliding, 2 rolling, 3 free with the ring still indented",
           [](View& v) { return static_cast<double>(v.at().contact); }},
};

}  // namespace

const Motion<double>& View::motion() {
  if (!motion_) motion_ = at_.motion();
  return *motion_;
}

const RimPoint<double>& View::rim_point() {
  if (!rim_point_) rim_point_ = context_.ring.rim_point(motion());
  return *rim_point_;
}

bool View::in_contact() const {
  return at_.contact == ContactState::sliding || at_.contact == ContactState::rolling;
}

double View::normal_force() { return in_contact() ? context_.ring.normal_force(rim_point()) : 0; }

double View::friction() {
  if (!in_contact()) return 0;
  const Ring<double>& ring = context_.ring;
  const auto& k = rim_point();
  if (at_.contact == ContactState::rolling && context_.rolls) {
    return friction_without_slip(at_.body, ring, motion(), k,
                                 context_.supports.loads(at_.body, motion(), at_.motor_on),
                                 normal_force());
  }
  return ring.sliding_friction(normal_force(), k.slip_velocity > 0 ? 1 : -1);
}

Vector<double> View::displacement_in_stator_frame() {
  return in_stator_frame({at_.state[0], at_.state[1]}, at_.state[2]);
}

std::span<const Column> all_columns() { return columns; }

const Column* find_column(std::string_view name) {
  const auto* const found = std::find_if(columns.begin(), columns.end(),
                                         [name](const Column& c) { return c.name == name; });
  return found == columns.end() ? nullptr : found;
}

}  // namespace rotor
