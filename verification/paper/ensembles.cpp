#include "verification/paper/ensembles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>

#include "figures/data/csv.hpp"
#include "figures/sweep/dealer.hpp"
#include "figures/sweep/sweep.hpp"

namespace rotor {
namespace {

/// Draws need but the digits that are printed.
constexpr double tolerance_of_draws = 1e-8;

Sweep sweep_of(const std::filesystem::path& printed_inputs, Rounded rounded, long count) {
  Sweep sweep{.title = {}, .text = {}, .base = {}, .axes = {}, .sample = {}};
  sweep.sample.count = count;
  sweep.sample.seed = 1;
  for (const auto& [input, least, greatest] : read_input_ranges(printed_inputs))
    if (rounded == Rounded::everything || input.starts_with("t_"))
      sweep.sample.over.push_back({input, Distribution::uniform, least, greatest});
  return sweep;
}

double value_of(const std::string& reading, PaperRuns& runs) {
  try {
    return read_off(reading, runs).value_or(std::numeric_limits<double>::quiet_NaN());
  } catch (const std::exception&) {  // a rotor that cannot be
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace

std::vector<InputRange> read_input_ranges(const std::filesystem::path& printed_inputs) {
  std::vector<InputRange> ranges;
  for (const CsvRow& row : read_csv(printed_inputs))
    ranges.push_back({row["input"], static_cast<double>(row.number("least")),
                      static_cast<double>(row.number("greatest"))});
  return ranges;
}

Draws evaluate(const std::vector<std::string>& readings, const Points& points, int threads,
               const std::function<void(long)>& told) {
  Draws draws;
  for (const std::string& name : readings)
    draws[name].resize(static_cast<std::size_t>(points.count));
  Dealer dealer(0, points.count, [](std::string_view, long) {});
  std::atomic<long> done = 0;
  const auto make_worker = [&]() -> Work {
    return [&](long n) {
      PaperInputs inputs = points.at(n);
      inputs.statement.numbers["tolerance"] = tolerance_of_draws;
      PaperRuns runs(inputs);
      for (const std::string& name : readings)
        draws.at(name)[static_cast<std::size_t>(n)] = value_of(name, runs);
      ++done;
      return std::string();
    };
  };
  work(dealer, threads, make_worker, [&] { told(done); });
  return draws;
}

Draws draw(const std::vector<std::string>& readings, const std::filesystem::path& printed_inputs,
           Rounded rounded, const Equations& equations, long count, int threads,
           const std::function<void(long)>& told) {
  const Sweep sweep = sweep_of(printed_inputs, rounded, count);
  const SweepPoints points(sweep);
  const auto at = [&](long n) {
    PaperInputs inputs;
    inputs.statement.equations = equations;
    for (const auto& [input, value] : points(n).statement.numbers) inputs.set(input, value);
    return inputs;
  };
  return evaluate(readings, {count, at}, threads, told);
}

Spread spread(std::vector<double> values, const std::function<bool(double)>& holds) {
  Spread result;
  result.draws = static_cast<long>(values.size());
  result.share = static_cast<double>(std::ranges::count_if(values, holds)) /
                 static_cast<double>(values.size());
  std::erase_if(values, [](double value) { return std::isnan(value); });
  std::ranges::sort(values);
  const auto quantile = [&](double share) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  result.median = quantile(0.5);
  result.low = quantile(0.05);
  result.high = quantile(0.95);
  return result;
}

const std::vector<LossOfAccident>& losses_of_accidents() {
  static const std::vector<LossOfAccident> losses = {{"29.1 s", "peak_kN", "rolls"},
                                                     {"19.1 s", "peak_kN_100", "rolls_at_100"},
                                                     {"14.15 s", "peak_kN_75", "rolls_at_75"}};
  return losses;
}

std::vector<std::string> readings_of_accidents() {
  std::vector<std::string> readings;
  for (const LossOfAccident& loss : losses_of_accidents()) {
    readings.push_back(loss.force);
    readings.push_back(loss.rolls);
  }
  return readings;
}

Accidents read_accidents(const std::filesystem::path& table) {
  Accidents accidents;
  for (const CsvRow& row : read_csv(table)) {
    const auto number = [&](const char* column) { return static_cast<double>(row.number(column)); };
    accidents[{row["loss"], row["equations"]}] = {
        {static_cast<long>(number("draws")), number("median_kN"), number("p5_kN"), number("p95_kN"),
         number("share_touching")},
        number("share_rolling")};
  }
  return accidents;
}

Accident accident(const LossOfAccident& loss, const Draws& draws) {
  return {spread(draws.at(loss.force), [](double value) { return !std::isnan(value); }),
          spread(draws.at(loss.rolls), [](double value) { return value == 1; }).share};
}

std::string accidents_csv(const Draws& published, const Draws& consistent) {
  std::string csv = "loss,equations,draws,share_touching,share_rolling,median_kN,p5_kN,p95_kN\n";
  for (const LossOfAccident& loss : losses_of_accidents())
    for (const auto& [equations, draws] :
         {std::pair("published", &published), {"consistent", &consistent}}) {
      const auto [force, rolls] = accident(loss, *draws);
      csv += fmt::format("{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", loss.at, equations,
                         force.draws, force.share, rolls, force.median, force.low, force.high);
    }
  return csv;
}

}  // namespace rotor
