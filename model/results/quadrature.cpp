#include "model/results/quadrature.hpp"

#include <boost/math/quadrature/gauss.hpp>

namespace rotor {

namespace {

std::array<GaussNode, 7> computed_rule() {
  using Rule = boost::math::quadrature::gauss<double, 7>;
  const auto& at = Rule::abscissa();  // of one half, from the middle
  const auto& weights = Rule::weights();
  std::array<GaussNode, 7> rule{{{0, weights[0]}}};
  for (std::size_t i = 1; i < at.size(); ++i) {
    rule[2 * i - 1] = {at[i], weights[i]};
    rule[2 * i] = {-at[i], weights[i]};
  }
  return rule;
}

}  // namespace

const std::array<GaussNode, 7>& gauss_rule() {
  static const auto rule = computed_rule();
  return rule;
}

}  // namespace rotor
