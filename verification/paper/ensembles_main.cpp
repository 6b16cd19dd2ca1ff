/// Recomputes reference-data/ensembles.csv, every reading over the rounding of the printed inputs,
/// and accidents.csv, the accidents in both sets of equations: `ensembles FOLDER COUNT`.
#include <fmt/format.h>

#include <set>
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
  const auto drawn = [&](const std::vector<std::string>& readings, Rounded rounded,
                         const Equations& equations, const char* what) {
    return draw(readings, folder / "printed-inputs.csv", rounded, equations, count, threads,
                [&, next = 0L](long done) mutable {
                  if (done < next) return;
                  fmt::print(stderr, "{}: {} of {} draws\n", what, done, count);
                  next = done + std::max(1L, count / 10);
                });
  };
  const auto of_claims = readings_to_draw(numbers), of_accidents = readings_of_accidents();
  std::set<std::string> of_both(of_claims.begin(), of_claims.end());
  of_both.insert(of_accidents.begin(), of_accidents.end());
  const Draws times =
      drawn(of_claims, Rounded::times, Equations::published, "instants of the mass loss");
  const Draws everything = drawn({of_both.begin(), of_both.end()}, Rounded::everything,
                                 Equations::published, "every printed digit");
  const Draws consistent =
      drawn(of_accidents, Rounded::everything, Equations::consistent, "accidents put right");
  FileTransaction files;
  files.write(folder / "ensembles.csv",
              fmt::format("# What the rounding of the printed inputs leaves of each reading, from "
                          "`make ensembles`; not from the paper.\n"
                          "# rotor " ROTOR_VERSION
                          ", published equations, method event at tolerance 1e-8; {} draws of "
                          "Sobol's sequence, seed 1.\n"
                          "# _times: of the instants of the mass loss alone; _all: of every input "
                          "of printed-inputs.csv. p5, p95: quantiles; share: in which the claim "
                          "holds.\n",
                          count) +
                  ensembles_csv(numbers, times, everything));
  files.write(
      folder / "accidents.csv",
      fmt::format(
          "# What becomes of each loss that the text lets lead to an accident, with mu = 0.3, "
          "over every printed digit, from `make ensembles`; not from the paper.\n"
          "# rotor " ROTOR_VERSION
          ", method event at tolerance 1e-8; {} draws of Sobol's sequence, seed 1, "
          "the same in both sets of equations.\n"
          "# median, p5, p95: of the largest force where there is contact.\n",
          count) +
          accidents_csv(everything, consistent));
  files.commit();
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("ensembles", rotor::main, argc, argv); }
