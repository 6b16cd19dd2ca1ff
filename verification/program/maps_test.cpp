/// The closed forms in maps.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "figures/data/read_csv.hpp"
#include "figures/input/words.hpp"
#include "model/theory/accident.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/content.hpp"
#include "verification/support/pattern.hpp"

namespace rotor {
namespace {

constexpr long width = 50, height = 5;  ///< points along each axis

class Maps : public CommandLine {
 protected:
  /// A map over speed and friction whose runs have one outcome at low speeds and another at higher
  /// ones, from 90 Hz on.
  void write_map(std::string_view low, std::string_view high) const {
    write(
        "map.toml",
        replaced(replaced(content_of(ROTOR_SOURCES "/figures/maps/speed-friction.toml"),
                          "from = 0\nto = 0.5\npoints = 400", "values = [0.1, 0.2, 0.3, 0.4, 0.5]"),
                 "points = 400", fmt::format("points = {}", width)));
    std::string csv = "equations_varied,friction,start_speed_Hz,outcome,refusal\n";
    for (const char* set : {"published", "corrected"})
      for (long row = 0; row < height; ++row)
        for (long n = 0; n < width; ++n)
          csv += fmt::format("{},{},{},{},\n", set, row, n, n < width / 2 ? low : high);
    write("map.csv", csv);
  }

  /// What is written of the closed forms, by speed, friction and panel.
  std::vector<CsvRow> closed_forms() const {
    EXPECT_EQ(
        shell("'" ROTOR_BUILD "/map-theory' map.toml map.csv | sed 's/^# x/x/' >theory.csv").output,
        "");
    std::istringstream table(replaced(content("theory.csv"), "\n\n+", "\n"));
    return read_csv(table, "theory");
  }

  /// The speeds at which each closed form is written, Hz: the least and the greatest.
  std::map<std::string, std::pair<double, double>> speeds() const {
    std::map<std::string, std::pair<double, double>> all;
    for (const CsvRow& row : closed_forms())
      for (const LineInWords& line : lines_in_words)
        if (row[line.name] != "nan") {
          const auto speed = static_cast<double>(row.number("x"));
          auto& [least, greatest] =
              all.try_emplace(std::string(line.name), speed, speed).first->second;
          least = std::min(least, speed);
          greatest = std::max(greatest, speed);
        }
    return all;
  }
};

// A form of rolling says nothing where the runs slide, and so on; near the border, within some
// points, either may be written.
TEST_F(Maps, HaveClosedFormsWhereTheRunsDoWhatTheyAssume) {
  const double border_Hz = 3 + 177. * (width / 2 - 0.5) / (width - 1), near_Hz = 3 * 177. / width;
  const std::map<std::string, std::vector<std::string>> forms = {
      {"no_contact", {"greatest", "bound", "steady"}},
      {"undecided", {"greatest", "bound", "steady"}},
      {"freed", {"rebound"}},
      {"bouncing", {"rebound"}},
      {"sliding", {"forward"}},
      {"rolling", {"peak"}},
      {"stalled", {}}};
  for (const auto& [high, of_high] : forms) {
    const std::string low = high == "rolling" ? "sliding" : "rolling";
    write_map(low, high);
    const auto found = speeds();
    EXPECT_EQ(found.size(), of_high.size() + 1) << high;
    for (const std::string& form : of_high) {
      ASSERT_TRUE(found.contains(form)) << form << " where runs are " << high;
      EXPECT_NEAR(found.at(form).first, border_Hz, near_Hz) << form;
      EXPECT_EQ(found.at(form).second, 180) << form;
    }
    EXPECT_NEAR(found.at(forms.at(low).front()).second, border_Hz, near_Hz) << low;
  }
}

// What the legend calls "largest force of 300 kN".
TEST_F(Maps, HaveALineBetweenForcesBelowAndAboveTheOneOfItsWords) {
  EXPECT_TRUE(has(lines_in_words.back().words, "300 kN"));
  write_map("rolling", "rolling");
  const std::vector<CsvRow> rows = closed_forms();
  long above = 0;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const Parameters p{.torque = 0, .friction = static_cast<double>(rows[n].number("y"))};
    const Equations set = 2 * n < rows.size() ? Equations::published : Equations::corrected;
    const auto speed = two_pi * static_cast<double>(rows[n].number("x"));
    const bool is_above = Accident(p, set, speed).peak_force().value_or(0) > 300e3;
    EXPECT_EQ(rows[n].number("peak") > 0, is_above) << n;
    above += is_above ? 1 : 0;
  }
  EXPECT_GT(above, 0);
  EXPECT_LT(above, static_cast<long>(rows.size()));
}

TEST_F(Maps, RefuseResultsOfOthers) {
  write_map("rolling", "sliding");
  write("fewer.toml", replaced(content("map.toml"), "points = 50", "points = 49"));
  for (const auto& [arguments, message] : std::vector<std::pair<std::string, std::string>>{
           {"fewer.toml map.csv", "map-theory: map.csv: has 500 points, the map 490\n"},
           {"map.toml none.csv", "map-theory: none.csv: cannot be read\n"},
           {"map.toml", "map-theory: needs a sweep file and its results\n"}}) {
    const auto [status, output] = shell("'" ROTOR_BUILD "/map-theory' " + arguments);
    EXPECT_EQ(status, 1);
    EXPECT_EQ(output, message);
  }
}

// Remarks have commas, quotes and line ends.
TEST_F(Maps, HaveTheSharesOfTheDrawsAtEachPoint) {
  write("map.toml",
        "title = \"shares\"\n[[axis]]\nquantity = \"equations\"\nvalues = [\"published\"]\n"
        "[[axis]]\nquantity = \"friction\"\nvalues = [0.1, 0.2]\n[sample]\ncount = 4\n"
        "[[sample.over]]\nquantity = \"clearance\"\nuniform = [1e-3, 3e-3]\n");
  const std::string header =
                        "# Sweep: shares\nequations_varied,friction,clearance,outcome,refusal\n",
                    rows =
                        "published,0.1,0.001,rolling,\npublished,0.1,0.002,freed,\n"
                        "published,0.1,0.002,freed,\npublished,0.1,0.003,,\"a, \"\"b\"\"\"\n"
                        "published,0.2,0.001,rolling,\npublished,0.2,0.002,rolling,\n"
                        "published,0.2,0.002,rolling,\n";
  write("map.csv", header + rows + "published,0.2,0.003,rolling,\n");
  write("cut.csv", header + rows);
  write("other.csv",
        header + replaced(rows, "freed", "rolling") + "published,0.2,0.003,sliding,\n");
  const auto statistics = [&](const std::string& of) {
    return shell("'" ROTOR_BUILD "/map-statistics' " + of).output;
  };
  EXPECT_EQ(statistics("shares map.toml map.csv"),
            "# shares\nequations,friction,draws,rolling_share,half_interval\n"
            "published,0.1,4,0.25,0.399785\npublished,0.2,4,1,0.301182\n");
  EXPECT_EQ(statistics("others map.csv map.csv"), "0 % of 8 points\n");
  EXPECT_EQ(statistics("others map.csv other.csv"), "38 % of 8 points\n");
  for (const auto& [of, message] : std::vector<std::pair<std::string, std::string>>{
           {"shares map.toml cut.csv", "map-statistics: cut.csv: its last point lacks draws\n"},
           {"others map.csv cut.csv",
            "map-statistics: map.csv and cut.csv must have the same points\n"}}) {
    const auto [status, output] = shell("'" ROTOR_BUILD "/map-statistics' " + of);
    EXPECT_EQ(status, 1);
    EXPECT_TRUE(has(output, message)) << output;
  }
}

}  // namespace
}  // namespace rotor
