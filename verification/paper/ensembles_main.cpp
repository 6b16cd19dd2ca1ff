/// Recomputes reference-data/ensembles.csv, every reading over the populations of policy.md:
/// `ensembles FOLDER COUNT`.
#include <fmt/format.h>

#include <thread>

#include "figures/data/files.hpp"
#include "verification/paper/claims.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

int main(const Arguments& arguments) {
  if (arguments.size() != 2) throw std::runtime_error("needs: FOLDER COUNT");
  const std::filesystem::path folder = arguments[0];
  const long count = std::stol(arguments[1]);
  const auto numbers = read_numbers(folder / "claims.csv");
  const int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::string csv = fmt::format(
      "# Each reading over the populations of policy.md, from `make ensembles`; not from "
      "the paper.\n"
      "# rotor " ROTOR_VERSION
      ", method event at tolerance 1e-8; {} draws, seed 1: (a) of Sobol's sequence, (b) "
      "independent ones.\n"
      "# valued: share of the draws with a value; median, p5, p95: of those; holds: share of the "
      "draws in which the claim holds.\n"
      "equations,population,number,reading,draws,valued,median,p5,p95,holds\n",
      count);
  for (const auto& [name, population] : {std::pair("a", Population::a), {"b", Population::b}}) {
    const PopulationDraws draws(population, folder, count);
    for (const Set& set : sets) {
      const auto at = [&](long n) { return draws(n, set.equations); };
      const auto report = [&, name = name, next = 0L](long done) mutable {
        if (done < next) return;
        fmt::print(stderr, "({}), {} equations: {} of {} draws\n", name, set.name, done, count);
        next = done + std::max(1L, count / 10);
      };
      csv += ensembles_rows(numbers, set.name, name,
                            evaluate(readings_to_draw(numbers), count, at, threads, report));
    }
  }
  FileTransaction files;
  files.write(folder / "ensembles.csv", csv);
  files.commit();
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("ensembles", rotor::main, argc, argv); }
