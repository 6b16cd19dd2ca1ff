/// JSON documents.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace rotor {

/// Keys in the order in which they are written.
using Json = nlohmann::ordered_json;

/// A number in a unit; null if it is not known or not finite.
inline Json json_of(double value, double unit = 1) {
  return std::isfinite(value) ? Json(value / unit) : Json();
}
inline Json json_of(const std::optional<double>& value, double unit = 1) {
  return value ? json_of(*value, unit) : Json();
}

}  // namespace rotor
