#include "model/simulation/summary.ipp"

namespace rotor {
template class BasicSummaryObserver<double>;
}  // namespace rotor
