/// Numerical and input uncertainty of each number of the text side by side, in the terms of ASME
/// V&V 20, and which input decides it. There is no experiment: what is compared with is the number
/// as printed.
#pragma once

#include "verification/paper/claims.hpp"

namespace rotor {

/// Readings with one input at the least and the greatest value that its digits allow, all others as
/// printed: draws 2n and 2n + 1 are those of the n-th input.
Draws one_at_a_time(const std::vector<std::string>& readings, const std::vector<InputRange>& ranges,
                    int threads);

/// An estimate with the ends of its interval of 95 % confidence.
struct Estimate {
  double value, low, high;
};

/// What an input does to a reading: one at a time, and Sobol's indices, which are shares of the
/// variance over the rounding of all inputs: by it alone, and with whatever it takes part in.
struct Influence {
  std::string reading, input;
  double at_least, at_greatest;
  Estimate first, total;
};
std::vector<Influence> read_ranking(const std::filesystem::path& ranking);

/// Those of a reading, the one with the greatest total index first.
std::vector<Influence> ranked(const std::vector<Influence>& all, const std::string& reading);

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
  std::vector<Influence> decided_by;  ///< the inputs with the greatest total indices first
};

/// Of what is simulated and is no mere yes or no.
std::vector<Uncertainty> uncertainties(const std::vector<Number>& numbers,
                                       const std::vector<Influence>& ranking);

std::string to_csv(const std::vector<Uncertainty>& all);

}  // namespace rotor
