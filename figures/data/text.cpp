#include "figures/data/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numeric>

namespace rotor {
namespace {

/// How many letters have to be inserted, removed, replaced or exchanged with their neighbour
/// (Damerau and Levenshtein).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), 0U);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      const std::size_t replaced = last[k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1);
      row[k] = std::min({replaced, last[k] + 1, row[k - 1] + 1});
      if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
        row[k] = std::min(row[k], before[k - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last.back();
}

/// How many bytes the text's first letter has; 0 where it begins with none: with a control
/// character, which terminals obey, or with what is no UTF-8 or may not stand in XML.
std::size_t letter_length(std::string_view text) {
  const auto byte = [&](std::size_t i) -> std::uint32_t {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  if (byte(0) < 0x80) return byte(0) >= 0x20 && byte(0) != 0x7f ? 1 : 0;
  const auto length = static_cast<unsigned>(std::countl_one(static_cast<unsigned char>(text[0])));
  if (length < 2 || length > 4) return 0;
  std::uint32_t letter = byte(0) & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0U) != 0x80U) return 0;
    letter = letter << 6U | (byte(i) & 0x3fU);
  }
  constexpr std::array<std::uint32_t, 5> least = {0, 0, 0xa0, 0x800, 0x10000};  // C1 left out
  const auto is_in = [&](std::uint32_t from, std::uint32_t until) {
    return from <= letter && letter <= until;
  };
  const bool reorders_lines = is_in(0x2028, 0x202e) || is_in(0x2066, 0x2069);
  const bool is_none = is_in(0xd800, 0xdfff) || is_in(0xfffe, 0xffff) || letter > 0x10ffff;
  return letter < least[length] || reorders_lines || is_none ? 0U : length;
}

}  // namespace

std::string one_line(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const std::size_t length = letter_length(text);
    line += length > 0 ? std::string(text.substr(0, length))
                       : fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return line;
}

std::string shown(std::string_view text) {
  std::size_t most = 60;
  while (most < text.size() && (static_cast<unsigned char>(text[most]) & 0xc0U) == 0x80U)
    --most;  // a letter of several bytes is left out whole
  return one_line(text.substr(0, most)) + (text.size() > most ? "..." : "");
}

void tell(std::string_view message) {
  const std::string line = one_line(message) + '\n';
  static_cast<void>(std::fwrite(line.data(), 1, line.size(), stderr));
}

/// All of the text as a number, without anything around it.
std::optional<double> number_in(const std::string& text) {
  if (text.empty() || text.find_first_not_of("0123456789+-.eE") != std::string::npos)
    return std::nullopt;  // which strtod may know: blanks, nan, hexadecimal
  char* end = nullptr;    // libc++ 14 has std::from_chars for integers alone
  errno = 0;
  const double value = std::strtod(text.c_str(), &end);
  const bool vanishes = errno == ERANGE && value == 0;
  const bool whole = end == text.c_str() + text.size();
  return whole && !vanishes ? std::optional(value) : std::nullopt;
}

std::string unless_number(const std::string& text) {
  return number_in(text) ? "" : fmt::format("must be a number, not \"{}\"", shown(text));
}

std::string suggestion(std::string_view mistyped, const std::vector<std::string>& names) {
  constexpr std::size_t longest = 60;
  if (mistyped.size() > longest || names.empty()) return "";
  const auto how_far = [&](const std::string& name) {
    const bool abbreviated = mistyped.size() > 3 && name.find(mistyped) != std::string::npos;
    return abbreviated ? 1 : distance(mistyped, name);
  };
  const auto nearest =
      std::min_element(names.begin(), names.end(),
                       [&](const auto& a, const auto& b) { return how_far(a) < how_far(b); });
  const bool is_near = how_far(*nearest) <= std::max<std::size_t>(2, mistyped.size() / 3);
  return is_near ? fmt::format("; did you mean {}?", *nearest) : "";
}

std::string duration(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 172'800) return fmt::format("{:.0f} h", seconds / 3600);
  return fmt::format("{:.3g} days", seconds / 86'400);
}

double time_to_go_s(double elapsed_s, double done, double all) {
  return elapsed_s * (all - done) / done;
}

}  // namespace rotor
