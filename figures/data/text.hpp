/// Texts and times as messages show them.
#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rotor {

/// The text as one line that may be shown anywhere: control characters, and bytes that are not
/// UTF-8, are made visible. A line without any does not change.
std::string one_line(std::string_view text);

/// `one_line()` shortened for messages.
std::string shown(std::string_view text);

/// Prints a message on standard error, in one line. A failure to write it is ignored.
void print_message(std::string_view message);
/// Prints all of them but the last, which it throws as std::runtime_error; nothing if there are
/// none.
void report_failures(const std::vector<std::string>& failures);

/// The text as a number, if it is one from end to end, and one that a double can hold.
std::optional<double> number_in(const std::string& text);
/// An error message for a text that is not a number; empty for a number.
std::string unless_number(const std::string& text);

/// "; did you mean "NAME"?" if one of the names was probably meant, or some of which it is a part;
/// otherwise empty.
std::string suggestion(std::string_view mistyped, const std::vector<std::string>& names);
/// `suggestion()`, but if that is empty "; there are: " and all names, or "; " and what lists them
/// if they are many.
std::string choices(std::string_view mistyped, const std::vector<std::string>& names,
                    std::string_view many);

template <class Values, class Value>
bool contains(const Values& values, const Value& value) {
  return std::find(std::begin(values), std::end(values), value) != std::end(values);
}

/// The text with words after it, and further lines below its end, of at most so many columns.
std::string wrapped(std::string text, const std::string& meaning, std::size_t most = 79);

/// A time, in seconds, minutes, hours or days.
std::string duration(double seconds);

}  // namespace rotor
