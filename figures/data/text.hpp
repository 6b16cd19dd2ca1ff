/// What messages make of texts that users give, and of times.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rotor {

/// The text, or its beginning if it is longer than a message should repeat, control characters made
/// visible.
std::string shown(std::string_view text);

/// The same as one line, however long.
std::string one_line(std::string_view text);

/// Says on standard error what is no result; where nothing can be written, nobody is told.
void tell(std::string_view text);

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
