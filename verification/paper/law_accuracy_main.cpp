/// Writes reference-data/laws.csv: `law-accuracy TABLE SWEEP.csv...`.
#include "verification/paper/law_accuracy.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

int main(const Arguments& arguments) {
  if (arguments.size() < 2) throw std::runtime_error("needs: TABLE SWEEP.csv...");
  LawAccuracy all;
  for (std::size_t n = 1; n < arguments.size(); ++n)
    read_csv(arguments[n], [&](const CsvRow& rotor) { all.add(rotor); });
  write_file(
      arguments[0],
      R"(# The accuracy of the closed forms of model/theory on the random rotors of verification/paper/laws.toml, pooled over
# five seeds, from `make laws`; not from the paper. share: of the unbalance, kappa e_x1/(mu r), from and up to. rolling_speed,
# peak_force: the run's value over the law's, of runs that roll; agree: the share within 10 %. Other quantities: agree is the
# share of the runs of which that is true.
)" + all.csv());
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  return rotor::run_program("law-accuracy", rotor::main, argc, argv);
}
