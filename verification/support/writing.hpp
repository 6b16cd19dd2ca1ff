/// Tests of what the program writes.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "verification/support/command_line.hpp"

namespace rotor {

/// A short run, and one that takes longer than any test waits.
inline const std::string short_run = "run --until 0.1 --columns time_s,rho_m";
inline const std::string long_run = "run --no-separation --until 1e6 --columns time_s,rho_m";
/// Shell: waits, but not for ever, until the first rows of t.csv are in its draft.
inline const std::string wait_for_rows =
    "for n in $(seq 300); do [ -s .t.csv.*.part ] && break; sleep 0.05; done";

class Writing : public CommandLine {
 protected:
  void TearDown() override {
    EXPECT_EQ(files(), 0) << "something was left behind";
    CommandLine::TearDown();
  }
  void remove(const std::string& name) const { EXPECT_TRUE(fs::remove(folder_ / name)) << name; }
};

}  // namespace rotor
