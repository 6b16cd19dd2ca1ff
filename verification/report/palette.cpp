/// The words and colours of figures/input/words.hpp for gnuplot and for the page.
#include <fmt/format.h>

#include "figures/input/words.hpp"
#include "verification/report/document.hpp"

namespace rotor {
namespace {

constexpr const char* written = "Written by `make approve` from figures/input/words.hpp.";

/// The same member of each entry of a table, as a list for JSON and gnuplot.
template <class Entries, class Member>
Json each(const Entries& entries, Member member) {
  Json all;
  for (const auto& entry : entries) all.push_back(entry.*member);
  return all;
}

template <class Entries, class Member>
std::string properties(const Entries& entries, Member tint) {
  std::string all;
  for (const auto& entry : entries) all += fmt::format(" --{}: {};", entry.name, entry.*tint);
  return all;
}

}  // namespace

std::string palette_of_gnuplot() {
  using Of = OutcomeInWords;
  using In = EquationsInWords;
  std::string text = fmt::format("# {}\n", written), colours;
  const auto add = [&](const char* name, const Json& list) {
    text += fmt::format("array {}[{}] = {}\n", name, list.size(), list.dump());
  };
  add("outcome_name", each(outcomes, &Of::name));
  add("outcome_tint", each(outcomes, &Of::light));
  Json words;
  for (const Of& of : outcomes) words.push_back(name_in_words(of.name));
  add("outcome_words", words);
  for (std::size_t n = 0; n < outcomes.size(); ++n)
    colours += fmt::format("{}{} '{}'", n > 0 ? ", " : "", n, outcomes[n].light);
  text += fmt::format(
      "outcome_palette = \"set palette maxcolors {} defined ({}); set cbrange [-0.5:{}.5]\"\n",
      outcomes.size(), colours, outcomes.size() - 1);
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

std::string words_of_page() {
  Json sentences, labels, lines;
  for (const auto& of : outcomes) sentences[std::string(of.name)] = of.sentence;
  for (const auto& of : results_in_words) labels[std::string(of.key)] = of.label;
  for (const auto& of : lines_in_words)
    lines.push_back({{"width", of.width},
                     {"dashes", Json::parse(fmt::format("[{}]", of.dashes))},
                     {"words", of.words}});
  return fmt::format(
      "// {}\nexport const outcomes = {};\nexport const results = {};\nexport const lines = {};\n",
      written, sentences.dump(1), labels.dump(1), lines.dump());
}

std::string tints_of_page() {
  const auto all = [](auto of_set, auto of_outcome) {
    return properties(sets_in_words, of_set) + properties(outcomes, of_outcome) +
           properties(others_in_words, of_set);
  };
  return fmt::format(":root {{{} }}\n@media (prefers-color-scheme: dark) {{ :root {{{} }} }}\n",
                     all(&EquationsInWords::light, &OutcomeInWords::light),
                     all(&EquationsInWords::dark, &OutcomeInWords::dark));
}

}  // namespace rotor
