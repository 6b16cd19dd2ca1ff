/// How the landmarks of the text converge: by the event method's tolerance, and by the steps of the
/// paper's method. What a run starts from is converged, so that each sees its own part alone.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rotor {

/// Tolerances, and steps in those of the paper, from coarse to fine; each step is half the last.
std::span<const double> studied_tolerances();
std::span<const double> studied_steps();

struct Convergence {
  std::string landmark, unit;
  double converged;                            ///< event method at tolerance 1e-13
  std::vector<double> by_tolerance, by_steps;  ///< values
  std::vector<double> orders;  ///< of each three successive steps; NaN if there is none

  double error_by_tolerance(std::size_t n) const;  ///< relative
  double error_by_steps(std::size_t n) const;

  /// By which power of the tolerance, and of the step, the error falls: least squares.
  double power_of_tolerance() const, power_of_step() const;

  /// Roache's grid convergence index at the paper's own step, from it and the two coarser ones,
  /// relative, with his factor of safety for three grids. None outside the asymptotic range: where
  /// successive orders do not agree within a tenth.
  std::optional<double> grid_convergence_index() const;
};

std::vector<Convergence> studied_convergence();

std::string convergence_table(const std::vector<Convergence>& all);
std::string to_csv(const std::vector<Convergence>& all);

}  // namespace rotor
