/// Integrals over smooth parts of a run.
#pragma once

#include <boost/math/quadrature/gauss.hpp>

namespace rotor {

/// Shows the nodes of Gauss's rule with seven of them, exact for polynomials of degree 13, in each
/// of so many equal parts of an interval, with the weights: use(at, weight).
template <class Use>
void gauss_nodes(double from, double until, long parts, const Use& use) {
  using Rule = boost::math::quadrature::gauss<double, 7>;
  const double part = (until - from) / static_cast<double>(parts);
  for (long n = 0; n < parts; ++n) {
    const double middle = from + part * (static_cast<double>(n) + 0.5);
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      const double away = part / 2 * Rule::abscissa()[i], weight = part / 2 * Rule::weights()[i];
      use(middle + away, weight);
      if (i > 0) use(middle - away, weight);
    }
  }
}

}  // namespace rotor
