/// The paper's linear ring, and other rings that give way as far under the same blow or in the same
/// rolling: whether "it appears acceptable to linearize the contact zone response".
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "model/theory/accident.hpp"
#include "verification/paper/paper_runs.hpp"

namespace rotor {

/// Exponents of other rings; the paper's is 1.
inline constexpr std::array other_exponents = {1.25, 1.5};

/// Where another ring is indented as far as the linear one: in the first impact, or in rolling.
/// These are two choices of its stiffness.
enum class SameIndentation { impact, rolling };

/// How far a mass that strikes a ring indents it, m, by RK4: to 1e-6 of it.
inline double deepest_indentation(const Parameters& p, double mass, double velocity) {
  const ContactLaw<double> law(p);
  const double h = 1e-2 * std::sqrt(mass / Ring<double>(p).typical_stiffness());
  const auto rate = [&](double x, double v) { return law.force(x, v) / mass; };
  double x = 0, v = velocity;
  while (v > 0) {
    const double a1 = rate(x, v), v2 = v + h / 2 * a1, a2 = rate(x + h / 2 * v, v2),
                 v3 = v + h / 2 * a2, a3 = rate(x + h / 2 * v2, v3), v4 = v + h * a3,
                 a4 = rate(x + h * v3, v4);
    x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return x - v * v / rate(x, v) / 2;
}

/// The numbers of another ring with the same dashpot. Empty if the rotor does not roll in the
/// linear ring.
inline std::optional<std::map<std::string, double>> numbers_of(double exponent,
                                                               SameIndentation same,
                                                               PaperRuns& runs) {
  const PaperRun& linear = runs.high();
  const std::size_t touch_downs = linear.touch_downs_before_rolling();
  if (touch_downs == 0 || !linear.at_peak()) return std::nullopt;
  Parameters p = linear.scenario().parameters;
  const Ring<double> ring(p);
  const auto [k_t, d_t] = ring.law.required_linear();
  const double mass = MassLoss<double>(p).after.mass;
  const double velocity =
      ring.rim_point(linear.touch_down_before_rolling(touch_downs - 1)->motion()).normal_velocity;
  p.contact_exponent = exponent;
  if (same == SameIndentation::impact) {
    const double swing = swing_after_blow(d_t / (2 * std::sqrt(k_t * mass)));
    p.reference_indentation = velocity / std::sqrt(k_t / mass) * swing;
    for (int n = 0; n < 8; ++n)  // each divides the error by ten or more
      p.contact_stiffness *= std::pow(
          deepest_indentation(p, mass, velocity) / p.reference_indentation, p.contact_exponent + 1);
  } else {
    p.reference_indentation = ring.rim_point(linear.at_peak()->motion()).indentation;
  }
  return {{{"contact_stiffness", p.contact_stiffness},
           {"contact_exponent", p.contact_exponent},
           {"reference_indentation", p.reference_indentation}}};
}

}  // namespace rotor
