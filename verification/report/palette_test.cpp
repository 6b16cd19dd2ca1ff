/// Colours and words of outcomes and equations: figures/paper/style.gp states them, the page and
/// the program repeat them.
#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "figures/input/names.hpp"
#include "figures/input/words.hpp"
#include "verification/report/document.hpp"

namespace rotor {
namespace {

const std::string style = content_of(std::string(ROTOR_SOURCES) + "/figures/paper/style.gp"),
                  page = content_of(std::string(ROTOR_SOURCES) + "/verification/report/page.css");

/// What a pattern's group matches, one after the other.
std::vector<std::string> all_in(const std::string& text, const std::string& pattern) {
  const std::regex with_group(pattern);
  std::vector<std::string> all;
  for (std::sregex_iterator at(text.begin(), text.end(), with_group), end; at != end; ++at)
    all.push_back((*at)[1]);
  return all;
}

std::string line_of(const std::string& name) {
  return all_in(style, "array " + name + "\\[7\\] = ([^\n]*)").at(0);
}

/// The lightness L* of a colour such as #0072b2, CIE 1976: what remains of it in grey.
double lightness(const std::string& colour) {
  double luminance = 0;
  for (const auto& [at, share] : {std::pair(1, 0.2126), {3, 0.7152}, {5, 0.0722}}) {
    const double value =
        std::stoi(colour.substr(static_cast<std::size_t>(at), 2), nullptr, 16) / 255.;
    luminance += share * (value > 0.04045 ? std::pow((value + 0.055) / 1.055, 2.4) : value / 12.92);
  }
  return 116 * std::cbrt(luminance) - 16;
}

// Neighbours in a map differ by three just noticeable differences of 2.3, so that they can be told
// apart in grey and by colour-blind readers, who see lightness as others do.
void expect_distinct(const std::vector<std::string>& colours) {
  ASSERT_EQ(colours.size(), 7U);
  for (const std::string& one : colours)
    for (const std::string& other : colours)
      if (one != other) {
        EXPECT_GT(std::abs(lightness(one) - lightness(other)), 3 * 2.3) << one << other;
      }
}

TEST(Palette, TellsOutcomesApartInGreyAndIsTheSameOnThePage) {
  const auto figures = all_in(line_of("outcome_tint"), "\"(#[0-9a-f]{6})\"");
  expect_distinct(figures);
  std::vector<std::string> light, dark;
  for (const char* letter : {"n", "u", "f", "b", "s", "r", "none"}) {
    const auto both = all_in(page, std::string("--outcome-") + letter + ": (#[0-9a-f]{6})");
    ASSERT_EQ(both.size(), 2U);
    light.push_back(both[0]);
    dark.push_back(both[1]);
  }
  EXPECT_EQ(light, figures);
  expect_distinct(dark);
}

TEST(Palette, CallsOutcomesAndEquationsTheSameEverywhere) {
  const auto names = all_in(line_of("outcome_name"), "\"([^\"]*)\"");
  const std::string map =
      content_of(std::string(ROTOR_SOURCES) + "/verification/report/script/map.js");
  EXPECT_EQ(names.size(), names_of<Outcome>.size());
  for (const std::string& name : names) {
    EXPECT_NO_THROW(parse_name<Outcome>(name));
    EXPECT_NE(map.find('"' + name_in_words(name)), std::string::npos) << name;
  }
  for (const auto& [name, equations] : names_of<Equations>)
    EXPECT_NE(style.find(fmt::format("\"{}\"", equations_in_words(name))), std::string::npos)
        << name;
  EXPECT_EQ(equations_in_words("corrected"), equations_in_words("consistent"));
}

}  // namespace
}  // namespace rotor
