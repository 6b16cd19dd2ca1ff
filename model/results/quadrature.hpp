/// Integrals over smooth parts of a run.
#pragma once

#include <array>

namespace rotor {

/// A node of Gauss's rule in [-1, 1], and its weight.
struct GaussNode {
  double at, weight;
};

/// The rule with seven nodes, exact for polynomials of degree 13.
const std::array<GaussNode, 7>& gauss_rule();

/// Shows the nodes of this rule in each of so many equal parts of an interval, with the weights:
/// use(at, weight).
template <class Use>
void gauss_nodes(double from, double until, long parts, const Use& use) {
  const double part = (until - from) / static_cast<double>(parts);
  for (long n = 0; n < parts; ++n) {
    const double middle = from + part * (static_cast<double>(n) + 0.5);
    for (const GaussNode& node : gauss_rule())
      use(middle + part / 2 * node.at, part / 2 * node.weight);
  }
}

}  // namespace rotor
