#include "model/results/summary.hpp"

namespace rotor {
template class BasicOutcomeWatch<double>;
template class BasicSummaryObserver<double>;
}  // namespace rotor
