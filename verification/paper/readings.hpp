/// What the claims of the paper's text are read as: numbers that arithmetic or runs give.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "verification/paper/paper_runs.hpp"

namespace rotor {

/// The value of a reading, in the unit of its claim; none if there is nothing to read, such as an
/// onset of rolling that did not occur. Throws std::out_of_range for one that does not exist.
std::optional<double> read_off(const std::string& reading, PaperRuns& runs);

/// Those that need no run.
using Arithmetic = std::function<double(const PaperInputs&, const Parameters&)>;
const std::map<std::string, Arithmetic>& all_arithmetic();

/// All that exist.
std::vector<std::string> all_readings();

}  // namespace rotor
