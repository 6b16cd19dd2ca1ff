/// Statistics of a map's results, by the names of their columns. `map-statistics shares MAP.toml
/// MAP.csv` writes the share of draws that roll at each point of the map's axes;
/// `map-statistics others A.csv B.csv` prints the share of points, %, whose outcome differs.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <boost/math/distributions/binomial.hpp>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "figures/data/read_csv.hpp"
#include "figures/data/text.hpp"
#include "figures/sweep/sweep_row.hpp"

namespace rotor {
namespace {

/// Half of the 95 % interval of a share by Clopper and Pearson, Biometrika 26 (1934), which has a
/// width at shares of 0 and 1, too.
double half_interval(long draws, long rolling) {
  using Binomial = boost::math::binomial_distribution<>;
  const auto n = static_cast<double>(draws), k = static_cast<double>(rolling);
  return (Binomial::find_upper_bound_on_p(n, k, 0.025) -
          Binomial::find_lower_bound_on_p(n, k, 0.025)) /
         2;
}

void print_shares(const char* toml, const char* csv) {
  const Sweep map = read_sweep(toml);
  std::vector<std::string> axes;
  for (const Axis& axis : map.axes) axes.push_back(axis.quantity);
  fmt::print("# {}\n{},draws,rolling_share,half_interval\n", map.title, fmt::join(axes, ","));
  long draws = 0, rolling = 0;
  read_csv(csv, [&](const CsvRow& row) {
    ++draws;
    if (row["outcome"] == name_of(Outcome::rolling)) ++rolling;
    if (draws < map.sample.count) return;
    for (const std::string& axis : axes) fmt::print("{},", row[column_of(axis)]);
    const double share = static_cast<double>(rolling) / static_cast<double>(draws);
    fmt::print("{},{:.6g},{:.6g}\n", draws, share, half_interval(draws, rolling));
    draws = rolling = 0;
  });
  if (draws > 0) throw std::runtime_error(fmt::format("{}: its last point lacks draws", csv));
}

void print_share_of_others(const char* a, const char* b) {
  const std::vector<CsvRow> of_a = read_csv(a), of_b = read_csv(b);
  if (of_a.empty() || of_a.size() != of_b.size())
    throw std::runtime_error(fmt::format("{} and {} must have the same points", a, b));
  int others = 0;
  for (std::size_t n = 0; n < of_a.size(); ++n)
    if (of_a[n]["outcome"] != of_b[n]["outcome"]) ++others;
  fmt::print("{:.2g} % of {} points\n", 100. * others / static_cast<double>(of_a.size()),
             of_a.size());
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  try {
    const std::string_view statistic = argc == 4 ? argv[1] : "";
    if (statistic == "shares")
      rotor::print_shares(argv[2], argv[3]);
    else if (statistic == "others")
      rotor::print_share_of_others(argv[2], argv[3]);
    else
      throw std::runtime_error("needs shares MAP.toml MAP.csv, or others A.csv B.csv");
    if (std::fflush(stdout) != 0) throw std::runtime_error("standard output cannot be written");
  } catch (const std::exception& error) {
    rotor::print_message(fmt::format("map-statistics: {}", error.what()));
    return 1;
  }
}
