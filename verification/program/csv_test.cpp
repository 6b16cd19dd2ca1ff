/// Tables as comma-separated values, written and read.
#include "figures/data/csv.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace rotor {
namespace {

TEST(Csv, QuotesWhatWouldNotBeOneField) {
  for (const char* text : {",", "\n", "\r", "\t", "\x01", "\x7f", "a\nb", "case #1"})
    EXPECT_EQ(csv_field(text), '"' + std::string(text) + '"');
  EXPECT_EQ(csv_field("\""), "\"\"\"\"");
  EXPECT_EQ(csv_field("2 k_t; µ"), "2 k_t; µ");
}

// What begins like a comment is none.
TEST(Csv, QuotesWhatBeginsWithAHash) {
  EXPECT_EQ(csv_row("#1", std::vector{2.}), "\"#1\",2\n");
  std::istringstream text("run,x\n" + csv_row("#1", std::vector{2.}));
  ASSERT_EQ(read_csv(text, "t.csv").size(), 1U);
}

// Times, say, which are read again.
TEST(Csv, HasNumbersWithAllTheirDigits) {
  const double time_s = 29.100000000000001;
  std::istringstream text("run,x\n" + csv_row("a", std::vector{time_s + 1e-13}));
  EXPECT_EQ(static_cast<double>(read_csv(text, "t.csv").front().number("x")), time_s + 1e-13);
}

TEST(Csv, LeavesACellEmptyWhereThereIsNoNumber) {
  EXPECT_EQ(csv_row("a,b", std::vector{1.5, std::nan(""), -2e-9}), "\"a,b\",1.5,,-2e-09\n");
}

TEST(Csv, NamesTheLineOfARowBelowOthersThatTakeSeveral) {
  std::istringstream text("# provenance\n\"a\nb\",c\n1,\"x\ny\"\n2,z\n# between\n3,z\n");
  const std::vector<CsvRow> rows = read_csv(text, "t.csv");
  ASSERT_EQ(rows.size(), 3U);
  std::string places;
  for (const CsvRow& row : rows) try {
      row.fail("");
    } catch (const std::runtime_error& error) {
      places += error.what();
    }
  EXPECT_EQ(places, "t.csv:4: t.csv:6: t.csv:8: ");
}

TEST(Csv, NamesTheCellThatIsNoNumber) {
  for (const char* cell : {"", "z", "2z", "1e9999"}) {
    std::istringstream text(std::string("a,c\n1,") + cell + "\n");
    const CsvRow row = read_csv(text, "t.csv").front();
    EXPECT_EQ(row.number("a"), 1);
    try {
      FAIL() << static_cast<double>(row.number("c"));
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(error.what(), "t.csv:2: c: must be a number, not \"" + std::string(cell) + '"');
    }
  }
}

}  // namespace
}  // namespace rotor
