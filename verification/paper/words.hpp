/// The words and digits in which tables, pictures and the page show the numbers of claims.
#pragma once

#include <optional>
#include <string>

#include "verification/paper/claims.hpp"

namespace rotor {

/// What is claimed; of a statement, 1 if it is true and 0 if not, without that explanation.
std::string words_of(const Number& number);

/// A value in the number's unit, without superfluous digits, in powers of ten if the paper has
/// them; of a statement yes or no; none if there is no value.
std::string shown(const std::optional<double>& value, const Number& number);

/// What the paper states: a number or a word.
std::string printed(const Number& number);

/// The number's rule, with what it allows.
std::string rule_of(const Number& number);

/// The 5 to 95 % range of draws; empty if there is none.
std::string range_of(const Stored& stored);

/// How far a value is from the number as printed, which needs no rule; empty if there is none.
std::string deviation(const std::optional<double>& value, const Number& number);

/// The value at the inputs as printed by the reading that decides; a claim about the paper's
/// method is judged by that.
std::optional<double> value_of(const Number& number, std::size_t set);

/// The share of the draws of (b) with such a value: of a statement those in which it is true, of a
/// number those with any value; none for what is not drawn.
std::optional<double> share_with_value(const Number& number, std::size_t set);

}  // namespace rotor
