/// What a section tells, by its keys in summaries and its columns in results of sweeps.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "figures/record/section.hpp"
#include "figures/results/json.hpp"

namespace rotor {

/// What is told of an order: the ending of its key, words and a formula.
struct OrderValue {
  std::string_view ending, words, meaning;
  std::optional<double> (*of)(const OrderMeans&);
};
/// Empty if the mean is zero.
std::optional<double> phase(const std::complex<double>& mean);
inline constexpr auto order_values = std::to_array<OrderValue>({
    {"forward_m", "forward", "|F(o)|",
     [](const OrderMeans& of) { return std::optional(std::abs(of.forward)); }},
    {"forward_phase_rad", "phase forward", "arg F(o)",
     [](const OrderMeans& of) { return phase(of.forward); }},
    {"backward_m", "backward", "|F(-o)|",
     [](const OrderMeans& of) { return std::optional(std::abs(of.backward)); }},
    {"backward_phase_rad", "phase backward", "arg F(-o)",
     [](const OrderMeans& of) { return phase(of.backward); }},
    {"x_a_peak_to_peak_m", "x_a peak to peak", "2 |F(o) + conj F(-o)|",
     [](const OrderMeans& of) { return std::optional(of.peak_to_peak_x()); }},
    {"y_a_peak_to_peak_m", "y_a peak to peak", "2 |F(o) - conj F(-o)|",
     [](const OrderMeans& of) { return std::optional(of.peak_to_peak_y()); }},
});

/// A key besides those of orders.
struct SectionValue {
  std::string_view key;
  std::string meaning;
  std::string_view type;  ///< in JSON schema, besides null
  Json (*of)(const SectionSummary&);
};
const std::vector<SectionValue>& section_values();

/// order_1_2_forward_m
std::string key_of(const Order& order, const OrderValue& value);
/// "order 1/2, forward", if the key is one of an order.
std::optional<std::string> order_in_words(std::string_view key);

/// The keys of all.
std::vector<std::string> section_columns();

Json to_json(const SectionSummary& section);
/// The JSON schema of that.
Json section_schema();

}  // namespace rotor
