/// SciPy as a peer, in another process.
#pragma once

#include <filesystem>

#include "verification/benchmark/measurement.hpp"

namespace rotor {

/// Its rows, from a script of peers/. None if it is not installed, which is said.
std::vector<Row> rows_of_scipy(const std::vector<Problem>& problems,
                               const std::vector<Outcome>& exact,
                               const std::filesystem::path& folder, const std::string& python,
                               const std::string& script);

}  // namespace rotor
