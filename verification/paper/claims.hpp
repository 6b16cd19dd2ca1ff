/// The claims of the paper's text, and the verdict on each by the rules of
/// reference-data/policy.md.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verification/paper/ensembles.hpp"
#include "verification/paper/rules.hpp"
#include "verification/support/read_csv.hpp"

namespace rotor {

/// One reading of a number, and its value in each set of equations.
struct Reading {
  struct InSet {
    std::optional<double> converged;  ///< at the inputs as printed
    std::optional<double> by_rk4;     ///< by the paper's method, for the equations as printed
    Stored a, b;                      ///< over the populations
  };
  std::string name;
  std::array<InSet, sets.size()> in{};
};

/// Arithmetic on printed numbers; what the paper's method does; what its equations give; the
/// largest result over all values of a continuous quantity.
enum class Kind { arithmetic, method, simulated, extreme };

/// A verdict with its margins: see policy.md.
struct Verdict {
  std::string verdict;  ///< reproduced, within rounding or refuted
  double off_a = 0, off_b = 0;
};

/// How numbers are judged: by default as policy.md says, otherwise by another sensible rule.
struct Judging {
  enum class By { sentence, first, second, every };  ///< which readings decide
  const char* says = "";
  double word_width_factor = 1;
  double limits = 1;  ///< multiplies all widths
  By by = By::sentence;
  bool own_method = true, zeros_count = false;
  bool medians = false;  ///< of a change that a word bounds, instead of its 5 to 95 %
  bool instead = false;  ///< with the numbers that have `instead`
};
/// The other rules of policy.md.
const std::vector<Judging>& other_rules();

/// A number of a claim, which may have several.
struct Number {
  std::string claim, id, sentence, figures, place, says, printed, rule, unit;
  std::string instead;  ///< id of the number in whose place it can be read
  Kind kind = Kind::simulated;
  bool conditions = false;  ///< population (b)
  std::vector<Reading> readings;
  std::array<std::string, sets.size()> expected{};  ///< verdicts that the table states
  std::string reason;
  std::array<std::size_t, sets.size()> decides{};  ///< the reading of its sentence

  bool is_drawn() const { return kind == Kind::arithmetic || kind == Kind::simulated; }
  Allowed allowed(const Judging& judging = {}) const;
};

/// The verdict in a set of equations.
Verdict verdict_of(const Number& number, std::size_t set, const Judging& judging = {});

/// Chooses the readings that decide: one for all numbers of a sentence.
void choose_readings(std::vector<Number>& numbers);

/// Only the table, readings without values.
std::vector<Number> read_numbers(const std::filesystem::path& table);

/// The numbers of a claim. Throws std::runtime_error, with all claims, if there is no such claim.
std::vector<Number> of_claim(const std::vector<Number>& numbers, const std::string& claim);

/// The table with values from runs at the inputs as printed and from the stored ensembles.
std::vector<Number> judged_numbers(const std::filesystem::path& folder);
std::vector<Number> judged_numbers(const std::filesystem::path& folder,
                                   const std::filesystem::path& ensembles);
/// The same for reference-data/, computed once.
const std::vector<Number>& judged();

/// The verdict of each claim in a set of equations: the worst one of its numbers.
std::map<std::string, std::string> verdicts_of_claims(const std::vector<Number>& numbers,
                                                      std::size_t set, const Judging& judging = {});

/// Whether all numbers of a claim follow without a run.
bool is_arithmetic(const std::vector<Number>& numbers, const std::string& claim);

/// The verdict that each claim has by every rule; "depends" for those that another rule turns.
std::map<std::string, std::string> settled_verdicts(const std::vector<Number>& numbers,
                                                    std::size_t set);

/// The verdict on a number, and those that other rules of policy.md would give: "refuted: every
/// reading must hold".
struct Turned {
  Number number;
  std::size_t set;
  std::string verdict;
  std::vector<std::string> others;
};
/// All numbers with a verdict that another rule would turn.
std::vector<Turned> turned_by_other_rules(const std::vector<Number>& numbers);

/// The readings to draw over populations.
std::vector<std::string> readings_to_draw(const std::vector<Number>& numbers);

/// Rows of ensembles.csv of draws in a set of equations.
std::string ensembles_rows(const std::vector<Number>& numbers, const char* set,
                           const char* population, const Draws& draws);

std::string to_csv(const std::vector<Number>& numbers);

/// The claims: those about runs, then arithmetic; and the trends of reasons.csv, which `make
/// reasons` tries. Each group has a heading with its count.
std::string claims_list(const std::vector<Number>& numbers, const std::vector<CsvRow>& trends);

/// All numbers with their verdicts.
std::string claims_table(const std::vector<Number>& numbers);

}  // namespace rotor
