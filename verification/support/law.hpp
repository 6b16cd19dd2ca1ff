/// Laws and closed forms, and how well they hold.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace rotor {

/// The allowed residual of a law.
class Law {
 public:
  Law(std::string says, double allowed) : says_(std::move(says)), allowed_(allowed) {}

  void expect_left(double residual) const { EXPECT_LE(std::abs(residual), allowed_) << says_; }

 private:
  std::string says_;
  double allowed_;
};

}  // namespace rotor
