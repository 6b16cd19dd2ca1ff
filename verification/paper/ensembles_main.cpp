/// Recomputes reference-data/ensembles.csv: every reading over the rounding of the
/// printed inputs: `ensembles FOLDER COUNT`.
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
  const auto readings = readings_to_draw(numbers);
  const int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const auto drawn = [&](Rounded rounded, const char* what) {
    long next = 0;
    return draw(readings, folder / "printed-inputs.csv", rounded, count, threads, [&](long done) {
      if (done < next) return;
      fmt::print(stderr, "{}: {} of {} draws\n", what, done, count);
      next = done + std::max(1L, count / 10);
    });
  };
  const Draws times = drawn(Rounded::times, "instants of the mass loss");
  const Draws everything = drawn(Rounded::everything, "every printed digit");
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
  files.commit();
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("ensembles", rotor::main, argc, argv); }
