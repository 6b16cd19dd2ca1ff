/// How far both methods can be pushed.
#pragma once

#include <filesystem>

namespace rotor {

/// Random rotors through the event-located method, with what they show in a folder. Returns the
/// status of the program: 1 if a run went wrong without saying so.
int stress_rotors(long count, const std::filesystem::path& folder);

/// The limits of stability of the published method's step.
int stress_steps(const std::filesystem::path& folder);

}  // namespace rotor
