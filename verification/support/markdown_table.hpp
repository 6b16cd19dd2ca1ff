/// Tables of the project's own pages, which tests hold.
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace rotor {

using Cells = std::vector<std::string>;

/// The rows of all tables of a page that have this heading, cells without blanks and ticks around
/// them.
inline std::vector<Cells> markdown_table(const std::string& page, const std::string& heading) {
  std::istringstream lines(page);
  std::vector<Cells> rows;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(heading)) {
      inside = true;
      std::getline(lines, line);  // the line below the heading
    } else if (inside && line.starts_with('|')) {
      Cells cells;
      std::istringstream stream(line.substr(1));
      for (std::string cell; std::getline(stream, cell, '|');) {
        const std::size_t first = cell.find_first_not_of(" `");
        cells.push_back(first == std::string::npos
                            ? ""
                            : cell.substr(first, cell.find_last_not_of(" `") - first + 1));
      }
      rows.push_back(cells);
    } else {
      inside = false;
    }
  }
  return rows;
}

}  // namespace rotor
