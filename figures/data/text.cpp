#include "figures/data/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <boost/locale/utf.hpp>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <sstream>

namespace rotor {
namespace {

/// How many letters must be inserted, removed, replaced or exchanged with their neighbour (Damerau
/// and Levenshtein).
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

/// Number of bytes of the letter in UTF-8 at the start of a text; 0 if there is none, or if XML
/// does not allow it or it is a control character.
std::size_t letter_length(std::string_view text) {
  using Utf8 = boost::locale::utf::utf_traits<char>;
  const char* end = text.data();
  const auto letter = Utf8::decode(end, text.data() + text.size());
  const bool is_control = letter < 0x20 || (letter >= 0x7f && letter < 0xa0);
  return is_control || letter > 0x10ffff || letter == 0xfffe || letter == 0xffff
             ? 0
             : static_cast<std::size_t>(end - text.data());
}

}  // namespace

std::string one_line(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const std::size_t length = letter_length(text);
    line += length > 0 ? std::string(text.substr(0, length))
                       : fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return line;
}

std::string shown(std::string_view text) {
  std::size_t most = 60;
  while (most < text.size() && (static_cast<unsigned char>(text[most]) & 0xc0U) == 0x80U)
    --most;  // never half a letter of several bytes
  return one_line(text.substr(0, most)) + (text.size() > most ? "..." : "");
}

void print_message(std::string_view message) {
  const std::string line = one_line(message) + '\n';
  static_cast<void>(std::fwrite(line.data(), 1, line.size(), stderr));
}

void report_failures(const std::vector<std::string>& failures) {
  for (std::size_t n = 1; n < failures.size(); ++n) print_message("rotor: " + failures[n - 1]);
  if (!failures.empty()) throw std::runtime_error(failures.back());
}

std::optional<double> number_in(const std::string& text) {
  if (text.empty() || text.find_first_not_of("0123456789+-.eE") != std::string::npos)
    return std::nullopt;  // strtod would accept blanks, nan, hexadecimal
  char* end = nullptr;    // libc++ 14 has std::from_chars only for integers
  errno = 0;
  const double value = std::strtod(text.c_str(), &end);
  const bool is_out_of_range = errno == ERANGE && (value == 0 || std::isinf(value));
  const bool whole = end == text.c_str() + text.size();
  return whole && !is_out_of_range ? std::optional(value) : std::nullopt;
}

std::string unless_number(const std::string& text) {
  return number_in(text) ? "" : fmt::format("must be a number, not \"{}\"", shown(text));
}

std::string suggestion(std::string_view mistyped, const std::vector<std::string>& names) {
  constexpr std::size_t longest = 60;
  if (mistyped.empty() || mistyped.size() > longest || names.empty()) return "";
  // A part of a name, without the dashes of an option, or else a slip.
  const std::string_view part =
      mistyped.substr(std::min(mistyped.find_first_not_of('-'), mistyped.size()));
  constexpr std::size_t short_part = 2, most = 4;
  std::vector<std::string> meant;
  if (part.size() > short_part)
    std::copy_if(names.begin(), names.end(), std::back_inserter(meant),
                 [&](const auto& name) { return name.find(part) != std::string::npos; });
  if (meant.empty() || meant.size() > most) {
    meant = {*std::min_element(names.begin(), names.end(), [&](const auto& a, const auto& b) {
      return distance(mistyped, a) < distance(mistyped, b);
    })};
    const std::size_t size = mistyped.size(), near = std::max<std::size_t>(2, size / 3);
    if (distance(mistyped, meant[0]) > std::min(near, size - 1))
      return "";  // any name is near a single letter
  }
  return fmt::format("; did you mean \"{}\"?", fmt::join(meant, "\" or \""));
}

std::string choices(std::string_view mistyped, const std::vector<std::string>& names,
                    std::string_view many) {
  constexpr std::size_t most = 12;
  if (std::string meant = suggestion(mistyped, names); !meant.empty()) return meant;
  return names.size() > most ? fmt::format("; {}", many)
                             : fmt::format("; there are: {}", fmt::join(names, ", "));
}

std::string wrapped(std::string text, const std::string& meaning, std::size_t most) {
  const std::size_t indent = text.size();
  std::istringstream words(meaning);
  std::size_t used = indent;
  for (std::string word; words >> word; used += 1 + word.size(), text += ' ' + word)
    if (used + 1 + word.size() > most) {
      text += '\n' + std::string(indent, ' ');
      used = indent;
    }
  return text + '\n';
}

std::string duration(double seconds) {
  if (seconds < 1) return fmt::format("{:.1g} s", seconds);
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 172'800) return fmt::format("{:.0f} h", seconds / 3600);
  return fmt::format("{:.3g} days", seconds / 86'400);
}

}  // namespace rotor
