/// Laws and closed forms, and how well they hold.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace rotor {

/// The allowed residual of a law. The largest residual in a test is recorded, and the report shows
/// both, unless the law has no name, as in tests of this class.
class Law {
 public:
  Law(std::string says, double allowed) : says_(std::move(says)), allowed_(allowed) {}
  Law(const Law&) = delete;
  Law& operator=(const Law&) = delete;
  ~Law() {
    if (!says_.empty())
      testing::Test::RecordProperty("law " + says_, fmt::format("{:.1e} {:.1e}", worst_, allowed_));
  }

  void expect_left(double residual) {
    worst_ = std::max(worst_, std::abs(residual));
    EXPECT_LE(std::abs(residual), allowed_) << says_;
  }

 private:
  std::string says_;
  double allowed_, worst_ = 0;
};

}  // namespace rotor
