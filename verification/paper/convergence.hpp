/// How the landmarks of the text converge: by the event method's tolerance, and by the steps of the
/// paper's method. What a run starts from is converged, so that each sees its own part alone.
#pragma once

#include <string>
#include <vector>

namespace rotor {

/// A landmark by one of the methods, at its settings from coarse to fine.
struct Convergence {
  std::string landmark, unit, method;
  double converged;                      ///< event method at tolerance 1e-13
  std::vector<double> settings, values;  ///< tolerances; or steps in those of the paper

  double error(std::size_t n) const;  ///< relative
  /// By which power of the setting the error falls: least squares, leaving out what is rounding.
  double power() const;
};

std::vector<Convergence> studied_convergence();

std::string convergence_table(const std::vector<Convergence>& all);
std::string to_csv(const std::vector<Convergence>& all);

}  // namespace rotor
