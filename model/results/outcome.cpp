#include "model/results/outcome.ipp"

namespace rotor {
template class BasicOutcomeWatch<double>;
template double reach(const Body<double>&, const Supports<double>&, const Motion<double>&);
}  // namespace rotor
