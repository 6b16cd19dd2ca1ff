#include <fmt/format.h>

#include <optional>
#include <utility>

#include "figures/input/words.hpp"
#include "figures/results/json.hpp"

namespace rotor {
namespace {

/// The same member of each entry of a table, and perhaps one more, as a list for JSON and gnuplot.
template <class Entries, class Member>
Json each(const Entries& entries, Member member, std::optional<std::string_view> more = {}) {
  Json all;
  for (const auto& entry : entries) all.push_back(entry.*member);
  if (more) all.push_back(*more);
  return all;
}

}  // namespace

std::string palette_of_gnuplot() {
  using Of = OutcomeInWords;
  using In = EquationsInWords;
  std::string text = "# Written by `make approve` from figures/input/words.hpp.\n", colours;
  const auto add = [&](const char* name, const Json& list) {
    text += fmt::format("array {}[{}] = {}\n", name, list.size(), list.dump());
  };
  const Json tints = each(outcomes, &Of::light, no_result_light);
  add("outcome_name", each(outcomes, &Of::name, ""));
  add("outcome_tint", tints);
  Json words;
  for (const Of& of : outcomes) words.push_back(name_in_words(of.name));
  words.push_back(no_result);
  add("outcome_words", words);
  for (std::size_t n = 0; n < tints.size(); ++n)
    colours += fmt::format("{}{} '{}'", n > 0 ? ", " : "", n, tints[n].get<std::string>());
  text += fmt::format(
      "outcome_palette = \"set palette maxcolors {} defined ({}); set cbrange [-0.5:{}.5]\"\n",
      tints.size(), colours, tints.size() - 1);
  for (const auto& [function, of] :
       {std::pair("words_of", &In::words), {"short_of", &In::short_words}, {"tint_of", &In::light}})
    text += fmt::format("{}(set) = set eq \"{}\" ? \"{}\" : \"{}\"\n", function,
                        sets_in_words[0].name, sets_in_words[0].*of, sets_in_words[1].*of);
  Json styles;
  for (const LineInWords& of : lines_in_words)
    styles.push_back(fmt::format("linewidth {} dashtype {}", of.width,
                                 of.dashes.empty() ? "solid" : fmt::format("({})", of.dashes)));
  add("line_words", each(lines_in_words, &LineInWords::words));
  add("line_style", styles);
  for (const In& of : others_in_words) text += fmt::format("{}_tint = \"{}\"\n", of.name, of.light);
  return text;
}

}  // namespace rotor
