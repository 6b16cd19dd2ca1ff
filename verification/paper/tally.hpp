/// How many claims have which verdict, and the order in which they are shown: whatever counts or
/// lists the claims does it by these functions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "verification/paper/claims.hpp"

namespace rotor {

/// A claim's verdict by its own rule, and the other rules of policy.md that give it another one.
struct JudgedClaim {
  std::string claim;
  Verdict verdict = Verdict::refuted;
  std::vector<std::string> turned_by;
};

/// The claims in a set of equations, in the order of the table.
std::vector<JudgedClaim> judged_claims(const std::vector<Number>& numbers, std::size_t set);

/// Those of which a number is shown in a figure.
std::vector<JudgedClaim> shown_in(int figure, const std::vector<JudgedClaim>& claims,
                                  const std::vector<Number>& numbers);

/// How many claims have a verdict by their own rule, and how many of these no other rule turns.
struct Count {
  Verdict verdict = Verdict::reproduced;
  long claims = 0, unturned = 0;
};

/// Of each verdict, the best one first.
std::vector<Count> tally(const std::vector<JudgedClaim>& claims);

/// "64 reproduced (48 turned by no other rule), 15 within rounding (10), 12 refuted (8)"
std::string in_words(const std::vector<Count>& tally);

/// For each set of equations a line with its tally.
std::string tally_lines(const std::vector<Number>& numbers);

/// How many of the claims each other rule turns, by its words.
std::map<std::string, long> turned_by_rule(const std::vector<JudgedClaim>& claims);

/// "refuted: every reading must hold": the verdicts on a number by the rules that turn it.
std::vector<std::string> other_verdicts(const Number& number, std::size_t set,
                                        const std::vector<Number>& numbers);

/// Numbers that stand together in the paper: in a section, or in Sec. 3 beside a figure.
struct Passage {
  std::string heading;
  std::vector<Number> numbers;
};

/// All numbers but those that are read in the place of another one, in the paper's order.
std::vector<Passage> in_the_papers_order(const std::vector<Number>& numbers);

/// A row for each number of the passages, set of equations and reading.
std::string to_csv(const std::vector<Number>& numbers);

/// The tally, the claims that are refuted, and all numbers with their verdicts.
std::string claims_table(const std::vector<Number>& numbers);

/// The tally; the claims: those about runs, then arithmetic; and the trends of reasons.csv, which
/// `make reasons` tries. Each group has a heading with its count.
std::string claims_list(const std::vector<Number>& numbers, const std::vector<CsvRow>& trends);

}  // namespace rotor
