/// Tables: as comma-separated values, and thinned.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>

#include "figures/data/csv.hpp"
#include "figures/data/read_csv.hpp"
#include "figures/data/thinning.hpp"

namespace rotor {
namespace {

// Names of any characters, and numbers to the last bit.
TEST(Csv, ReadsWhatItHasWritten) {
  std::mt19937_64 random(1);
  const std::string odd = ",\"\n\r\t\x01\x7f# a;\xc2\xb5";
  std::string text = "# provenance\nrun,x,y\n";
  std::vector<std::pair<std::string, double>> written;
  for (int n = 0; n < 2000; ++n) {
    std::string name(random() % 6, ' ');
    for (char& c : name) c = odd[random() % odd.size()];
    const double x = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 200));
    written.emplace_back(name, x);
    text += csv_row(name, std::vector{x, std::nan("")});
  }
  std::istringstream stream(text);
  const std::vector<CsvRow> rows = read_csv(stream, "t.csv");
  ASSERT_EQ(rows.size(), written.size());
  for (std::size_t n = 0; n < rows.size(); ++n) {
    EXPECT_EQ(rows[n]["run"], written[n].first);
    EXPECT_EQ(static_cast<double>(rows[n].number("x")), written[n].second);
    EXPECT_EQ(rows[n]["y"], "");
    EXPECT_THROW(static_cast<void>(rows[n].number("y")), std::runtime_error);
  }
}

// Wherever a program splits the lines of provenance, which keep all but blanks.
TEST(Csv, HasNoFormulasAboveItsRows) {
  std::mt19937_64 random(1);
  const std::string odd = ",;=+-@ a";
  const auto without_blanks = [](std::string text) {
    std::erase(text, ' ');
    return text;
  };
  for (int n = 0; n < 1000; ++n) {
    std::string text(random() % 9, ' ');
    for (char& c : text) c = odd[random() % odd.size()];
    const std::string head = csv_head({text}, {"run"});
    EXPECT_EQ(without_blanks(head), without_blanks("#" + text + "\nrun\n"));
    for (const char* formula : {",=", ",+", ",-", ",@", ";=", ";+", ";-", ";@"})
      EXPECT_EQ(head.find(formula), head.npos) << head;
  }
}

// Curves with impacts of a single sample, and with a gap whose ends are kept.
TEST(Thinning, KeepsEveryColumnWithinItsTolerance) {
  constexpr double tolerance = 1e-3, none = std::numeric_limits<double>::quiet_NaN();
  Table full(4);
  for (int i = 0; i <= 20000; ++i) {
    const double t = i * 1e-4;
    full.add(t);
    full.add(std::sin(300 * t));
    full.add(i % 5000 == 777 ? 1 : std::cos(410 * t) / 2);
    full.add(i < 9000 || i > 9400 ? 5 * (t - 0.92) * (t - 0.92) : none);  // hardly above 0
  }
  const Table thin = thinned(full, tolerance);
  EXPECT_LT(thin.rows(), full.rows() / 3);
  const auto ends = [](const Table& table, std::size_t column) {
    std::vector<double> values;
    for (std::size_t i = 0; i < table.rows(); ++i) values.push_back(table.row(i)[column]);
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    return std::pair(*least, *greatest);
  };
  for (const std::size_t column : {1U, 2U})  // what figures quote
    EXPECT_EQ(ends(thin, column), ends(full, column));
  const std::vector<double> ranges = {0, 2, 1.5, 5 * 1.08 * 1.08};
  std::size_t next = 1;
  for (std::size_t i = 0; i < full.rows(); ++i) {
    while (thin.row(next)[0] < full.row(i)[0]) ++next;
    const auto a = thin.row(next - 1), b = thin.row(next);
    const double part = (full.row(i)[0] - a[0]) / (b[0] - a[0]);
    for (const std::size_t column : {1U, 2U, 3U}) {
      const double there = part == 1 ? b[column] : a[column] + part * (b[column] - a[column]);
      const double here = full.row(i)[column];
      EXPECT_EQ(std::isnan(there), std::isnan(here)) << i;
      EXPECT_FALSE(std::abs(here - there) > (1 + 1e-9) * tolerance * ranges[column]) << i;
    }
  }
}

}  // namespace
}  // namespace rotor
