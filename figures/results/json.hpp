/// JSON documents.
#pragma once

#include <nlohmann/json.hpp>

namespace rotor {

/// Keys in the order in which they are written.
using Json = nlohmann::ordered_json;

}  // namespace rotor
