/// What reference-data/verdicts.md says, command by command.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "figures/data/csv.hpp"
#include "verification/paper/judged.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/markdown_table.hpp"

namespace rotor {
namespace {

std::string page() {
  std::ifstream file(ROTOR_REFERENCE_DATA "/verdicts.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<Cells> table(const std::string& heading) { return markdown_table(page(), heading); }

/// "-a.b - c" or "a / b" of keys of a summary.
double value_of(const std::string& expression, const nlohmann::json& summary) {
  std::istringstream words(expression);
  double value = 0;
  char operation = '+';
  for (std::string key; words >> key;) {
    if (key == "-" || key == "/") {
      operation = key[0];
      continue;
    }
    const bool negative = key[0] == '-';
    std::string path = '/' + key.substr(negative ? 1 : 0);
    std::ranges::replace(path, '.', '/');
    const double one =
        (negative ? -1 : 1) * summary.at(nlohmann::json::json_pointer(path)).get<double>();
    value = operation == '/' ? value / one : operation == '-' ? value - one : value + one;
  }
  return value;
}

/// A value with the digits and in the unit of another one as it is written.
std::string as_written(double value, const std::string& written) {
  static const std::map<std::string, double> units = {{"kN", 1e-3}, {"ms", 1e3}, {"%", 100}};
  std::string number, unit;
  std::istringstream(written) >> number >> unit;
  const std::size_t point = number.find('.');
  const std::size_t decimals = point == std::string::npos ? 0 : number.size() - point - 1;
  return fmt::format("{:.{}f}{}", value * (unit.empty() ? 1 : units.at(unit)), decimals,
                     unit.empty() ? "" : ' ' + unit);
}

class Verdicts : public CommandLine {
 protected:
  double shortest_collision(const std::string& options) const {
    EXPECT_EQ(rotor("run --events events.csv " + options).status, 0);
    double shortest = std::numeric_limits<double>::infinity(), touch_down = 0;
    for (const CsvRow& row : read_csv(folder_ / "events.csv")) {
      const auto time_s = static_cast<double>(row.number("time_s"));
      if (row["event"] == "touch_down") touch_down = time_s;
      if (row["event"] == "release" && touch_down > 0)
        shortest = std::min(shortest, time_s - touch_down);
    }
    return shortest;
  }
};

TEST_F(Verdicts, OfEachItemAreShownByItsCommands) {
  std::set<std::string> shown;
  for (const Cells& row : table("| | `build/rotor run` |")) {
    ASSERT_EQ(row.size(), 4U);
    shown.insert(row[0]);
    const double value =
        row[2] == "shortest collision"
            ? shortest_collision(row[1])
            : value_of(row[2], nlohmann::json::parse(
                                   rotor("run --json " + row[1] + " 2>/dev/null").output));
    EXPECT_EQ(as_written(value, row[3]), row[3]) << row[0] << ": " << row[1];
  }
  EXPECT_EQ(shown, (std::set<std::string>{"1", "2", "4", "5", "6", "7", "8", "9"}));
  EXPECT_EQ(table("| | said before |").size(), 11U);
}

TEST_F(Verdicts, AboutRollingAtLowFrictionAreShares) {
  const std::string text = page(), open = "```toml\n";
  const std::size_t begin = text.find(open) + open.size();
  write("rolls.toml", text.substr(begin, text.find("```", begin) - begin));
  ASSERT_EQ(rotor("sweep rolls.toml --out rolls.csv").status, 0);
  std::map<std::string, int> rolls;
  for (const CsvRow& row : read_csv(folder_ / "rolls.csv"))
    rolls[row["contact_damping"]] += row["outcome"] == "rolling";
  ASSERT_EQ(rolls.size(), 2U);
  const std::string sentence =
      fmt::format("rolling in {} of the 400 runs with 9e3 N s/m, and in {} of those with 1e4",
                  rolls.at("9000"), rolls.at("10000"));
  EXPECT_NE(text.find(sentence), std::string::npos) << sentence;
}

/// What a reason says of draws, in percent; "some" is a tenth at most.
void expect_share(const std::string& reason, double holds_percent) {
  static const std::regex share("(fails|holds) in (some )?([0-9]+) % of the draws");
  std::smatch said;
  if (!std::regex_search(reason, said, share)) return;
  EXPECT_NEAR(std::stod(said[3]), said[1] == "fails" ? 100 - holds_percent : holds_percent,
              said[2].matched ? 0.1 * holds_percent : 0.5)
      << reason;
}

TEST_F(Verdicts, ThatHaveChangedAreThoseOfToday) {
  std::map<std::string, std::string> today;
  std::map<std::string, double> holds_percent;
  for (const Number& number : judged()) {
    today[number.id] = number.verdict;
    holds_percent[number.id] = 100 * number.readings.front().everything.share;
  }
  const auto rows = table("| number | before | now | why |");
  EXPECT_GT(rows.size(), 20U);
  for (const Cells& row : rows) {
    ASSERT_TRUE(today.contains(row[0])) << row[0];
    EXPECT_EQ(today.at(row[0]), row[2]) << row[0];
    EXPECT_NE(row[1], row[2]) << row[0];
    expect_share(row[3], holds_percent.at(row[0]));
  }
}

TEST_F(Verdicts, AndTheReadmeExtrapolateNothing) {
  std::ifstream file(ROTOR_SOURCES "/README.md");
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(readme.find("xtrapolat"), std::string::npos);
  EXPECT_EQ(readme.find("58,000"), std::string::npos);
}

}  // namespace
}  // namespace rotor
