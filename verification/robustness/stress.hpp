/// How far both methods can be pushed.
#pragma once

#include <filesystem>

namespace rotor {

/// Runs random rotors by the event-located method, and writes the results to a folder. Returns the
/// status of the program: 1 if a run was wrong without an error.
int stress_rotors(long count, const std::filesystem::path& folder);

/// The limits of stability of the published method's step.
int stress_steps(const std::filesystem::path& folder);

}  // namespace rotor
