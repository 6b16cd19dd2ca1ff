#include "figures/results/remarks.hpp"

#include <fmt/format.h>

#include <cmath>

#include "model/mechanics/contact.hpp"
#include "model/mechanics/mass_loss.hpp"
#include "model/theory/lifting.hpp"

namespace rotor {

std::vector<Remark> remarks_on_rotor(const Scenario& scenario,
                                     std::optional<double> loss_speed_Hz) {
  const Parameters& p = scenario.parameters;
  const auto the = [&](std::string_view name) { return mention_of(scenario, name); };
  std::vector<Remark> all;
  // The paper's shortest run-up ends at a thirteenth; a slip in a unit is a factor of a thousand.
  constexpr double near = 0.05;
  const double moment = ActingLoads<double>(p, scenario.equations).constant_moment(true);
  const double reached = scenario.start_speed_Hz + moment / p.inertia * scenario.until / two_pi;
  const bool is_driven = p.drive == Drive::motor;
  if (swings(scenario))
    all.push_back(
        {{the("torque"),
          fmt::format(" does not lift the unbalance from rest, which takes {:.3g} m g e_x "
                      "= {:.4g} N m: the rotor swings as a pendulum",
                      lifting_share, lifting_torque(p))}});
  if (is_driven && moment > 0 && !swings(scenario) && reached < near * p.motor_off_Hz)
    all.push_back(
        {{fmt::format(
              "by the end of the run, {:.6g} s, the motor reaches about {:.2g} %, less than "
              "{} %, of ",
              scenario.until, 100 * reached / p.motor_off_Hz, 100 * near),
          the("motor_off_Hz")}});
  constexpr double slow = 0.1;
  const double critical_Hz = natural_frequency(p.support_stiffness, p.mass) / two_pi;
  if (loss_speed_Hz && *loss_speed_Hz < slow * critical_Hz)
    all.push_back({{fmt::format(
        "the mass is lost at {:.2g} Hz, less than {} of the critical speed, {:.3g} Hz",
        *loss_speed_Hz, slow, critical_Hz)}});
  // I/(m r^2) is 0.5 for a disk and 1 for a ring. These limits are halfway, on a logarithmic scale,
  // between them and a slip in a unit, by a factor of a thousand.
  constexpr double least = 0.016, greatest = 30;
  const double ratio = p.inertia / (p.mass * p.rotor_radius * p.rotor_radius);
  if (is_driven && (ratio < least || ratio > greatest))
    all.push_back({{the("inertia"), fmt::format(" is {:.2g} times ", ratio), the("mass"), " times ",
                    the("rotor_radius"), " squared; a disk has 0.5, a ring 1"}});
  if (constexpr double most = 5; p.friction > most)  // dry rubber has 1 to 2; 5 % would be 0.05
    all.push_back({{the("friction"), fmt::format(" exceeds {}; it is not in per cent", most)}});
  const double clearance = Ring<double>(p).clearance;
  // Relative to the clearance; 0.4 % for the paper's rotor. From here on it may decide on contact.
  constexpr double little = 0.05;
  if (p.support_stiffness == 0 && p.gravity > 0)
    all.push_back({{"without support_stiffness the weight has no position of rest"}});
  const double rise = MassLoss<double>(p).lost_mass * p.gravity / p.support_stiffness;
  if (p.support_stiffness > 0 && scenario.loses_mass() && rise > little * clearance)
    all.push_back(
        {{fmt::format("without the lost mass the position of rest is {:.3g} m higher, which "
                      "is not modelled",
                      rise)}});
  if (const Supports<double> supports(p); !supports.is_centred)
    all.push_back(
        {{fmt::format("the ring's centre is {:.4g} m off the position of rest; displacements are "
                      "from the former, bearing forces from the latter",
                      supports.rest_distance)}});
  if (clearance > p.rotor_radius)
    all.push_back({{fmt::format(
        "the clearance, {:.6g} m, exceeds the rotor's radius; lengths are in metres", clearance)}});
  return all;
}

}  // namespace rotor
