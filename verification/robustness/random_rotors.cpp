/// `random-rotors COUNT FOLDER` runs random rotors, and checks their balances, their largest
/// values, that each result is what the motion gives, that runs which stop at their outcome report
/// what the whole run does, and that Newton's laws, integrated in another way, give the same; then
/// the largest values of four times as many that drift near the centre. Fails if one is wrong. The
/// folder gets the options of all of the first, which `random-rotors COUNT` prints instead.
#include <fmt/format.h>

#include "verification/support/balance.hpp"
#include "verification/support/contradiction.hpp"
#include "verification/support/dense_maxima.hpp"
#include "verification/support/newton.hpp"
#include "verification/support/program.hpp"
#include "verification/support/random_runs.hpp"
#include "verification/support/result_formulas.hpp"

namespace rotor {
namespace {

/// The balances of a run, and whether it is clear of the ring where it is reported as free.
class Inspection : public BalanceObserver {
 public:
  explicit Inspection(const Scenario& scenario)
      : BalanceObserver(scenario), clearance_(Ring<double>(scenario.parameters).clearance) {}

  void on_instant(const Instant& at) override {
    BalanceObserver::on_instant(at);
    for (const double component : at.state) is_finite = is_finite && std::isfinite(component);
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
  double residual() const { return std::max(energy_residual(), angular_momentum_residual()); }

  bool is_finite = true;
  double penetration = 0;  ///< relative to the clearance

 private:
  double clearance_;
};

RunResult result(const Scenario& scenario, std::optional<StopOn> stop_on, Observer& observer) {
  return complete_run(RunUpCheckpoint(scenario), scenario, stop_on, observer);
}

/// The largest difference of two summaries, relative to the values or to what they are parts of,
/// and where it is; infinite if one has an event, or a count, that the other has not.
struct Difference {
  double size = 0;
  std::string_view key;

  Difference(const Summary& a, const Summary& b, const Scenario& scenario) {
    const Ring<double> ring(scenario.parameters);
    const double length = 1e-6 * ring.clearance;
    for (const auto& field : summary_fields<double>) {
      double base = field.error_base ? std::abs(field.error_base(b)) : 0;
      if (field.scale == ErrorScale::length) base = std::max(base, length);
      if (field.scale == ErrorScale::force)
        base = std::max(base, length * scenario.parameters.support_stiffness);
      // A speed of 0 is known to rounding, and so is rest.
      if (field.key.ends_with("_Hz")) base = std::max(base, 1e-6 * b.critical_speed_Hz);
      if (field.key == "speed_ratio_at_mass_loss") base = std::max(base, 1e-6);
      if (field.key == "final_kinetic_energy_J")
        base = std::max(base, length * length * scenario.parameters.support_stiffness);
      // A maximum is flat: where it is is known to less than how long a contact lasts.
      if (field.key == "peak_time_s")
        base = std::max(
            base, 1e-3 / natural_frequency(ring.typical_stiffness(), scenario.parameters.mass));
      // In a graze it is as uncertain as the position: by 1e-7 of the clearance where 1e-4 is
      // allowed.
      if (field.scale == ErrorScale::force && field.key.find("bearing") == std::string_view::npos)
        base = std::max(base, ring.law.spring_force(1e-3 * ring.clearance));
      // Fixed steps know times to a step, and of two nearly equal maxima not which is the larger.
      if (scenario.method == Method::rk4 && field.key.ends_with("_s")) continue;
      const double off = std::visit(
          [&](auto member) {
            const auto &x = a.*member, &y = b.*member;
            return x == y ? 0 : relative(x, y, base);
          },
          field.value);
      if (off > size) {
        size = off;
        key = field.key;
      }
    }
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  static double relative(double x, double y, double base) {
    return std::abs(x - y) / std::max({std::abs(x), std::abs(y), base});
  }
  static double relative(const std::optional<double>& x, const std::optional<double>& y,
                         double base) {
    return x && y ? relative(*x, *y, base) : infinite;
  }
  template <class Count>
  static double relative(const Count& /*x*/, const Count& /*y*/, double /*base*/) {
    return infinite;
  }
};

std::optional<Summary> by_newton(const Scenario& scenario, double tolerance, double per_period) {
  SummaryObserver observer(scenario);
  constexpr long most_steps = 100'000;
  if (!run_by_newton(scenario, {tolerance, per_period, most_steps}, observer)) return std::nullopt;
  return observer.summary();
}

/// What is seen of all rotors.
struct Findings {
  // A flight's step may be wrong by the tolerance of 1/300 of the clearance, and there may be a
  // thousand; the balances are those of an error of 1e-9 a step, multiplied by contacts.
  static constexpr double allowed_penetration = 1e-8, allowed_residual = 1e-6;
  // Newton's laws are integrated twice, with steps and tolerances that differ by factors of 1.4 and
  // 100. Contacts amplify: what these two do not determine is left out, at most so much of it.
  // So does a graze: the coarser has a clearance that is larger by this share.
  static constexpr double sure = 1e-5, most_left_out = 0.25, graze = 1e-12;
  // Ten times what the coarser of the two may be wrong.
  static constexpr double allowed_difference = 10 * sure;
  // Fixed steps are of first order at contacts: a quarter of them leaves a third of the difference,
  // and as an event lies anywhere in its step, that is the largest of three step sizes.
  static constexpr double sure_in_steps = 1e-2, allowed_in_steps = 10;

  long touched = 0, rolled = 0, reruns = 0, sooner = 0, compared = 0, fixed_steps = 0;
  double penetration = 0, residual = 0, difference = 0;

  /// What is wrong with a rotor; empty if nothing is.
  std::string look_at(const Scenario& scenario) {
    std::string wrong = scenario.method == Method::event ? by_balances(scenario) : "";
    if (!wrong.empty()) {
      // Errors of integration fall with the tolerance; a missed contact or a wrong balance remains.
      ++reruns;
      Scenario finer = scenario;
      finer.tolerance = std::max(1e-13, scenario.tolerance / 100);
      wrong = by_balances(finer);
    }
    try {
      return wrong + by_maxima(scenario) + wrong_results(scenario) + by_early_end(scenario) +
             by_newtons_laws(scenario);
    } catch (const std::runtime_error&) {
      if (scenario.method == Method::rk4) return "";  // its steps are too long for this rotor
      throw;
    }
  }

  /// At the tolerance of maps, that of figures and a loose one.
  static std::string by_maxima(Scenario scenario) {
    std::string wrong;
    if (scenario.method == Method::event)
      for (const double tolerance : {1e-6, 1e-8, 1e-11}) {
        scenario.tolerance = tolerance;
        wrong += exceeded_maximum(scenario);
      }
    return wrong;
  }

 private:
  static Scenario in_steps(Scenario scenario, double share) {
    scenario.step_run_up *= share;
    scenario.step_rub *= share;
    return scenario;
  }

  std::string by_balances(const Scenario& scenario) {
    Inspection inspection(scenario);
    const Summary summary = result(scenario, {}, inspection).summary;
    touched += summary.touch_downs > 0;
    rolled += summary.outcome == Outcome::rolling;
    penetration = std::max(penetration, inspection.penetration);
    residual = std::max(residual, inspection.residual());
    if (!inspection.is_finite) return "not finite; ";
    if (inspection.penetration > allowed_penetration) return "a contact is missed; ";
    if (!(inspection.residual() < allowed_residual))
      return fmt::format("the balances are {:.1e} off; ", inspection.residual());
    return "";
  }

  std::string by_early_end(const Scenario& scenario) {
    const RunResult stopped = result(scenario, StopOn::outcome, nobody);
    sooner += stopped.early.stop_reached;
    const std::string key = contradiction(stopped, result(scenario, {}, nobody));
    return key.empty() ? "" : fmt::format("{} differs where the run stops at its outcome; ", key);
  }

  std::string by_newtons_laws(const Scenario& scenario) {
    Scenario disturbed = scenario;
    double& stator_radius = disturbed.parameters.stator_radius;
    stator_radius += graze * Ring<double>(scenario.parameters).clearance + 4e-16 * stator_radius;
    const auto coarse = by_newton(disturbed, 1e-11, 12), fine = by_newton(scenario, 1e-13, 17);
    if (!coarse || !fine || !(Difference(*coarse, *fine, scenario).size < sure)) return "";
    Difference found(summary_of(scenario), *fine, scenario);
    double allowed = allowed_difference;
    Scenario finer = scenario;
    if (scenario.method == Method::rk4) {
      finer = in_steps(scenario, 0.25);
      const Summary of_finer = summary_of(finer);
      double of_steps = 0;
      for (const double share : {1.0, 0.71, 0.47})
        of_steps = std::max(
            of_steps, Difference(summary_of(in_steps(scenario, share)), of_finer, scenario).size);
      if (!(of_steps < sure_in_steps)) return "";
      found = Difference(of_finer, *fine, scenario);
      if (std::isinf(found.size)) return "";  // both may miss a contact that only grazes
      ++fixed_steps;
      allowed = allowed_in_steps * of_steps + allowed_difference;
    } else {
      ++compared;
      if (!(found.size < allowed)) {
        finer.tolerance = std::max(1e-13, scenario.tolerance / 100);
        found = Difference(summary_of(finer), *fine, scenario);
      }
      difference = std::max(difference, found.size);
    }
    if (found.size < allowed) return "";
    return fmt::format("{} is {:.1e} off Newton's laws; ", found.key, found.size);
  }
};

int main(const Arguments& arguments) {
  if (arguments.empty() || arguments.size() > 2) throw std::runtime_error("needs: COUNT [FOLDER]");
  const long count = std::stol(arguments[0]);
  RandomRuns random(1);
  if (arguments.size() == 1) {
    for (long n = 0; n < count; ++n) fmt::print("{}\n", options_of(random.rotor().stated));
    return 0;
  }
  Findings findings;
  std::string options;
  long failed = 0;
  // Runs are made to draw a rotor, too, and may fail.
  const auto judge = [&failed](std::string drawn, const auto& draw, const auto& look_at) {
    std::string wrong;
    try {
      const RandomInputs::Rotor rotor = draw();
      drawn = "rotor run " + options_of(rotor.stated);
      wrong = look_at(rotor.scenario);
    } catch (const std::exception& error) {
      wrong = error.what();
    }
    if (wrong.empty()) return;
    ++failed;
    fmt::print("{}\n  {}\n", drawn, wrong);
  };
  const auto draw = [&] {
    const RandomInputs::Rotor rotor = random.rotor();
    options += options_of(rotor.stated) + '\n';
    return rotor;
  };
  for (long n = 0; n < count; ++n)
    judge(fmt::format("draw {}", n), draw,
          [&](const Scenario& scenario) { return findings.look_at(scenario); });
  const long drifting = 4 * count;
  RandomInputs inputs(2);
  for (long n = 0; n < drifting; ++n)
    judge(
        fmt::format("draw {} of a drift", n), [&] { return drifting_rotor(inputs); },
        Findings::by_maxima);
  const double left_out = 1 - static_cast<double>(findings.compared + findings.fixed_steps) /
                                  static_cast<double>(count);
  fmt::print(
      "\n{} random rotors, of which {} touch the ring and {} roll: penetration of the ring while "
      "free {:.1e} of the clearance at most, residual of energy or angular momentum {:.1e} at "
      "most; {} run again at a finer tolerance\n"
      "{} stopped at their outcome before the end\n"
      "compared with Newton's laws: {} by events, largest difference {:.1e}, and {} by fixed "
      "steps; left out, because two tolerances or two steps differ: {:.0f} % (at most {:.0f} %)\n"
      "{} rotors drift near the centre; no sample of a motion exceeds its largest values\n"
      "wrong: {}\n",
      count, findings.touched, findings.rolled, findings.penetration, findings.residual,
      findings.reruns, findings.sooner, findings.compared, findings.difference,
      findings.fixed_steps, 100 * left_out, 100 * Findings::most_left_out, drifting, failed);
  write_file(std::filesystem::path(arguments[1]) / "random-rotors.txt", options);
  return failed == 0 && left_out <= Findings::most_left_out ? 0 : 1;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  return rotor::run_program("random-rotors", rotor::main, argc, argv);
}
