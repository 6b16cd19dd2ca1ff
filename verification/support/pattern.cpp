#include "verification/support/pattern.hpp"

#include <regex>

namespace rotor {

std::vector<Match> matches(const std::string& text, const std::string& pattern) {
  std::vector<Match> all;
  replaced(text, pattern, [&](const Match& match) { return all.push_back(match), ""; });
  return all;
}

std::string replaced(const std::string& text, const std::string& pattern, const std::string& by) {
  return std::regex_replace(text, std::regex(pattern), by);
}

std::string replaced(const std::string& text, const std::string& pattern,
                     const std::function<std::string(const Match&)>& by) {
  const std::regex expression(pattern);
  std::string all;
  auto rest = text.cbegin();
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at) {
    all.append(rest, (*at)[0].first).append(by({at->begin(), at->end()}));
    rest = (*at)[0].second;
  }
  return all.append(rest, text.cend());
}

}  // namespace rotor
