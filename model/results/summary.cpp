#include "model/results/summary.ipp"

namespace rotor {
template class BasicSummaryObserver<double>;
}  // namespace rotor
