/// The wrong changes of `make mutants` are changes of what there is.
#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace rotor {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::string file_text(const std::string& name) {
  std::ifstream file(ROTOR_SOURCES "/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string without_spaces(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
  return text;
}

/// The cells of a line, as the tool takes them apart.
std::vector<std::string> cells_of(std::string line) {
  const std::string mark = line.find(" @ ") == std::string::npos ? "@" : " @ ";
  std::vector<std::string> cells;
  for (std::size_t end; cells.size() < 3 && (end = line.find(mark)) != std::string::npos;
       line = line.substr(end + mark.size()))
    cells.push_back(trimmed(line.substr(0, end)));
  cells.push_back(trimmed(line));
  return cells;
}

TEST(WrongChanges, ReplaceWhatStandsInTheirFiles) {
  std::ifstream list(ROTOR_SOURCES "/verification/robustness/mutants.txt");
  int changes = 0;
  for (std::string line; std::getline(list, line);) {
    if (line.starts_with('#')) continue;
    const auto cells = cells_of(line);
    ASSERT_EQ(cells.size(), 4U) << line;
    const std::string text = file_text(cells[0]);
    // In the copy in which a text is replaced, that change is to be found by what it breaks.
    const bool is_source = cells[0].ends_with("pp");
    EXPECT_TRUE(text.find(cells[1]) != std::string::npos ||
                (!is_source && text.find(cells[2]) != std::string::npos))
        << line;
    ++changes;
  }
  EXPECT_GE(changes, 130);
}

// Or what is said of them is said of nothing any more.
TEST(EquivalentChanges, ReplaceWhatStandsInTheirFiles) {
  std::ifstream list(ROTOR_SOURCES "/verification/robustness/equivalent.txt");
  for (std::string line; std::getline(list, line);) {
    if (line.starts_with('#')) continue;
    const auto cells = cells_of(line);
    ASSERT_EQ(cells.size(), 4U) << line;
    EXPECT_NE(without_spaces(file_text(cells[0])).find(without_spaces(cells[1])), std::string::npos)
        << line;
  }
}

}  // namespace
}  // namespace rotor
