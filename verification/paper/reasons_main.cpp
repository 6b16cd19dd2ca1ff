/// Recomputes reference-data/reasons-tried.csv: `reasons FOLDER DRAWS`.
#include <fmt/format.h>

#include <thread>

#include "verification/paper/ensembles.hpp"
#include "verification/paper/reasons.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

int main(const Arguments& arguments) {
  if (arguments.size() != 2) throw std::runtime_error("needs: FOLDER DRAWS");
  const std::filesystem::path folder = arguments[0];
  const long draws = std::stol(arguments[1]);
  const auto reasons = read_reasons(folder / "reasons.csv");
  const int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  constexpr long seeds = 5;
  std::string csv = fmt::format(
      "# How often the statements of reasons.csv hold on a random rotor and a random pair of "
      "values, from `make reasons`; not from the paper.\n"
      "# rotor " ROTOR_VERSION
      ", {} draws of verification/paper/reasons.toml with each of the seeds 1 to {}. runs: pairs "
      "to which the statement applies; agree: share of these in which it holds.\n"
      "reason,equations,pairs,runs,agree\n",
      draws, seeds);
  for (const Set& set : sets) {
    std::vector<Trial> pooled(reasons.size());
    for (long seed = 1; seed <= seeds; ++seed) {
      const auto trials = tried(reasons, set.equations, seed, draws, threads);
      for (std::size_t r = 0; r < reasons.size(); ++r) pooled[r] += trials[r];
    }
    for (std::size_t r = 0; r < reasons.size(); ++r)
      csv += fmt::format("{},{},{},{},{:.4f}\n", reasons[r].id, set.name, pooled[r].pairs,
                         pooled[r].apply, pooled[r].share());
  }
  write_file(folder / "reasons-tried.csv", csv);
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("reasons", rotor::main, argc, argv); }
