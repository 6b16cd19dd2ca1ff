#include <cfloat>

#include "model/certified/comparison.ipp"

namespace rotor {
template class EventMethod<long double>;
#if LDBL_MANT_DIG == 64  // where it is not, it is double or Quad
template std::optional<Comparison> compare<long double>(const Scenario&, double,
                                                        const ShouldContinue&);
#endif
}  // namespace rotor
