#include "model/simulation/extended/comparison.ipp"

namespace rotor {
template std::optional<Comparison> compare<long double>(const Scenario&, double, const GoesOn&);
}  // namespace rotor
