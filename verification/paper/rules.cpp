#include "verification/paper/rules.hpp"

#include <algorithm>
#include <stdexcept>

namespace rotor {
namespace {

double number_of(const std::string& printed) {
  std::size_t length = 0;
  const double value = std::stod(printed, &length);
  if (length != printed.size()) throw std::invalid_argument("is no number: " + printed);
  return value;
}

}  // namespace

double half_digit(const std::string& printed, bool zeros_count) {
  const std::size_t exponent = printed.find('e');
  const std::string digits = printed.substr(0, exponent);
  const double scale =
      exponent == std::string::npos ? 1 : std::pow(10, number_of(printed.substr(exponent + 1)));
  if (zeros_count && digits.find('.') == std::string::npos) return scale / 2;
  const std::size_t point = digits.find('.');
  if (point != std::string::npos)
    return scale / 2 * std::pow(10, -static_cast<double>(digits.size() - point - 1));
  // Zeros after the second digit of a whole number do not count.
  const std::size_t last = digits.find_last_not_of('0');
  const std::size_t first = digits.find_first_of("123456789");
  const std::size_t counts = std::min(digits.size() - 1, std::max(last, first + 1));
  return scale / 2 * std::pow(10, static_cast<double>(digits.size() - 1 - counts));
}

bool bounds_a_change(const std::string& rule) {
  return rule == "minor" || rule == "slight" || rule == "agrees" || rule == "negligible";
}

Allowed allowed(const std::string& printed, const std::string& rule, double word_width_factor,
                bool zeros_count) {
  constexpr double about = 0.05;
  const auto half = [zeros_count](const std::string& text) {
    return half_digit(text, zeros_count);
  };
  if (rule == "digits") return {number_of(printed), half(printed)};
  if (rule == "about")
    return {number_of(printed),
            std::max(half(printed), word_width_factor * about * std::abs(number_of(printed)))};
  if (rule == "range") {
    const std::string to = " to ";
    const std::size_t at = printed.find(to);
    if (at == std::string::npos) throw std::invalid_argument("is no range: " + printed);
    const std::string from = printed.substr(0, at), until = printed.substr(at + to.size());
    const double least = number_of(from) - half(from), greatest = number_of(until) + half(until);
    return {(least + greatest) / 2, (greatest - least) / 2};
  }
  if (rule == "is") return {number_of(printed), 0.4999};
  if (rule == "few") return {6, 4 * word_width_factor};
  if (rule == "minor") return {0, 10 * word_width_factor};
  if (rule == "slight" || rule == "agrees") return {0, 5 * word_width_factor};
  if (rule == "negligible") return {0, word_width_factor};
  if (rule == "major") return {100, 50 * word_width_factor, true};
  if (rule == "unchanged") return {0, 1e-6};
  throw std::invalid_argument("there is no rule " + rule);
}

}  // namespace rotor
