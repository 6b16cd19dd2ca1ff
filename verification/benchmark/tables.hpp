/// Tables from the rows of the benchmark.
#pragma once

#include "verification/benchmark/measurement.hpp"

namespace rotor {

/// Names of methods in the rows.
inline const std::string ours = "event Verner 8(7)", published = "published RK4";

/// A tolerance as the rows show it.
std::string power_of_ten(int minus_exponent);

/// Run times of the others relative to ours at the same error of the state, without extrapolation.
void print_ratios(const std::vector<Row>& rows);

std::string to_csv(const std::vector<Row>& rows);

}  // namespace rotor
