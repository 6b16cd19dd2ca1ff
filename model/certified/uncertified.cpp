/// For programs that are not linked with the other sources of this folder.
#include "model/certified/comparison.hpp"

namespace rotor {

void require_certified() { throw NotCertified(); }

std::optional<Comparison> run_to_digits(const Scenario& /*scenario*/, int /*digits*/,
                                        const ShouldContinue& /*should_continue*/) {
  throw NotCertified();
}

double estimated_relative_error(const Scenario& /*scenario*/, const Summary& /*summary*/,
                                const ShouldContinue& /*should_continue*/) {
  throw NotCertified();
}

}  // namespace rotor
