/// Recomputes reference-data/reasons-tried.csv: `reasons FOLDER DRAWS`.
#include <fmt/format.h>

#include <thread>

#include "figures/data/files.hpp"
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
  FileTransaction files;
  files.write(
      folder / "reasons-tried.csv",
      fmt::format(
          "# How often the statements of reasons.csv fail on a random rotor and a random pair of "
          "values, with the verdict of policy.md, from `make reasons`; not from the paper.\n"
          "# rotor " ROTOR_VERSION
          ", {} draws of verification/paper/reasons.toml. apply: pairs to which the statement "
          "applies; violate: of these, pairs that violate it;\n"
          "# share: violate over apply; size: median of the largest force at the riskier value "
          "over that at the other one, in the pairs that violate it\n"
          "# (harmless: of that at low speed over that at 150 Hz); example: the "
          "first violation, as options of `rotor run` with both values.\n",
          draws) +
          to_csv(reasons, tried(reasons, Equations::published, draws, threads),
                 tried(reasons, Equations::consistent, draws, threads)));
  files.commit();
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("reasons", rotor::main, argc, argv); }
