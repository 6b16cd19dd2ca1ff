/// Readings of the claims of the paper's text: numbers from arithmetic or runs.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "verification/paper/paper_runs.hpp"

namespace rotor {

/// The value of a reading, in the unit of its claim; none if, for example, rolling did not set in.
/// Throws std::out_of_range for an unknown reading.
std::optional<double> read_off(const std::string& reading, PaperRuns& runs);

/// The readings that need no run.
using Arithmetic = std::function<double(const PaperInputs&, const Parameters&)>;
const std::map<std::string, Arithmetic>& all_arithmetic();

/// All readings.
std::vector<std::string> all_readings();

}  // namespace rotor
