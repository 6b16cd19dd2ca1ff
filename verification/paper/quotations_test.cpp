/// What the figures' scripts quote from the paper stands in claims.csv.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "figures/data/csv.hpp"

namespace rotor {
namespace {

struct Quoted {
  double number;
  std::string unit;  ///< "" where it stands in front of a dash
};

/// All numbers of a text with what follows them.
std::vector<Quoted> numbers_in(const std::string& text) {
  static const std::regex number("([0-9]+(?:\\.[0-9]+)?(?:e-?[0-9]+)?)(?: (kN|Hz|s|J|mm|m/s)\\b)?");
  static const std::regex format("%[.0-9]*[a-z]");
  const std::string plain = std::regex_replace(text, format, "");
  std::vector<Quoted> all;
  for (std::sregex_iterator at(plain.begin(), plain.end(), number), end; at != end; ++at)
    all.push_back({std::stod((*at)[1]), (*at)[2]});
  return all;
}

bool is_published(const Quoted& quoted) {
  for (const CsvRow& row : read_csv(ROTOR_REFERENCE_DATA "/claims.csv")) {
    if (!quoted.unit.empty() && row["unit"] != quoted.unit) continue;
    for (const Quoted& printed : numbers_in(row["printed"]))
      if (std::abs(printed.number - quoted.number) < 1e-12) return true;
  }
  return false;
}

/// What a script says that the paper says: behind "paper", as the last argument of beside(), and as
/// a variable paper_Hz.
std::vector<Quoted> quotations(const std::string& script) {
  static const std::regex behind_paper("paper:? ([^\";]*)");
  static const std::regex beside(",[ \\\\\n]*\"([^\"]*)\"\\)[ \\\\\n]*at graph");
  static const std::regex variable("paper_([A-Za-z]+) = ([0-9.]+)");
  std::vector<Quoted> all;
  for (const std::regex* const form : {&behind_paper, &beside})
    for (std::sregex_iterator at(script.begin(), script.end(), *form), end; at != end; ++at)
      for (const Quoted& quoted : numbers_in((*at)[1])) all.push_back(quoted);
  for (std::sregex_iterator at(script.begin(), script.end(), variable), end; at != end; ++at)
    all.push_back({std::stod((*at)[2]), (*at)[1]});
  return all;
}

TEST(Quotations, OfTheFiguresStandAmongThePublishedValues) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(ROTOR_SCENES)) {
    if (entry.path().extension() != ".gp") continue;
    std::ifstream file(entry.path());
    const std::string script{std::istreambuf_iterator<char>(file), {}};
    std::set<double> quoted_numbers;
    for (const Quoted& quoted : quotations(script)) {
      EXPECT_TRUE(is_published(quoted))
          << entry.path().filename() << " quotes " << quoted.number << ' ' << quoted.unit;
      quoted_numbers.insert(quoted.number);
      ++count;
    }
    // The dashed lines stand at these numbers, or at what is left of one after another.
    static const std::regex line(
        "set arrow[^\n]*,first ([-0-9.() ]+) to [^\n]*linestyle published");
    for (std::sregex_iterator at(script.begin(), script.end(), line), end; at != end; ++at)
      for (const Quoted& drawn : numbers_in((*at)[1]))
        EXPECT_TRUE(quoted_numbers.contains(drawn.number))
            << entry.path().filename() << " draws a line at " << drawn.number;
  }
  EXPECT_GE(count, 20U);
}

}  // namespace
}  // namespace rotor
