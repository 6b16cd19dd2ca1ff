/// The readings that need no run: arithmetic on the inputs, and on results as printed.
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "model/mechanics/mass_loss.hpp"
#include "model/theory/mass_loss_response.hpp"
#include "verification/paper/readings.hpp"
#include "verification/support/place_of_loss.hpp"

namespace rotor {
namespace {

/// Where on the rim a loss leaves the largest unbalance: degrees from opposite to the initial one.
double place_of_largest_unbalance(const Parameters& p) {
  int best = 0;
  const auto unbalance = [&](int degrees) {
    return PlaceOfLoss(p, degrees * two_pi / 360).unbalance();
  };
  for (int degrees = -179; degrees <= 180; ++degrees)
    if (unbalance(degrees) > unbalance(best)) best = degrees;
  return best;
}

/// The lowest speed with contact relative to the critical one, by the closed form: its change over
/// sixteenfold stiffness of the supports, %.
double border_by_ratio(Parameters p, const Equations& equations) {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for (const double factor : {0.25, 1., 4.}) {
    Parameters other = p;
    other.support_stiffness *= factor;
    const double critical = std::sqrt(other.support_stiffness / other.mass);
    const auto touches = [&](double ratio) {
      const MassLossResponse response(other, equations, ratio * critical);
      return response.first_contact() ? 1. : -1.;
    };
    const auto close = [](double a, double b) { return b - a < 1e-6; };
    const double border = boost::math::tools::bisect(touches, 2.5, 40., close).first;
    least = std::min(least, border);
    greatest = std::max(greatest, border);
  }
  return 100 * (greatest / least - 1);
}

}  // namespace

const std::map<std::string, Arithmetic>& all_arithmetic() {
  using In = const PaperInputs&;
  using P = const Parameters&;
  using Loss = MassLoss<double>;
  /// v_O and T_tra from the whirl and rho that the text reads off.
  static const auto velocity = [](In in) { return two_pi * in.rolling_Hz * in.rolling_rho; };
  static const auto translation = [](In in, P p) {
    return Loss(p).after.mass * std::pow(velocity(in), 2) / 2;
  };
  static const auto transient_s = [](P p, double factor) {
    return std::log(factor) * 2 * Loss(p).after.mass / p.support_damping;
  };
  static const auto natural_Hz = [](P p) { return in_Hz(std::sqrt(p.support_stiffness / p.mass)); };
  static const std::map<std::string, Arithmetic> all = {
      {"speed_rad", [](In, P p) { return two_pi * p.motor_off_Hz; }},
      {"lost_mass", [](In, P p) { return Loss(p).lost_mass; }},
      {"lost_share", [](In, P p) { return 100 * Loss(p).lost_mass / p.mass; }},
      {"unbalance_growth", [](In, P p) { return p.unbalance_factor; }},
      {"inertia_left", [](In, P p) { return Loss(p).after.inertia; }},
      {"inertia_share", [](In, P p) { return 100 * (1 - Loss(p).after.inertia / p.inertia); }},
      {"unbalance_before", [](In, P p) { return 1e5 * p.mass * p.eccentricity; }},
      {"unbalance_after",
       [](In, P p) { return 1e5 * Loss(p).after.mass * Loss(p).after.eccentricity; }},
      {"piece_velocity", [](In, P p) { return Loss(p).piece_velocity(two_pi * p.motor_off_Hz); }},
      {"velocity_jump", [](In, P p) { return Loss(p).velocity_jump(two_pi * p.motor_off_Hz); }},
      {"eigenfrequency", [](In, P p) { return natural_Hz(p); }},
      {"steps_a_turn", [](In, P p) { return 1 / (p.motor_off_Hz * Scenario{}.step_run_up); }},
      {"place_of_largest_unbalance", [](In, P p) { return place_of_largest_unbalance(p); }},
      {"translation_printed", translation},
      {"inertia_force_printed",
       [](In in, P p) {
         return Loss(p).after.mass * std::pow(two_pi * in.rolling_Hz, 2) * in.rolling_rho / 1e3;
       }},
      {"rolling_Hz_printed",
       [](In in, P p) { return in.onset_Hz * p.rotor_radius / in.rolling_rho; }},
      {"velocity_printed", [](In in, P) { return velocity(in); }},
      {"elastic_N_printed", [](In in, P p) { return in.rolling_rho * p.support_stiffness / 2; }},
      {"damping_N_printed", [](In in, P p) { return velocity(in) * p.support_damping / 2; }},
      {"sum_of_parts_printed",
       [](In in, P p) {
         return translation(in, p) + Loss(p).after.inertia * std::pow(two_pi * in.onset_Hz, 2) / 2;
       }},
      {"share_printed", [](In in, P) { return 100 * in.energy_left / in.energy_before; }},
      {"shortest_steps", [](In in, P) { return in.shortest_s / Scenario{}.step_rub; }},
      {"longest_steps", [](In in, P) { return in.longest_s / Scenario{}.step_rub; }},
      // Time until the free vibration after the loss has decayed by a factor, relative to t_1 and
      // in natural periods.
      {"transient_tenth", [](In in, P p) { return 100 * transient_s(p, 10) / in.t_50; }},
      {"transient_twentieth", [](In in, P p) { return 100 * transient_s(p, 20) / in.t_50; }},
      {"periods_tenth", [](In, P p) { return transient_s(p, 10) * natural_Hz(p); }},
      {"periods_twentieth", [](In, P p) { return transient_s(p, 20) * natural_Hz(p); }},
      // With half the stiffness, twice the mass; and at the operating speed beside half of it.
      {"critical_falls",
       [](In, P p) {
         const double here = p.support_stiffness / p.mass,
                      there = p.support_stiffness / 2 / (2 * p.mass);
         return there < here ? 1. : 0.;
       }},
      {"inertia_rises",
       [](In, P p) {
         const auto force = [&](double speed_Hz) {
           return Loss(p).after.mass * Loss(p).after.eccentricity * std::pow(two_pi * speed_Hz, 2);
         };
         return force(p.motor_off_Hz) > force(p.motor_off_Hz / 2) ? 1. : 0.;
       }},
      // The inertia force of the unbalance over the supports' force at the clearance.
      {"inertia_by_ratio",
       [](In, P p) {
         const auto force = [&](double part) {
           return Loss(p).after.mass * Loss(p).after.eccentricity *
                  std::pow(two_pi * part * p.motor_off_Hz, 2) /
                  (part * part * p.support_stiffness * (p.stator_radius - p.rotor_radius));
         };
         return 100 * std::abs(force(0.5) / force(1) - 1);
       }},
      {"border_by_ratio",
       [](In in, P p) {
         return border_by_ratio(p, in.spec.equations.value_or(Equations::published));
       }},
  };
  return all;
}

}  // namespace rotor
