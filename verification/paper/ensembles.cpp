#include "verification/paper/ensembles.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "figures/data/read_csv.hpp"
#include "figures/sweep/compute_in_order.hpp"
#include "verification/paper/readings.hpp"

namespace rotor {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double value_of(const std::string& reading, PaperRuns& runs) {
  try {
    return read_off(reading, runs).value_or(nan);
  } catch (const std::exception&) {  // an impossible rotor
    return nan;
  }
}

}  // namespace

void in_parallel(long count, int threads, const std::function<void(long)>& work_on,
                 const std::function<void(long)>& report) {
  std::atomic<long> done = 0;
  const Work one = [&](long n) {
    work_on(n);
    ++done;
    return std::string();
  };
  compute_in_order(
      0, count, threads, [&] { return one; }, [](const std::string&) {}, [&] { report(done); });
}

Draws evaluate(const std::vector<std::string>& readings, long count,
               const std::function<PaperInputs(long)>& at, int threads,
               const std::function<void(long)>& report) {
  Draws draws;
  for (const std::string& name : readings) draws[name].resize(static_cast<std::size_t>(count));
  const auto evaluate_at = [&](long n) {
    PaperRuns runs(at(n));
    for (const std::string& name : readings)
      draws.at(name)[static_cast<std::size_t>(n)] = value_of(name, runs);
  };
  in_parallel(count, threads, evaluate_at, report);
  return draws;
}

Spread spread(std::vector<double> values) {
  Spread result;
  result.draws = static_cast<long>(values.size());
  std::erase_if(values, [](double value) { return std::isnan(value); });
  result.valued = static_cast<double>(values.size()) / static_cast<double>(result.draws);
  std::ranges::sort(values);
  const auto quantile = [&](double share) {
    if (values.empty()) return nan;
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  result.median = quantile(0.5);
  result.low = quantile(0.05);
  result.high = quantile(0.95);
  return result;
}

Ensembles read_ensembles(const std::filesystem::path& table) {
  Ensembles all;
  for (const CsvRow& row : read_csv(table)) {
    const auto number = [&](const char* column) {
      return row[column].empty() ? nan : static_cast<double>(row.number(column));
    };
    all[{row["equations"], row["population"], row["number"], row["reading"]}] = {
        {static_cast<long>(number("draws")), number("valued"), number("median"), number("p5"),
         number("p95")},
        number("holds")};
  }
  return all;
}

}  // namespace rotor
