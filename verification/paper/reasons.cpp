#include "verification/paper/reasons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "figures/data/csv.hpp"
#include "figures/results/run_result.hpp"
#include "figures/sweep/sweep.hpp"
#include "verification/paper/ensembles.hpp"

namespace rotor {
namespace {

constexpr std::array judged_names = {"rolls", "touches", "force", "harmless", "decides"};

Criterion parse_judged(const std::string& name) {
  const auto found = std::ranges::find(judged_names, name);
  if (found == judged_names.end()) throw std::runtime_error("judged: no such way: " + name);
  return static_cast<Criterion>(found - judged_names.begin());
}

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

/// The outcome of a run.
struct End {
  bool touches, rolls;
  Forces forces;
};

End end_of(const ScenarioSpec& spec) {
  const Scenario scenario = scenario_of(spec);
  RollingForce in_rolling(scenario);
  const Summary summary =
      finish(RunUpCheckpoint(scenario), scenario, StopOn::outcome, in_rolling).summary;
  return {summary.touch_downs > 0,
          summary.outcome == Outcome::rolling,
          {summary.peak_force_to_rolling_N.value_or(0), in_rolling.largest}};
}

Spacing parse_spacing(const std::string& name) {
  if (name.empty()) return Spacing::linear;
  if (name == "log") return Spacing::log;
  if (name == "ends") return Spacing::ends;
  throw std::runtime_error("spacing: no such way: " + name);
}

double rounded(double value) { return std::stod(fmt::format("{:.4g}", value)); }

/// The random rotors, each with a pair of shares of a range, the smaller one first.
class Rotors {
 public:
  explicit Rotors(const Equations& equations)
      : sweep_(read_sweep(ROTOR_SOURCES "/verification/paper/reasons.toml")) {
    sweep_.base.equations = equations;
    for (const char* share : {"share", "other_share"})
      sweep_.sample.over.push_back({share, Distribution::uniform, 0, 1});
  }

  struct Rotor {
    ScenarioSpec spec;
    double less, more;
  };
  Rotor draw(long n) const {
    Rotor rotor{SweepPoints(sweep_)(n).spec, 0, 0};
    auto& numbers = rotor.spec.numbers;
    for (auto& [quantity, value] : numbers)
      if (!quantity.ends_with("share")) value = rounded(value);
    rotor.less = numbers.extract("share").mapped();
    rotor.more = numbers.extract("other_share").mapped();
    if (rotor.less > rotor.more) std::swap(rotor.less, rotor.more);
    return rotor;
  }

 private:
  Sweep sweep_;
};

double value_at(const Reason& reason, double share) {
  return rounded(reason.spacing == Spacing::log
                     ? reason.from * std::pow(reason.until / reason.from, share)
                     : reason.from + (reason.until - reason.from) * share);
}

/// The values at which a rotor is tried.
std::pair<double, double> values(const Reason& reason, const Rotors::Rotor& rotor) {
  if (reason.spacing == Spacing::ends) return {reason.from, reason.until};
  const double more = reason.judged == Criterion::harmless ? Parameters{}.motor_off_Hz
                                                           : value_at(reason, rotor.more);
  return {value_at(reason, rotor.less), more};
}

/// Notes whether a statement applies and holds, given the outcomes at the less and the more risky
/// value.
void note(Trial& trial, Criterion judged, const End& a, const End& b,
          const std::function<std::string()>& example) {
  bool applies = true, holds = true;
  double size = b.forces.largest / a.forces.largest;
  switch (judged) {
    case Criterion::rolls:
      applies = a.rolls, holds = b.rolls;
      break;
    case Criterion::touches:
      applies = a.touches, holds = b.touches;
      break;
    case Criterion::force:
      applies = a.rolls && b.rolls, holds = b.forces.in_rolling >= a.forces.in_rolling;
      size = b.forces.in_rolling / a.forces.in_rolling;
      break;
    case Criterion::harmless:
      applies = a.touches, holds = !a.rolls;
      size = a.forces.largest / b.forces.largest;
      break;
    default:
      holds = a.rolls == b.rolls;
  }
  ++trial.pairs;
  trial.apply += applies;
  if (!applies || holds) return;
  ++trial.violate;
  if (judged != Criterion::decides) trial.sizes.push_back(size);
  if (trial.example.empty()) trial.example = example();
}

/// As options of `rotor run`; the varied quantity has both values.
std::string example_of(const Reason& reason, ScenarioSpec spec, double less, double more) {
  spec.numbers.erase(reason.quantity);
  std::string options = fmt::format("--equations {} ", name_of(*spec.equations));
  for (const auto& [name, value] : spec.numbers)
    options += fmt::format("{} {} ", option_of(name), value);
  return fmt::format("{}{} {}; {}", options, option_of(reason.quantity), less, more);
}

}  // namespace

Forces forces_of(const ScenarioSpec& spec) { return end_of(spec).forces; }

double Trial::share() const {
  return static_cast<double>(violate) / static_cast<double>(std::max(1L, apply));
}
double Trial::standard_error() const {
  return std::sqrt(share() * (1 - share()) / static_cast<double>(std::max(1L, apply)));
}
std::optional<double> Trial::median_size() const {
  if (sizes.empty()) return std::nullopt;
  std::vector<double> sorted = sizes;
  const auto middle = sorted.begin() + static_cast<long>(sorted.size() / 2);
  std::ranges::nth_element(sorted, middle);
  return *middle;
}

std::vector<Reason> read_reasons(const std::filesystem::path& table) {
  std::vector<Reason> reasons;
  for (const CsvRow& row : read_csv(table))
    reasons.push_back({row["reason"], row["place"], row["says"], row["quantity"],
                       static_cast<double>(row.number("from")),
                       static_cast<double>(row.number("until")), parse_spacing(row["spacing"]),
                       row["most_friction"].empty()
                           ? std::nullopt
                           : std::optional(static_cast<double>(row.number("most_friction"))),
                       parse_judged(row["judged"]), row["named"]});
  return reasons;
}

Trials tried(const std::vector<Reason>& reasons, Equations equations, long draws, int threads) {
  const Rotors rotors(equations);
  std::vector<std::vector<std::optional<std::pair<End, End>>>> all(static_cast<std::size_t>(draws));
  in_parallel(draws, threads, [&](long n) {
    const Rotors::Rotor rotor = rotors.draw(n);
    std::map<std::pair<std::string, double>, End> known;
    const auto at = [&](const std::string& quantity, double value) {
      const auto found = known.find({quantity, value});
      if (found != known.end()) return found->second;
      ScenarioSpec spec = rotor.spec;
      spec.numbers[quantity] = value;
      return known.emplace(std::pair(quantity, value), end_of(spec)).first->second;
    };
    for (const Reason& reason : reasons) {
      auto& ends = all[static_cast<std::size_t>(n)].emplace_back();
      if (rotor.spec.numbers.at("friction") > reason.most_friction.value_or(1e9)) continue;
      const auto [less, more] = values(reason, rotor);
      ends.emplace(at(reason.quantity, less), at(reason.quantity, more));
    }
  });
  Trials trials;
  for (std::size_t r = 0; r < reasons.size(); ++r)
    for (long n = 0; n < draws; ++n)
      if (const auto& ends = all[static_cast<std::size_t>(n)][r])
        note(trials[reasons[r].id], reasons[r].judged, ends->first, ends->second, [&] {
          const Rotors::Rotor rotor = rotors.draw(n);
          const auto [less, more] = values(reasons[r], rotor);
          return example_of(reasons[r], rotor.spec, less, more);
        });
  return trials;
}

std::string Reason::rule() const {
  if (named == "first") return "ranking";
  return place == "not said" || judged == Criterion::decides ? "" : "trend";
}

std::string verdict_on(const Reason& reason, const std::vector<Reason>& all, const Trials& trials) {
  const Trial& its = trials.at(reason.id);
  const auto in_words = [](std::string verdict, double distance, double error) {
    return std::abs(distance) < 2 * error ? verdict + " (narrow)" : verdict;
  };
  if (reason.rule() == "ranking") {
    const Trial* most = nullptr;  // of those named second
    for (const Reason& other : all)
      if (const Trial& another = trials.at(other.id);
          other.named == "second" && (!most || another.share() > most->share()))
        most = &another;
    const double ahead = its.share() - most->share();
    return in_words(ahead > 0 ? "holds" : "refuted", ahead,
                    std::hypot(its.standard_error(), most->standard_error()));
  }
  if (reason.rule().empty()) return "";
  constexpr double trend = 0.95, major = 0.5;
  const double holds = 1 - its.share();
  return in_words(holds >= trend  ? "holds"
                  : holds > major ? "mostly holds"
                                  : "refuted",
                  std::min(std::abs(holds - trend), std::abs(holds - major)), its.standard_error());
}

std::string to_csv(const std::vector<Reason>& reasons, const Trials& published,
                   const Trials& consistent) {
  std::string csv =
      "reason,equations,verdict,pairs,apply,violate,share,standard_error,size,example\n";
  for (const Reason& reason : reasons)
    for (const auto& [name, trials] :
         {std::pair("published", &published), {"consistent", &consistent}}) {
      const Trial& trial = trials->at(reason.id);
      const auto size = trial.median_size();
      csv += fmt::format("{},{},{},{},{},{},{:.3g},{:.2g},{},{}\n", reason.id, name,
                         verdict_on(reason, reasons, *trials), trial.pairs, trial.apply,
                         trial.violate, trial.share(), trial.standard_error(),
                         size ? fmt::format("{:.3g}", *size) : "", trial.example);
    }
  return csv;
}

std::map<std::pair<std::string, std::string>, std::string> read_trials_in_words(
    const std::filesystem::path& folder) {
  std::map<std::string, Criterion> judged;
  for (const Reason& reason : read_reasons(folder / "reasons.csv"))
    judged[reason.id] = reason.judged;
  std::map<std::pair<std::string, std::string>, std::string> words;
  for (const CsvRow& row : read_csv(folder / "reasons-tried.csv")) {
    const auto number = [&](const char* column) { return static_cast<double>(row.number(column)); };
    const bool decides = judged.at(row["reason"]) == Criterion::decides;
    const double percent = 100 * (decides ? number("share") : 1 - number("share"));
    const std::string verdict = row["verdict"].empty() ? "" : row["verdict"] + ": ";
    words[{row["reason"], row["equations"]}] =
        verdict +
        (row["violate"] == "0" && !decides
             ? fmt::format("in all of {}", row["apply"])
             : fmt::format("{}{:.1f} +- {:.1f} %", decides ? "decides in " : "", percent,
                           100 * number("standard_error")) +
                   (row["size"].empty() ? "" : fmt::format(", else x {:.2f}", number("size"))));
  }
  return words;
}

}  // namespace rotor
