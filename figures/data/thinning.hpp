/// Leaves out the rows of a table that its curves do not need.
#pragma once

#include "figures/data/csv.hpp"

namespace rotor {

/// Largest distance between a figure's curve and the motion, relative to the picture's height: a
/// fifth of a pixel in a picture 1000 pixels high.
inline constexpr double thinning = 2e-4;

/// The table with only the rows that its curves need: interpolated over its first column, which
/// must not fall, each other column stays within `tolerance`, relative to its range, of its values
/// in the full table.
Table thinned(const Table& table, double tolerance);

}  // namespace rotor
