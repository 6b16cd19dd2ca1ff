#include "model/simulation/extended/comparison.ipp"
#include "model/simulation/extended/quad.hpp"

namespace rotor {
template std::optional<Comparison> compare<Quad>(const Scenario&, double, const GoesOn&);
}  // namespace rotor
