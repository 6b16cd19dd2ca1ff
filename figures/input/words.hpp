/// Names in the words of people. figures/paper/style.gp and the page have the same words.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace rotor {

/// What pictures and summaries call equations by their name, "mixed" included.
constexpr std::string_view equations_in_words(std::string_view name) {
  return name == "published"                           ? "equations as printed"
         : name == "consistent" || name == "corrected" ? "corrected equations"
                                                       : "equations corrected in part";
}

/// A name with spaces, without the unit of a speed.
inline std::string name_in_words(std::string_view name) {
  for (const std::string_view unit : {"_hz", "_rpm"})
    if (name.ends_with(unit)) name.remove_suffix(unit.size());
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

}  // namespace rotor
