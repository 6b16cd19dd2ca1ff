#include <fmt/format.h>

#include <array>
#include <chrono>
#include <map>

#include "figures/data/files.hpp"
#include "figures/input/names.hpp"
#include "verification/robustness/stress.hpp"
#include "verification/support/balance.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/random_scenarios.hpp"
#include "verification/support/starts.hpp"

namespace rotor {
namespace {

/// Keeps the balances of a run, and looks for the rim beyond the ring where the run says it is
/// free.
class Inspector : public BalanceObserver {
 public:
  explicit Inspector(const Scenario& scenario)
      : BalanceObserver(scenario), clearance_(Ring<double>(scenario.parameters).clearance) {}

  void on_instant(const Instant& at) override {
    BalanceObserver::on_instant(at);
    for (const double component : at.state) finite_ = finite_ && std::isfinite(component);
    touch_downs_ += at.event == Event::touch_down;
  }
  void on_step(const DenseOutput& motion) override {
    BalanceObserver::on_step(motion);
    constexpr int samples = 32;
    for (int i = 0; i <= samples; ++i) {
      const Instant at = motion.at(motion.from_s + (motion.until_s - motion.from_s) * i / samples);
      if (at.contact == ContactState::free)
        penetration_ = std::max(penetration_, at.motion().displacement.norm() / clearance_ - 1);
    }
  }

  bool finite() const { return finite_; }
  long touch_downs() const { return touch_downs_; }
  double penetration() const {
    return penetration_;
  }  ///< of the ring while free, relative to the clearance

 private:
  double clearance_;
  bool finite_ = true;
  long touch_downs_ = 0;
  double penetration_ = 0;
};

/// What a run did.
struct Finding {
  std::string refusal;  ///< why it ended before its time, if it did
  bool finite = true;
  double penetration = 0, residual = 0;  ///< of the ring, and of the balances
  long touch_downs = 0, right_hand_sides = 0;

  // A flight's step may be wrong by the tolerance of 1/300 of the clearance, and there may be a
  // thousand; the balances are those of an error of 1e-9 a step, multiplied by contacts.
  static constexpr double allowed_penetration = 1e-8, allowed_residual = 1e-6;
  bool missed() const { return penetration > allowed_penetration; }
  bool is_unbalanced() const { return !(residual < allowed_residual); }
  bool is_flagged() const { return !refusal.empty() || !finite || missed() || is_unbalanced(); }
};

Finding inspect(const Scenario& scenario, const Instant& first) {
  constexpr double duration_s = 0.01;
  Inspector inspector(scenario);
  Finding finding;
  try {
    finding.right_hand_sides =
        follow(scenario, first, duration_s, inspector).counters.right_hand_sides;
  } catch (const std::runtime_error& error) {
    const std::string reason = error.what();
    finding.refusal = reason.substr(reason.find(": ") + 2, 40);
  }
  finding.finite = inspector.finite();
  finding.penetration = inspector.penetration();
  finding.residual = std::max(inspector.energy_residual(), inspector.angular_momentum_residual());
  finding.touch_downs = inspector.touch_downs();
  return finding;
}

struct Statistics {
  long ended = 0, refused = 0, touch_downs = 0, right_hand_sides = 0, reruns = 0;
  long not_finite = 0, missed = 0, unbalanced = 0;
  double worst_residual = 0, worst_penetration = 0;  ///< at first
  std::map<int, std::array<long, 2>> by_decade;  ///< how many residuals, penetrations below 10^key
  std::map<std::string, long> reasons;
};

/// The exponent of the power of ten above a residual; -17 for all that cannot be told from none.
int decade(double residual) {
  return std::max(-17, static_cast<int>(std::ceil(std::log10(std::max(residual, 1e-17)))));
}

std::string describe(const Scenario& s, const Instant& at) {
  std::string text;
  for (const Quantity& quantity : quantities())
    text += fmt::format("{}={} ", quantity.name, quantity.of(s));
  return text + fmt::format("speed={} equations={}", at.state[5], name_of(s.equations));
}

Statistics statistics_of(long count, std::string& worst) {
  Statistics statistics;
  RandomScenarios random(1);
  const auto begin = std::chrono::steady_clock::now();
  for (long n = 0; n < count; ++n) {
    Scenario scenario = random.scenario();
    const Instant first = mass_lost_at_speed(scenario, random.speed());
    Finding found = inspect(scenario, first);
    statistics.touch_downs += found.touch_downs;
    statistics.right_hand_sides += found.right_hand_sides;
    ++statistics.by_decade[decade(found.residual)][0];
    ++statistics.by_decade[decade(found.penetration)][1];
    statistics.worst_residual = std::max(statistics.worst_residual, found.residual);
    statistics.worst_penetration = std::max(statistics.worst_penetration, found.penetration);
    if (found.is_flagged()) {
      // Errors of integration fall with the tolerance; a contact missed or an open balance stays.
      ++statistics.reruns;
      scenario.tolerance /= 100;
      found = inspect(scenario, first);
    }
    ++(found.refusal.empty() ? statistics.ended : statistics.refused);
    if (!found.refusal.empty()) ++statistics.reasons[found.refusal];
    statistics.not_finite += !found.finite;
    statistics.missed += found.missed();
    statistics.unbalanced += found.is_unbalanced();
    if (found.is_flagged())
      worst += fmt::format("{},{},{},{},{},{}\n", n, found.refusal, found.finite, found.penetration,
                           found.residual, describe(scenario, first));
    if (n % 1000 == 999)
      fmt::print(stderr, "\r{} of {} rotors, {:.0f} s", n + 1, count,
                 std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  fmt::print(stderr, "\n");
  return statistics;
}

}  // namespace

int stress_rotors(long count, const std::filesystem::path& folder) {
  std::string worst = "rotor,refusal,finite,penetration,residual,parameters\n";
  const Statistics statistics = statistics_of(count, worst);
  fmt::print("\n{} random rotors ended, {} refused; {} touch-downs, {} right-hand sides\n",
             statistics.ended, statistics.refused, statistics.touch_downs,
             statistics.right_hand_sides);
  for (const auto& [reason, number] : statistics.reasons)
    fmt::print("  refused {}: {}\n", number, reason);
  fmt::print(
      "at a tolerance of 1e-9: penetration of the ring while free {:.1e} of the clearance at most, "
      "residual of energy or angular momentum {:.1e} at most\n",
      statistics.worst_penetration, statistics.worst_residual);
  fmt::print(
      "flagged and run again at 1e-11: {}; left of them: not finite {}, contacts missed {} (more "
      "than "
      "{:.0e}), unbalanced {} (more than {:.0e})\n",
      statistics.reruns, statistics.not_finite, statistics.missed, Finding::allowed_penetration,
      statistics.unbalanced, Finding::allowed_residual);
  FileTransaction files;
  files.write(folder / "flagged-rotors.csv", worst);
  std::string residuals = "below_ten_to_the,residuals,penetrations\n";
  for (const auto& [exponent, numbers] : statistics.by_decade)
    residuals += fmt::format("{},{},{}\n", exponent, numbers[0], numbers[1]);
  files.write(folder / "residuals.csv", residuals);
  files.commit();
  const bool all_well = statistics.refused == 0 && statistics.not_finite == 0 &&
                        statistics.missed == 0 && statistics.unbalanced == 0;
  return all_well ? 0 : 1;
}

}  // namespace rotor
