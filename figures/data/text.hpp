/// What messages make of texts that users give, and of times.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rotor {

/// The text as one line that may be shown anywhere: control characters, and bytes that are no
/// letters of UTF-8, are made visible. What is such a line already stays as it is.
std::string one_line(std::string_view text);

/// The same, or its beginning if it is longer than a message should repeat.
std::string shown(std::string_view text);

/// Says on standard error, in one line, what is no result; where nothing can be written, nobody is
/// told.
void tell(std::string_view message);

/// All of the text as a number, without anything around it.
std::optional<double> number_in(const std::string& text);
/// What to say of a text that is none; nothing if it is one.
std::string unless_number(const std::string& text);

/// "; did you mean NAME?" if one of the names is what was probably meant, or nothing.
std::string suggestion(std::string_view mistyped, const std::vector<std::string>& names);

/// A time, in the unit in which one would say it.
std::string duration(double seconds);

/// How long the rest takes if it goes on as the part that is done, which took so long.
double time_to_go_s(double elapsed_s, double done, double all);

}  // namespace rotor
