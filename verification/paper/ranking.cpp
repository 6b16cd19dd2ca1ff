#include "verification/paper/ranking.hpp"

#include <algorithm>
#include <limits>

#include "figures/data/csv.hpp"

namespace rotor {

Draws one_at_a_time(const std::vector<std::string>& readings, const std::vector<InputRange>& ranges,
                    int threads) {
  const auto at = [&](long n) {
    const InputRange& range = ranges[static_cast<std::size_t>(n / 2)];
    PaperInputs inputs;
    inputs.set(range.input, n % 2 == 0 ? range.least : range.greatest);
    return inputs;
  };
  return evaluate(readings, 2 * static_cast<long>(ranges.size()), at, threads);
}

std::vector<Influence> read_ranking(const std::filesystem::path& ranking) {
  std::vector<Influence> all;
  for (const CsvRow& row : read_csv(ranking)) {
    const auto number = [&](const std::string& heading) {
      return row[heading].empty() ? std::numeric_limits<double>::quiet_NaN()
                                  : static_cast<double>(row.number(heading));
    };
    const auto estimate = [&](const std::string& of) {
      return Estimate{number(of), number(of + "_low"), number(of + "_high")};
    };
    all.push_back({row["reading"], row["input"], number("at_least"), number("at_greatest"),
                   estimate("first"), estimate("total")});
  }
  return all;
}

std::vector<Influence> ranked(const std::vector<Influence>& all, const std::string& reading) {
  std::vector<Influence> its;
  for (const Influence& influence : all)
    if (influence.reading == reading) its.push_back(influence);
  std::ranges::stable_sort(its, std::greater(), [](const Influence& i) { return i.total.value; });
  return its;
}

}  // namespace rotor
