/// Texts and times as messages show them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rotor {

/// The text as one line that may be shown anywhere: control characters are made visible. What is
/// such a line already stays as it is.
std::string one_line(std::string_view text);

/// The same, or its beginning if it is longer than a message should repeat.
std::string shown(std::string_view text);

/// Prints a message on standard error, in one line. A failure to write it is ignored.
void print_message(std::string_view message);

/// All of the text as a number, without anything around it.
std::optional<double> number_in(const std::string& text);
/// An error message for a text that is no number; empty if it is one.
std::string unless_number(const std::string& text);

/// "; did you mean NAME?" if one of the names is what was probably meant, or nothing.
std::string suggestion(std::string_view mistyped, const std::vector<std::string>& names);

/// A time, in seconds, minutes, hours or days.
std::string duration(double seconds);

/// The remaining time at the present rate.
double time_to_go_s(double elapsed_s, double done, double all);

}  // namespace rotor
