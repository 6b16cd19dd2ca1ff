/// Tests of what `rotor run --json` prints.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "verification/support/command_line.hpp"

namespace rotor {

class RunSummary : public CommandLine {
 protected:
  nlohmann::json summary(const std::string& arguments) const {
    const Outcome outcome = rotor("run --json " + arguments + " 2>messages");
    EXPECT_EQ(outcome.status, 0) << arguments << ": " << content("messages");
    return outcome.status == 0 ? nlohmann::json::parse(outcome.output) : nlohmann::json();
  }
};

}  // namespace rotor
