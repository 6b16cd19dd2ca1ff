/// The words and colours of figures/input/words.hpp for the page.
#include <fmt/format.h>

#include "figures/input/words.hpp"
#include "verification/report/document.hpp"

namespace rotor {
namespace {

template <class Entries, class Member>
std::string properties(const Entries& entries, Member tint) {
  std::string all;
  for (const auto& entry : entries) all += fmt::format(" --{}: {};", entry.name, entry.*tint);
  return all;
}

}  // namespace

std::string words_of_page() {
  Json sentences, labels, lines;
  for (const auto& of : outcomes) sentences[std::string(of.name)] = of.sentence;
  for (const auto& of : results_in_words) labels[std::string(of.key)] = of.label;
  for (const auto& of : lines_in_words)
    lines.push_back({{"width", of.width},
                     {"dashes", Json::parse(fmt::format("[{}]", of.dashes))},
                     {"words", of.words}});
  return fmt::format(
      "// Written by `make approve` from figures/input/words.hpp.\nexport const outcomes = "
      "{};\nexport const results = {};\nexport const lines = {};\n",
      sentences.dump(1), labels.dump(1), lines.dump());
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
