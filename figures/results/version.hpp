/// Which program it is.
#pragma once

#include <string_view>

namespace rotor {

/// The number, and what `git describe` says of the sources: "1.0.0 (684b769-dirty)". Stored
/// tables have only the number, so that they do not change with each commit.
std::string_view version();

}  // namespace rotor
