#include "verification/paper/reasons.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "figures/data/read_csv.hpp"
#include "figures/results/run_result.hpp"
#include "figures/sweep/sweep.hpp"
#include "verification/paper/ensembles.hpp"

namespace rotor {
namespace {

/// The largest normal force in rolling, N.
class RollingForce : public Observer {
 public:
  explicit RollingForce(const Scenario& scenario) : ring_(scenario.parameters) {}

  void on_instant(const Instant& at) override {
    rolls_ = at.contact == ContactState::rolling;
    if (rolls_) note(at);
  }
  double threshold(Extreme of, const double& from_s, const double& until_s) const override {
    return rolls_ && of == Extreme::normal_force ? largest
                                                 : Observer::threshold(of, from_s, until_s);
  }
  void on_maximum(const Maximum& maximum) override {
    if (rolls_ && maximum.of == Extreme::normal_force) note(maximum.at);
  }

  double largest = 0;

 private:
  void note(const Instant& at) {
    largest = std::max(largest, -ring_.normal_force(ring_.rim_point(at.motion())));
  }

  Ring<double> ring_;
  bool rolls_ = false;
};

}  // namespace

Trial trial_of(Criterion judged, const RubEnd& a, const RubEnd& b) {
  const bool both = a.rolls && b.rolls;
  if (judged == Criterion::rolls) return {1, a.rolls, both};
  if (judged == Criterion::touches) return {1, a.touches, a.touches && b.touches};
  if (judged == Criterion::force) return {1, both, both && b.in_rolling_N >= a.in_rolling_N};
  return {1, a.touches, a.touches && !a.rolls};
}

Trial& Trial::operator+=(const Trial& other) {
  pairs += other.pairs;
  apply += other.apply;
  hold += other.hold;
  return *this;
}

RubEnd end_of(const ScenarioSpec& spec) {
  const Scenario scenario = scenario_of(spec);
  RollingForce in_rolling(scenario);
  const Summary summary =
      complete_run(RunUpCheckpoint(scenario), scenario, StopOn::outcome, in_rolling).summary;
  return {summary.touch_downs > 0, summary.outcome == Outcome::rolling,
          summary.peak_force_to_rolling_N.value_or(0), in_rolling.largest};
}

std::vector<Reason> read_reasons(const std::filesystem::path& table) {
  static const std::map<std::string, Criterion> criteria = {{"rolls", Criterion::rolls},
                                                            {"touches", Criterion::touches},
                                                            {"force", Criterion::force},
                                                            {"harmless", Criterion::harmless}};
  std::vector<Reason> reasons;
  for (const CsvRow& row : read_csv(table)) {
    if (!criteria.contains(row["judged"])) row.fail("judged: must be a criterion of reasons.hpp");
    const auto number = [&](const char* column) { return static_cast<double>(row.number(column)); };
    reasons.push_back({row["reason"], row["quantity"], number("from"), number("until"),
                       row["spacing"] == "log", number("most_friction"),
                       criteria.at(row["judged"])});
  }
  return reasons;
}

std::vector<Trial> tried(const std::vector<Reason>& reasons, const Equations& equations, long seed,
                         long draws, int threads) {
  Sweep sweep = read_sweep(ROTOR_SOURCES "/verification/paper/reasons.toml");
  sweep.base.equations = equations;
  sweep.sample.seed = static_cast<unsigned>(seed);
  for (const char* share : {"share", "other_share"})
    sweep.sample.over.push_back({share, Distribution::uniform, 0, 1});
  const SweepPoints rotors(sweep);
  std::vector<std::vector<Trial>> all(static_cast<std::size_t>(draws));
  in_parallel(draws, threads, [&](long n) {
    ScenarioSpec rotor = rotors(n).spec;
    const std::array shares = {rotor.numbers.extract("share").mapped(),
                               rotor.numbers.extract("other_share").mapped()};
    const auto [less, more] = std::ranges::minmax(shares);
    std::map<std::pair<std::string, double>, RubEnd> known;
    const auto at = [&](const Reason& reason, double share) {
      const double value = reason.is_logarithmic
                               ? reason.from * std::pow(reason.until / reason.from, share)
                               : reason.from + (reason.until - reason.from) * share;
      const auto [found, is_new] = known.try_emplace({reason.quantity, value});
      if (is_new) {
        ScenarioSpec spec = rotor;
        spec.numbers[reason.quantity] = value;
        found->second = end_of(spec);
      }
      return found->second;
    };
    for (const Reason& reason : reasons) {
      Trial& trial = all[static_cast<std::size_t>(n)].emplace_back();
      if (rotor.numbers.at("friction") > reason.most_friction) continue;
      const bool is_one_value = reason.judged == Criterion::harmless;
      const RubEnd end = at(reason, is_one_value ? shares[0] : less);
      trial = trial_of(reason.judged, end, is_one_value ? end : at(reason, more));
    }
  });
  std::vector<Trial> sums(reasons.size());
  for (const std::vector<Trial>& of_rotor : all)
    for (std::size_t r = 0; r < sums.size(); ++r) sums[r] += of_rotor[r];
  return sums;
}

}  // namespace rotor
