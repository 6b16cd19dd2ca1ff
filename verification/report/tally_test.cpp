/// Whatever counts the verdicts on the claims counts the same.
#include "verification/paper/tally.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "figures/data/read_csv.hpp"
#include "verification/report/page.hpp"
#include "verification/support/pattern.hpp"

namespace rotor {
namespace {

using Numbers = std::vector<int>;

/// The first six whole numbers after each place where the text has these words.
Numbers after(const std::string& text, const std::string& words) {
  Numbers numbers;
  for (const Match& line : matches(text, words + "([^\n]*)"))
    for (const Match& number : matches(line[1], "[0-9]+"))
      if (numbers.size() < 6) numbers.push_back(std::stoi(number[0]));
  return numbers;
}

/// Counted from the table of claims and from its picture's data: claims have the worst verdict of
/// their numbers; reproduced, within rounding, refuted, each with those that no rule turns.
Numbers counted(std::size_t set) {
  const std::vector<std::string> verdicts = {"reproduced", "within rounding", "refuted"};
  std::map<std::string, std::string> worst;
  for (const CsvRow& row : read_csv(ROTOR_REFERENCE_DATA "/claims.csv")) {
    if (!row["instead"].empty()) continue;
    const std::string verdict = row[set == 0 ? "verdict" : "corrected"];
    std::string& of = worst.try_emplace(row["claim"], verdict).first->second;
    if (std::ranges::find(verdicts, verdict) > std::ranges::find(verdicts, of)) of = verdict;
  }
  std::map<std::string, int> claims, unturned;
  for (const auto& of : worst) {
    const std::string &claim = of.first, &verdict = of.second;
    ++claims[verdict];
    const auto is_turned = [&](const Judging& rule) {
      return words_of(verdicts_of_claims(judged(), set, rule).at(claim)) != verdict;
    };
    unturned[verdict] += std::ranges::none_of(other_rules(), is_turned);
  }
  Numbers all;
  for (const std::string& verdict : verdicts)
    all.insert(all.end(), {claims[verdict], unturned[verdict]});
  return all;
}

// README, make verify, make claim, and the page.
TEST(Tally, IsTheSameInAllPlaces) {
  const std::filesystem::path sources = ROTOR_SOURCES;
  const std::string page = render(content_of(sources / "verification/report/claims.mustache.html"),
                                  {}, {{"tally", tally_json(judged())}});
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const Numbers expected = counted(set);
    const char* const words = set == 0 ? "equations as printed: " : "corrected equations: ";
    EXPECT_EQ(after(content_of(sources / "README.md"), set == 0 ? "\n\\| as printed \\| [0-9]+ \\|"
                                                                : "\n\\| corrected \\| [0-9]+ \\|"),
              expected);
    EXPECT_EQ(after(claims_table(judged()), words), expected);
    EXPECT_EQ(after(claims_list(judged(), {}), words), expected);
    EXPECT_EQ(after(page, set == 0 ? "As printed: " : "Corrected: "), expected);
  }
}

// The gallery's marks: of a figure's claims, those whose verdict the picture of claims has.
TEST(Tally, OfFiguresIsThatOfTheirClaims) {
  const std::string gallery = content_of(ROTOR_SOURCES "/figures/paper/README.md");
  std::istringstream data(to_csv(judged()));
  const auto rows = read_csv(data, "claims");
  int figures = 0;
  for (const Match& line : matches(gallery, "`make fig([0-9]+)`. Claims: ([^\n;]*)")) {
    std::map<std::string, std::string> of_figure;
    for (const CsvRow& row : rows) {
      std::istringstream shown(row["figures"]);
      for (int figure = 0; shown >> figure;)
        if (figure == std::stoi(line[1])) of_figure[row["claim"]] = "reproduced";
    }
    std::map<std::string, int> expected, stated;
    for (const CsvRow& row : rows)
      if (const auto of = of_figure.find(row["claim"]);
          of != of_figure.end() && row["equations"] == "published" &&
          (row["verdict"] == "refuted" || of->second == "reproduced"))
        of->second = row["verdict"];
    for (const auto& [claim, verdict] : of_figure) ++expected[verdict];
    for (const Match& count : matches(line[2], "([0-9]+) (reproduced|within rounding|refuted)"))
      stated[count[2]] = std::stoi(count[1]);
    EXPECT_EQ(stated, expected) << line[1];
    ++figures;
  }
  EXPECT_EQ(figures, 16);
}

}  // namespace
}  // namespace rotor
