#include "model/certified/comparison.ipp"
#include "model/certified/quad.hpp"

namespace rotor {
template std::optional<Comparison> compare<Quad>(const Scenario&, double, const ShouldContinue&);
}  // namespace rotor
