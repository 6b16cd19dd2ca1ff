/// Where lines, brackets and marks stand in figures is where their data say.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <tuple>

#include "verification/support/figure_drawing.hpp"

namespace rotor {
namespace {

using Drawn = PublishedFigures;

// From the energy after the mass loss by collisions to that of continuous contact, by sliding to
// that of rolling.
TEST_F(Drawn, BracketsOfEnergiesBeginAndEndAtThem) {
  const DrawnPicture picture = drawn(6);
  const std::vector<CsvRow> rows = data_of(6);
  const auto energy = [&](const CsvRow& row) {
    return static_cast<double>(row.number("kinetic_energy_J"));
  };
  const auto state = [](const CsvRow& row) { return row.number("contact_state"); };
  std::vector<double> energies_J;
  for (const CsvRow& row : rows)
    if (row.number("time_s") == 29.1L) energies_J = {energy(row)};  // the last one is after it
  int touch_downs = 0;
  for (std::size_t n = 1; n < rows.size() && touch_downs < 6; ++n)
    if (state(rows[n]) > 0 && state(rows[n - 1]) == 0 && ++touch_downs == 6)
      energies_J.push_back(energy(rows[n]));
  const auto onset = std::ranges::find_if(rows, [&](const CsvRow& row) { return state(row) == 2; });
  energies_J.push_back(energy(*onset));
  ASSERT_EQ(energies_J.size(), 3U);
  ASSERT_EQ(picture.brackets.size(), 2U);
  const Tics& y = picture.curves.front().y;
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_NEAR(picture.brackets[n][0].second, pixel(y, energies_J[n]), 1);
    EXPECT_NEAR(picture.brackets[n][1].second, pixel(y, energies_J[n + 1]), 1);
  }
}

// Upright lines stand at the touch-down that is counted and at the onset of rolling.
TEST_F(Drawn, UprightLinesStandAtTheEventsThatTheyName) {
  for (const int number : {5, 6, 7}) {
    const DrawnPicture picture = drawn(number);
    std::vector<double> times_s;
    int touch_downs = 0;
    long double state = 0;
    for (const CsvRow& row : data_of(number)) {
      const long double now = row.number("contact_state");
      if (number == 6 && now > 0 && state == 0 && ++touch_downs == 6)
        times_s.push_back(static_cast<double>(row.number("time_s")));
      if (now == 2 && state < 2) times_s.push_back(static_cast<double>(row.number("time_s")));
      state = now;
    }
    ASSERT_EQ(picture.uprights.size(), times_s.size()) << number;
    for (std::size_t n = 0; n < times_s.size(); ++n)
      EXPECT_NEAR(picture.uprights[n], pixel(picture.x, times_s[n]), 1) << number;
  }
}

// What is drawn along time begins and ends with the axis.
TEST_F(Drawn, CurvesAlongTimeFillTheirAxis) {
  const std::regex range(R"(set xrange \[([0-9.]+):([0-9.]+)\])");
  for (const int number : {2, 3, 4, 5, 6, 7, 11, 12, 13, 14, 15, 17}) {
    std::ifstream file(fmt::format(ROTOR_SOURCES "/figures/paper/fig{:02}.gp", number));
    const std::string script{std::istreambuf_iterator<char>(file), {}};
    std::smatch ends;
    ASSERT_TRUE(std::regex_search(script, ends, range)) << number;
    static_cast<void>(drawn(number));
    std::map<std::string, std::pair<double, double>> spans;
    for (const CsvRow& row : data_of(number)) {
      const auto time_s = static_cast<double>(row.number("time_s"));
      spans.try_emplace(std::string(row["run"]), time_s, time_s).first->second.second = time_s;
    }
    for (const auto& [run, span] : spans) {
      EXPECT_LE(span.first, std::stod(ends[1])) << number << ' ' << run;
      EXPECT_EQ(span.second, std::stod(ends[2])) << number << ' ' << run;
    }
  }
}

}  // namespace
}  // namespace rotor
