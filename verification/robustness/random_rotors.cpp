/// `random-rotors COUNT FOLDER` runs random rotors by the event-located method, and writes the
/// results to a folder. Fails if a run was wrong without an error.
#include <fmt/format.h>

#include <map>

#include "figures/data/files.hpp"
#include "figures/input/names.hpp"
#include "verification/support/balance.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/program.hpp"
#include "verification/support/random_scenarios.hpp"

namespace rotor {
namespace {

/// A run with its balances, which checks that a rotor reported as free is clear of the ring.
class Inspection : public BalanceObserver {
 public:
  Inspection(const Scenario& scenario, const Instant& first)
      : BalanceObserver(scenario), clearance_(Ring<double>(scenario.parameters).clearance) {
    constexpr double duration_s = 0.01;
    try {
      right_hand_sides = follow(scenario, first, duration_s, *this).counters.right_hand_sides;
    } catch (const std::runtime_error& error) {
      const std::string reason = error.what();
      refusal = reason.substr(reason.find(": ") + 2, 40);
    }
    residual = std::max(energy_residual(), angular_momentum_residual());
  }

  void on_instant(const Instant& at) override {
    BalanceObserver::on_instant(at);
    for (const double component : at.state) is_finite = is_finite && std::isfinite(component);
    touch_downs += at.event == Event::touch_down;
  }
  void on_step(const DenseOutput& motion) override {
    BalanceObserver::on_step(motion);
    constexpr int samples = 32;
    for (int i = 0; i <= samples; ++i) {
      const Instant at = motion.at(motion.from_s + (motion.until_s - motion.from_s) * i / samples);
      if (at.contact == ContactState::free)
        penetration = std::max(penetration, at.motion().displacement.norm() / clearance_ - 1);
    }
  }

  // A flight's step may be wrong by the tolerance of 1/300 of the clearance, and there may be a
  // thousand; the balances are those of an error of 1e-9 a step, multiplied by contacts.
  static constexpr double allowed_penetration = 1e-8, allowed_residual = 1e-6;
  bool missed_contact() const { return penetration > allowed_penetration; }
  bool is_unbalanced() const { return !(residual < allowed_residual); }
  bool is_flagged() const {
    return !refusal.empty() || !is_finite || missed_contact() || is_unbalanced();
  }

  std::string refusal;  ///< why it ended early, if it did
  bool is_finite = true;
  double penetration = 0, residual = 0;  ///< relative to the clearance, and to the contents
  long touch_downs = 0, right_hand_sides = 0;

 private:
  double clearance_;
};

std::string describe(const Scenario& s, const Instant& at) {
  std::string text;
  for (const Quantity& quantity : quantities())
    text += fmt::format("{}={} ", quantity.name, quantity.of(s));
  return text + fmt::format("speed={} equations={}", at.state[5], name_of(s.equations));
}

int main(const Arguments& arguments) {
  if (arguments.size() != 2) throw std::runtime_error("needs: COUNT FOLDER");
  const long count = std::stol(arguments[0]);
  std::string flagged = "rotor,refusal,finite,penetration,residual,parameters\n";
  std::map<std::string, long> refusals;
  long touch_downs = 0, right_hand_sides = 0, reruns = 0;
  long not_finite = 0, missed = 0, unbalanced = 0, failed = 0;
  double worst_residual = 0, worst_penetration = 0;
  RandomScenarios random(1);
  for (long n = 0; n < count; ++n) {
    Scenario scenario = random.scenario();
    const Instant first = mass_lost_at_speed(scenario, random.speed());
    const Inspection found(scenario, first);
    touch_downs += found.touch_downs;
    right_hand_sides += found.right_hand_sides;
    worst_residual = std::max(worst_residual, found.residual);
    worst_penetration = std::max(worst_penetration, found.penetration);
    if (!found.is_flagged()) continue;
    // Errors of integration fall with the tolerance; a missed contact or a wrong balance remains.
    ++reruns;
    scenario.tolerance /= 100;
    const Inspection again(scenario, first);
    if (!again.is_flagged()) continue;
    ++failed;
    if (!again.refusal.empty()) ++refusals[again.refusal];
    not_finite += !again.is_finite;
    missed += again.missed_contact();
    unbalanced += again.is_unbalanced();
    flagged += fmt::format("{},{},{},{},{},{}\n", n, again.refusal, again.is_finite,
                           again.penetration, again.residual, describe(scenario, first));
  }
  fmt::print(
      "\n{} random rotors, {} touch-downs, {} right-hand sides\n"
      "at a tolerance of 1e-9: penetration of the ring while free {:.1e} of the clearance at most, "
      "residual of energy or angular momentum {:.1e} at most\n"
      "flagged and run again at 1e-11: {}; left of them: not finite {}, contacts missed {} (more "
      "than {:.0e}), unbalanced {} (more than {:.0e})\n",
      count, touch_downs, right_hand_sides, worst_penetration, worst_residual, reruns, not_finite,
      missed, Inspection::allowed_penetration, unbalanced, Inspection::allowed_residual);
  for (const auto& [reason, number] : refusals) fmt::print("  refused {}: {}\n", number, reason);
  FileTransaction files;
  files.write(std::filesystem::path(arguments[1]) / "flagged-rotors.csv", flagged);
  files.commit();
  return failed == 0 ? 0 : 1;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  return rotor::run_program("random-rotors", rotor::main, argc, argv);
}
