/// The claims of the paper's text, and the verdict on each by the rules of
/// reference-data/policy.md.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "figures/data/read_csv.hpp"
#include "verification/paper/ensembles.hpp"
#include "verification/paper/rules.hpp"

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

/// The best one first: see policy.md.
enum class Verdict { reproduced, within_rounding, refuted };
inline constexpr std::array all_verdicts = {Verdict::reproduced, Verdict::within_rounding,
                                            Verdict::refuted};

/// "within rounding"; as a key, such as a class of the page's style: "within_rounding".
std::string words_of(Verdict verdict);
std::string key_of(Verdict verdict);

/// A verdict with its margins.
struct Judgement {
  Verdict verdict = Verdict::refuted;
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
  bool medians = false;             ///< of a change that a word bounds, instead of its 5 to 95 %
  bool takes_alternatives = false;  ///< the numbers that have `alternative_to`
};
/// The other rules of policy.md.
const std::vector<Judging>& other_rules();

/// A number of a claim, which may have several.
struct Number {
  std::string claim, id, sentence, figures, place, says, printed, rule, unit;
  std::string alternative_to;  ///< id of the number in whose place it can be read
  Kind kind = Kind::simulated;
  bool conditions = false;  ///< population (b)
  std::vector<Reading> readings;
  std::array<Verdict, sets.size()> expected{};  ///< verdicts that the table states
  std::string reason;
  std::array<std::size_t, sets.size()> decides{};  ///< the reading of its sentence

  bool is_drawn() const { return kind == Kind::arithmetic || kind == Kind::simulated; }
  Allowed allowed(const Judging& judging = {}) const;
};

/// In a set of equations.
Judgement judgement_on(const Number& number, std::size_t set, const Judging& judging = {});
inline Verdict verdict_of(const Number& number, std::size_t set, const Judging& judging = {}) {
  return judgement_on(number, set, judging).verdict;
}

/// Chooses the readings that decide: one for all numbers of a sentence.
void choose_readings(std::vector<Number>& numbers);

/// Only the table, readings without values.
std::vector<Number> read_numbers(const std::filesystem::path& table);

/// The numbers of a claim, by its name or that of one of its numbers. Throws std::runtime_error,
/// with all claims, if there is none.
std::vector<Number> of_claim(const std::vector<Number>& numbers, const std::string& id);

/// The table with values from runs at the inputs as printed and from the stored ensembles.
std::vector<Number> judged_numbers(const std::filesystem::path& folder);
std::vector<Number> judged_numbers(const std::filesystem::path& folder,
                                   const std::filesystem::path& ensembles);
/// The same for reference-data/, computed once.
const std::vector<Number>& judged();

/// The verdict of each claim in a set of equations: the worst one of its numbers.
std::map<std::string, Verdict> verdicts_of_claims(const std::vector<Number>& numbers,
                                                  std::size_t set, const Judging& judging = {});

/// Whether all numbers of a claim follow without a run.
bool is_arithmetic(const std::vector<Number>& numbers, const std::string& claim);

/// The readings to draw over populations.
std::vector<std::string> readings_to_draw(const std::vector<Number>& numbers);

/// Rows of ensembles.csv of draws in a set of equations.
std::string ensembles_rows(const std::vector<Number>& numbers, const char* set,
                           const char* population, const Draws& draws);

/// Six digits; empty for what is not finite or not there.
std::string csv_number(const std::optional<double>& value);

}  // namespace rotor
