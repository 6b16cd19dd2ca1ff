#include "verification/paper/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/support/pattern.hpp"

namespace rotor {
namespace {

bool is_statement(const Number& number) { return words_of(number) != number.says; }

bool is_tiny(double size) { return size != 0 && size < 1e-6; }

/// With so many digits, but never in powers of ten.
std::string rounded(double value, int digits) {
  const double size = std::abs(value);
  if (size < std::pow(10, digits)) return fmt::format("{:.{}g}", value, digits);
  const double unit = std::pow(10, std::floor(std::log10(size)) - digits + 1);
  return fmt::format("{:.0f}", std::round(value / unit) * unit);
}

/// Those of the largest result over all values of a continuous quantity depend on the angle of the
/// rotor at the loss.
int digits_of(const Number& number) {
  if (number.kind == Kind::extreme) return 2;
  return number.printed.empty() ? 3 : 4;
}

std::string with_unit(const std::string& text, const Number& number) {
  return number.unit.empty() ? text : text + ' ' + number.unit;
}

}  // namespace

std::string words_of(const Number& number) {
  return replaced(number.says, " \\((1: yes|0: no)\\)", "");
}

std::string shown(const std::optional<double>& value, const Number& number) {
  if (!value || !std::isfinite(*value)) return "none";
  if (is_statement(number)) return *value == 1 ? "yes" : "no";
  const double size = std::abs(*value);
  const bool in_powers = number.printed.find('e') != std::string::npos;
  return with_unit(is_tiny(size) && !in_powers              ? "below 1e-06"
                   : size != 0 && size < 1e-3 && !in_powers ? "below 0.001"
                   : in_powers && size < 1e-2               ? fmt::format("{:.2e}", *value)
                                                            : rounded(*value, digits_of(number)),
                   number);
}

std::string printed(const Number& number) {
  if (is_statement(number)) return shown(std::stod(number.printed), number);
  return number.printed.empty() ? number.rule : with_unit(number.printed, number);
}

std::string rule_of(const Number& number) {
  const Allowed allowed = number.allowed();
  const std::string_view judged = number.is_drawn() ? "" : ", at the inputs as printed";
  const std::string limits =
      number.rule == "is"      ? printed(number)
      : number.rule == "major" ? fmt::format("at least {:g} {}", allowed.least(), number.unit)
      : number.printed.empty() && number.rule != "few"
          ? fmt::format("at most {:g} {}", allowed.greatest(), number.unit)
          : with_unit(fmt::format("{:.6g} to {:.6g}", allowed.least(), allowed.greatest()), number);
  return fmt::format("{}: {}{}", number.rule, limits, judged);
}

std::string range_of(const Stored& stored) {
  const Spread& spread = stored.spread;
  if (!std::isfinite(spread.low) || spread.draws == 0) return "";
  return is_tiny(std::max(-spread.low, spread.high))
             ? "below 1e-06"
             : fmt::format("{:.4g} to {:.4g}", spread.low, spread.high);
}

std::string deviation(const std::optional<double>& value, const Number& number) {
  const bool is_number = !number.printed.empty() && !is_statement(number) && number.rule != "range";
  if (!is_number || !value || !std::isfinite(*value) || std::stod(number.printed) == 0) return "";
  return fmt::format("{:+.2g} %", 100 * (*value / std::stod(number.printed) - 1));
}

std::optional<double> value_of(const Number& number, std::size_t set) {
  const Reading::InSet& in = number.readings[number.decides[set]].in[set];
  return number.kind == Kind::method && in.by_rk4 ? in.by_rk4 : in.converged;
}

std::optional<double> share_with_value(const Number& number, std::size_t set) {
  if (!number.is_drawn()) return std::nullopt;
  const Stored& b = number.readings[number.decides[set]].in[set].b;
  return is_statement(number) ? b.holds : b.spread.valued;
}

}  // namespace rotor
