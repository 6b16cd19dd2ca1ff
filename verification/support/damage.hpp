/// What may happen to a row of results or of a journal.
#pragma once

#include <random>
#include <string>
#include <vector>

namespace rotor {

/// Where the rows below the header row start, and the end of the last one.
inline std::vector<std::size_t> starts_of_rows(const std::string& text) {
  std::vector<std::size_t> all;
  for (std::size_t at = 0, end = 0; (end = text.find('\n', at)) != std::string::npos; at = end + 1)
    if (text[at] != '#') all.push_back(end + 1);
  return all;
}

inline constexpr int kinds_of_damage = 13;

/// The text after something has happened to its row n, which starts at starts[n].
inline std::string damaged(const std::string& text, const std::vector<std::size_t>& starts,
                           std::size_t n, int kind, std::mt19937& random) {
  const auto row_at = [&](std::size_t i) {
    return text.substr(starts[i], starts[i + 1] - starts[i] - 1);
  };
  const std::string before = text.substr(0, starts[n]), after = text.substr(starts[n + 1]);
  const std::string other = row_at(n > 0 ? n - 1 : 1),
                    input = row_at(n).substr(0, row_at(n).find(','));
  std::string row = row_at(n);
  const std::size_t at = random() % row.size();
  switch (kind) {
    case 0:  // the row is lost
      return before + after;
    case 1:  // it is there twice
      return before + row + '\n' + row + '\n' + after;
    case 2:  // it is another one
      return before + other + '\n' + after;
    case 3:  // it has the results of its neighbour
      return before + input + other.substr(other.find(',')) + '\n' + after;
    case 4:  // it is cut
      return before + row.substr(0, at) + '\n' + after;
    case 5:  // and with it all that follows
      return before + row.substr(0, at);
    case 6:  // it has no line end
      return before + row + after;
    case 7:
      return before + row + "\r\n" + after;
    case 8:
      return before + "garbage,hello\n" + after;
    case 9:
      return before + input + ",garbage,hello\n" + after;
    case 10:  // as power cuts leave it
      return before + row.substr(0, at) + std::string(row.size() - at, '\0') + '\n' + after;
    case 11:
      row[at] = static_cast<char>(1 + random() % 9);  // control characters
      return before + row + '\n' + after;
    default: {
      char& digit =
          row[row.find_last_of("0123456789", row.size() - 1 - random() % (row.size() / 2))];
      digit = digit == '7' ? '3' : '7';
      return before + row + '\n' + after;
    }
  }
}

}  // namespace rotor
