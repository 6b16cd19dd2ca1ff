#include "verification/paper/reasons.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "figures/data/csv.hpp"
#include "figures/scenes/account.hpp"
#include "figures/scenes/audience.hpp"
#include "figures/sweep/dealer.hpp"
#include "figures/sweep/sweep.hpp"
#include "model/simulation/start.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/place_of_loss.hpp"

namespace rotor {
namespace {

constexpr std::array judged_names = {"rolls", "touches", "force", "harmless", "minor", "slight"};

Judged parse_judged(const std::string& name) {
  const auto found = std::ranges::find(judged_names, name);
  if (found == judged_names.end()) throw std::runtime_error("judged: no such way: " + name);
  return static_cast<Judged>(found - judged_names.begin());
}

/// What has become of a rotor.
struct End {
  Outcome outcome;
  bool touched;
  double force_kN;  ///< 0 without contact

  explicit End(const Summary& summary)
      : outcome(summary.outcome),
        touched(summary.collisions > 0),
        force_kN(summary.peak_normal_force_N.value_or(0) / 1e3) {}
  bool rolls() const { return outcome == Outcome::rolling; }
};
using Series = std::vector<End>;  ///< along the values of a quantity

double rounded(double value) { return std::stod(fmt::format("{:.4g}", value)); }

class Rotors {
 public:
  explicit Rotors(Equations equations)
      : equations_(equations),
        sweep_(read_sweep(ROTOR_SOURCES "/verification/paper/reasons.toml")) {}

  Statement draw(long n) const {
    Statement statement = SweepPoints(sweep_)(n).statement;
    for (const Draw& draw : sweep_.sample.over) {
      double& value = statement.numbers.at(draw.quantity);
      value = rounded(value);
    }
    return statement;
  }

  Series along(const Reason& reason, long n) const {
    Statement statement = draw(n);
    Series series;
    if (reason.quantity == "location") {
      // Angles that are even wherever one stops: multiples of the golden section of a turn.
      const double turns = std::fmod(static_cast<double>(n + 1) * std::numbers::phi, 1);
      for (const double angle : {std::numbers::pi, 2 * std::numbers::pi * turns})
        series.push_back(lost_at(statement, angle));
      return series;
    }
    for (const double value : reason.values) {
      statement.numbers[reason.quantity] = value;
      series.push_back(run(statement));
    }
    return series;
  }

 private:
  Scenario scenario(const Statement& statement) const {
    Scenario scenario = scenario_of(statement);
    scenario.equations = equations_;
    return scenario;
  }

  End run(const Statement& statement) const {
    const Scenario scenario = this->scenario(statement);
    Observer nobody;
    return End(finish(Departure(scenario), scenario, StopOn::outcome, nobody).summary);
  }

  End lost_at(const Statement& statement, double angle) const {
    const Scenario scenario = this->scenario(statement);
    SummaryObserver summary(scenario);
    StopObserver stop(StopOn::outcome, scenario);
    Audience audience;
    audience.add(summary);
    audience.add(stop);
    const PlaceOfLoss loss(scenario.parameters, angle - std::numbers::pi,
                           statement.numbers.at("lost_mass"));
    Instant at = loss.separate(start_of(scenario), scenario.equations);
    at.motor_on = false;
    follow(scenario, at, scenario.until, audience);
    return End(summary.summary());
  }

  Equations equations_;
  Sweep sweep_;
};

bool changes(const End& a, const End& b, double allowed) {
  return a.outcome != b.outcome || std::abs(b.force_kN - a.force_kN) > allowed * a.force_kN;
}

/// At which steps a rotor fails; empty if it does not count.
std::vector<bool> failing(const Series& series, Judged judged) {
  bool counts = false;
  std::vector<bool> fails;
  const auto note = [&](bool could_fail, bool does) {
    counts = counts || could_fail;
    fails.push_back(could_fail && does);
  };
  if (judged == Judged::harmless)
    for (const End& end : series) note(end.touched, end.rolls());
  else
    for (std::size_t i = 0; i + 1 < series.size(); ++i) {
      const End &a = series[i], &b = series[i + 1];
      switch (judged) {
        case Judged::rolls:
          note(a.rolls(), !b.rolls());
          break;
        case Judged::touches:
          note(a.touched, !b.touched);
          break;
        case Judged::force:
          note(a.rolls() && b.rolls(), b.force_kN < a.force_kN);
          break;
        default:
          note(a.touched || b.touched, changes(a, b, judged == Judged::minor ? 0.1 : 0.05));
      }
    }
  return counts ? fails : std::vector<bool>();
}

double trend(const End& end, Judged judged) {
  switch (judged) {
    case Judged::rolls:
    case Judged::harmless:
      return end.rolls() ? 1 : 0;
    case Judged::touches:
      return end.touched ? 1 : 0;
    default:
      return end.force_kN;
  }
}

/// As options of `rotor run`, but for what is varied.
std::string options_of(const Statement& statement, Equations equations, const std::string& varied) {
  std::string options = fmt::format("--equations {} ", name_of(equations));
  for (const auto& [name, value] : statement.numbers) {
    if (name == varied) continue;
    options += fmt::format("--{} {} ", name, value);
  }
  std::ranges::replace(options, '_', '-');
  return options;
}

std::string example_of(const Reason& reason, Equations equations, const Statement& statement,
                       std::size_t step) {
  std::string option = reason.quantity;
  std::ranges::replace(option, '_', '-');
  const std::string options = options_of(statement, equations, reason.quantity);
  if (reason.quantity == "location") return options;
  if (reason.judged == Judged::harmless)
    return fmt::format("{}--{} {}", options, option, reason.values[step]);
  return fmt::format("{}--{} {}; {}", options, option, reason.values[step],
                     reason.values[step + 1]);
}

}  // namespace

double Trial::share() const {
  return static_cast<double>(fails) / static_cast<double>(std::max(1L, rotors));
}
double Trial::standard_error() const {
  return std::sqrt(share() * (1 - share()) / static_cast<double>(std::max(1L, rotors)));
}

std::vector<Reason> read_reasons(const std::filesystem::path& table) {
  std::vector<Reason> reasons;
  for (const CsvRow& row : read_csv(table)) {
    Reason reason{row["reason"],   row["place"], row["says"],
                  row["quantity"], {},           parse_judged(row["judged"])};
    std::istringstream values(row["values"]);
    for (double value = 0; values >> value;) reason.values.push_back(value);
    reasons.push_back(reason);
  }
  return reasons;
}

std::map<std::pair<std::string, std::string>, std::string> read_shares_that_fail(
    const std::filesystem::path& table) {
  std::map<std::pair<std::string, std::string>, std::string> shares;
  for (const CsvRow& row : read_csv(table))
    shares[{row["reason"], row["equations"]}] =
        row["fails"] == "0"
            ? fmt::format("none of {}", row["rotors"])
            : fmt::format("{:.1f} +- {:.1f} %", 100 * static_cast<double>(row.number("share")),
                          100 * static_cast<double>(row.number("standard_error")));
  return shares;
}

Trials tried(const std::vector<Reason>& reasons, Equations equations, long draws, int threads) {
  const Rotors rotors(equations);
  std::vector<std::vector<Series>> all(static_cast<std::size_t>(draws));
  Dealer dealer(0, draws, [](std::string_view, long) {});
  const Work run_draw = [&](long n) {
    std::map<std::pair<std::string, std::vector<double>>, Series> known;
    for (const Reason& reason : reasons) {
      const auto [series, is_new] = known.try_emplace({reason.quantity, reason.values});
      if (is_new) series->second = rotors.along(reason, n);
      all[static_cast<std::size_t>(n)].push_back(series->second);
    }
    return std::string();
  };
  work(
      dealer, threads, [&] { return run_draw; }, [] {});

  Trials trials;
  for (std::size_t r = 0; r < reasons.size(); ++r) {
    const Reason& reason = reasons[r];
    Trial& trial = trials[reason.id];
    for (long n = 0; n < draws; ++n) {
      const Series& series = all[static_cast<std::size_t>(n)][r];
      trial.first += trend(series.front(), reason.judged) / static_cast<double>(draws);
      trial.last += trend(series.back(), reason.judged) / static_cast<double>(draws);
      const std::vector<bool> fails = failing(series, reason.judged);
      if (fails.empty()) continue;
      ++trial.rotors;
      trial.failing.resize(fails.size());
      for (std::size_t i = 0; i < fails.size(); ++i) trial.failing[i] += fails[i] ? 1 : 0;
      const auto first = std::ranges::find(fails, true);
      if (first == fails.end()) continue;
      if (trial.fails++ == 0)
        trial.example = example_of(reason, equations, rotors.draw(n),
                                   static_cast<std::size_t>(first - fails.begin()));
    }
  }
  return trials;
}

std::string to_csv(const std::vector<Reason>& reasons, const Trials& published,
                   const Trials& consistent) {
  std::string csv =
      "reason,equations,rotors,fails,share,standard_error,by_step,first,last,example\n";
  for (const Reason& reason : reasons)
    for (const auto& [name, trials] :
         {std::pair("published", &published), {"consistent", &consistent}}) {
      const Trial& trial = trials->at(reason.id);
      csv += fmt::format("{},{},{},{},{:.3g},{:.2g},{},{:.3g},{:.3g},{}\n", reason.id, name,
                         trial.rotors, trial.fails, trial.share(), trial.standard_error(),
                         fmt::join(trial.failing, " "), trial.first, trial.last, trial.example);
    }
  return csv;
}

}  // namespace rotor
