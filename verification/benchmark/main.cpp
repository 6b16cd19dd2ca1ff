/// Run time against error: each method, over its steps or tolerances, on scenes of the paper.
/// `benchmark FOLDER` prints tables and writes FOLDER/work-precision.csv. Only ratios of
/// times are comparable between machines. The reference is a run in extended precision by
/// another stepper.
#include <fmt/format.h>

#include <cmath>

#include "figures/data/files.hpp"
#include "verification/benchmark/methods.hpp"
#include "verification/benchmark/tables.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

void enter_methods(const Problem& problem, const std::vector<Peer>& peers,
                   Measurement& measurement) {
  const auto enter = [&](const std::string& method, int first, int last, const auto& solve) {
    for (int digits = first; digits <= last; ++digits)
      measurement.enter(method, power_of_ten(digits),
                        [=](const Problem& p) { return solve(p, std::pow(10, -digits)); });
  };
  enter(ours, 3, 12, by_events);
  enter("event Fehlberg 7(8)", 4, 11, by_events_fehlberg78);
  const double step = problem.is_run_up ? Scenario{}.step_run_up : Scenario{}.step_rub;
  for (const int part : {1, 2, 4, 8, 16})
    measurement.enter(published, fmt::format("h/{}", part),
                      [=](const Problem& p) { return by_fixed_steps(p, step / part); });
  for (const Peer& peer : peers) enter(peer.name, 4, 11, peer.solve);
  enter("Odeint off the shelf", 3, 6, by_odeint_off_the_shelf);
}

int main(const Arguments& arguments) {
  if (arguments.size() != 1) throw std::runtime_error("needs: FOLDER");
  const std::filesystem::path folder = arguments[0];
  std::filesystem::create_directories(folder);
  const std::vector<Peer> installed = peers();
  const std::vector<Problem> all = problems();
  std::vector<Outcome> exact;
  for (const Problem& problem : all) exact.push_back(by_reference(problem));

  Measurement measurement(0.1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    // The error of the reference, estimated by another stepper and tolerance.
    const Outcome other = by_other_reference(all[i]);
    measurement.add({.problem = all[i].name,
                     .method = "reference",
                     .setting = "",
                     .error_state = std::max(1e-17, state_error(all[i], other, exact[i])),
                     .error_event_s = event_error(other, exact[i]),
                     .error_peak = peak_error(other, exact[i])});
    enter_methods(all[i], installed, measurement);
    measurement.run(all[i], exact[i]);
  }
  print_ratios(measurement.rows());
  FileTransaction files;
  files.write(folder / "work-precision.csv", to_csv(measurement.rows()));
  files.commit();
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("benchmark", rotor::main, argc, argv); }
