/// Numerical and input uncertainty of each number of the text side by side, in the terms of ASME
/// V&V 20. There is no experiment: the simulated value is compared with the number as printed.
#pragma once

#include "verification/paper/claims.hpp"

namespace rotor {

/// All relative to the simulated value. NaN where there is none.
struct Uncertainty {
  std::string number, says, unit;
  double simulated;  ///< S, converged, by the first reading
  double error;      ///< E = S - D, D being the number as printed
  double u_num;      ///< of the event method at its default tolerance: change by a hundredth of it
  double u_num_own;  ///< of the paper's method at its own steps: its distance from S
  double u_times;    ///< half the range from 5 to 95 % of population (a)
  double u_input;    ///< the same of (b)
  double u_printed;  ///< half a unit of the last digit of D
};

/// For simulated numbers that are not just yes or no.
std::vector<Uncertainty> uncertainties(const std::vector<Number>& numbers);

std::string to_csv(const std::vector<Uncertainty>& all);

}  // namespace rotor
