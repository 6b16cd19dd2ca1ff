/// Regular expressions of ECMAScript. The standard's take a compiler four seconds in each source
/// that uses them: these are compiled once.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace rotor {

/// A match, and its groups after it.
using Match = std::vector<std::string>;

std::vector<Match> matches(const std::string& text, const std::string& pattern);

/// The text with each match replaced: by a format such as "$1 m", or by what a function returns.
std::string replaced(const std::string& text, const std::string& pattern, const std::string& by);
std::string replaced(const std::string& text, const std::string& pattern,
                     const std::function<std::string(const Match&)>& by);

}  // namespace rotor
