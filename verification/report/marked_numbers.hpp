/// Numbers in Markdown that are computed: between a comment that names one and an empty comment, as
/// in `<!--published.mu_03.peak_kN.f1-->454.8<!---->`. Names and forms are those of `with_numbers`.
#pragma once

#include "verification/report/document.hpp"

namespace rotor {

/// The text with the present numbers. Throws std::invalid_argument for an unknown name.
std::string with_marked_numbers(const std::string& markdown, const Json& values);

/// The names: those of `values_json`, and claims, figures.3, corrections, reasons, laws.
Json markable_values(const std::vector<Number>& judged,
                     const std::filesystem::path& reference_data);

}  // namespace rotor
