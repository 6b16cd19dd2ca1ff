/// Words and colours of outcomes and equations are those of one table, wherever they are shown.

#include <gtest/gtest.h>

#include <cmath>

#include "figures/input/words.hpp"
#include "verification/report/document.hpp"
#include "verification/support/approved.hpp"

namespace rotor {
namespace {

/// The lightness L* of a colour such as #0072b2, CIE 1976: what remains of it in grey.
double lightness(std::string_view colour) {
  double luminance = 0;
  for (const auto& [at, share] : {std::pair(1, 0.2126), {3, 0.7152}, {5, 0.0722}}) {
    const double value =
        std::stoi(std::string(colour.substr(static_cast<std::size_t>(at), 2)), nullptr, 16) / 255.;
    luminance += share * (value > 0.04045 ? std::pow((value + 0.055) / 1.055, 2.4) : value / 12.92);
  }
  return 116 * std::cbrt(luminance) - 16;
}

// Any two differ by three just noticeable differences of 2.3, so that they can be told apart in
// grey and by colour-blind readers, who see lightness as others do.
TEST(Palette, TellsOutcomesApartInGrey) {
  for (const auto of : {&OutcomeInWords::light, &OutcomeInWords::dark})
    for (const OutcomeInWords& one : outcomes)
      for (const OutcomeInWords& other : outcomes)
        if (one.outcome != other.outcome) {
          EXPECT_GT(std::abs(lightness(one.*of) - lightness(other.*of)), 3 * 2.3)
              << one.name << ", " << other.name;
        }
}

// What gnuplot and the page's scripts read is the table's.
TEST(ApprovedPalette, IsThatOfTheTable) {
  expect_approved("figures/paper/palette.gp", palette_of_gnuplot());
  expect_approved("verification/report/script/words.js", words_of_page());
}

}  // namespace
}  // namespace rotor
