/// What the benchmark prints where nothing was measured.
#include "verification/benchmark/tables.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace rotor {
namespace {

/// The line of a method among what is printed, and its entry at an error of 1e-n.
std::string entry(const std::string& printed, const std::string& method, std::size_t n) {
  const std::size_t line = printed.find(method);
  EXPECT_NE(line, std::string::npos);
  std::istringstream entries(printed.substr(line + method.size()));
  std::string found;
  for (std::size_t i = 0; i < n; ++i) entries >> found;
  return found;
}

// By its order it would go on to a factor of thousands. What was not measured is not printed.
TEST(Ratios, EndWhereAMethodWasNotMeasured) {
  const auto row = [](const std::string& method, double time_s, double error) {
    Row its{};
    its.problem = "rub";
    its.method = method;
    its.time_s = time_s;
    its.error_state = error;
    return its;
  };
  const std::vector<Row> rows = {row(ours, 1, 1e-1),
                                 row(ours, 2, 1e-6),
                                 row(ours, 4, 1e-11),
                                 row("fixed-steps", 10, 1e-1),
                                 row("fixed-steps", 100, 1e-2),
                                 row("fixed-steps", 1000, 1e-3)};
  testing::internal::CaptureStdout();
  print_ratios(rows);
  std::fflush(stdout);
  const std::string printed = testing::internal::GetCapturedStdout();
  EXPECT_EQ(entry(printed, "fixed-steps", 1), "10.0");
  EXPECT_NE(entry(printed, "fixed-steps", 3), "-");
  for (std::size_t digits = 4; digits <= 10; ++digits)
    EXPECT_EQ(entry(printed, "fixed-steps", digits), "-") << digits;
}

}  // namespace
}  // namespace rotor
