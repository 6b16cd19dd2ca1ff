/// The files of a sweep's parts, and how they are joined.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "figures/sweep/part.hpp"
#include "figures/sweep/sweep.hpp"

namespace rotor {

/// The part that a text names, such as 3/64, if there can be one.
std::optional<Part> part_in(std::string_view text, std::string_view separator = "/");

/// The file of a part next to that of all results: NAME.3-of-64.csv for NAME.csv.
std::filesystem::path file_of(const Part& part, const std::filesystem::path& results);

/// Writes results from the files of all parts next to them, whole or not at all. Throws
/// std::runtime_error with each part that is missing, unfinished, damaged or of another sweep.
void join_parts(const Sweep& sweep, const std::filesystem::path& results);

}  // namespace rotor
