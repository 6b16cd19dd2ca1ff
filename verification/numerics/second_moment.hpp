/// A second constant moment beside the motor's, added as model/README.md says. All sources of the
/// program second-moment are compiled with it; no other program is.
#pragma once

#include "model/mechanics/loads.hpp"

namespace rotor {

struct SecondMoment {
  static constexpr std::string_view name = "second_moment";
  static inline double of_program = 0;  ///< N m

  double moment(bool /*motor_on*/) const { return of_program; }
  double power(const Motion<double>& motion, bool /*motor_on*/) const {
    return of_program * motion.speed;
  }
};

template <>
struct LoadList<double> {
  Supports<double> supports;
  Weight<double> weight;
  Motor<double> motor;
  SecondMoment second{};

  LoadList(const Parameters& p, Equations equations)
      : supports(p), weight(p, equations), motor(p) {}

  auto varying() const { return std::tie(supports, weight); }
  auto constant() const { return std::tie(motor, second); }
};

}  // namespace rotor
