#include "figures/input/toml_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include "figures/data/text.hpp"

namespace rotor {
namespace {

/// The line on which brackets are nested deeper, or keys have more dots, than any scene needs, and
/// than the parser's recursion stands; 0 if there is none. Quotes are not looked at: no text needs
/// that many either. Lines of comment are left out, but for what may be a line of a longer text.
int line_that_nests_too_deep(const std::string& text) {
  constexpr int deepest = 200;
  const auto has = [&](const char* marks) { return text.find(marks) != std::string::npos; };
  const bool has_long_texts = has(R"(""")") || has("'''");
  std::istringstream lines(text);
  int number = 1, brackets = 0;
  for (std::string line; std::getline(lines, line); ++number) {
    const bool is_comment = line.find_first_not_of(" \t") == line.find('#');
    if (is_comment && !has_long_texts) continue;
    int dots = 0;
    for (const char c : line) {
      brackets = std::max(0, brackets + (c == '[' || c == '{') - (c == ']' || c == '}'));
      dots = c == '.' ? dots + 1 : c == ',' || c == '=' ? 0 : dots;
      if (brackets > deepest || dots > deepest) return number;
    }
  }
  return 0;
}

}  // namespace

TomlFile::TomlFile(std::filesystem::path file) : file_(std::move(file)) {
  const std::string text = content();
  if (const int line = line_that_nests_too_deep(text); line > 0)
    throw InputError(
        fmt::format("{}:{}: is nested deeper than any scene needs", file_.string(), line));
  try {
    root_ = toml::parse(text, file_.string());
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: {}", file_.string(), error.source().begin.line,
                                 one_line(error.description())));
  }
}

std::string TomlFile::content() const {
  constexpr std::uintmax_t most = 1U << 20U;
  std::error_code error;
  const auto refuse = [&](std::string_view reason) {
    throw InputError(fmt::format("{}: cannot be read: {}",
                                 file_.empty() ? "a scene file without a name" : file_.string(),
                                 reason));
  };
  const auto status = std::filesystem::status(file_, error);
  if (!std::filesystem::exists(status)) refuse("there is no such file");
  if (!std::filesystem::is_regular_file(status)) refuse("it is no regular file");
  if (std::filesystem::file_size(file_, error) > most)
    refuse(fmt::format("it is larger than {} bytes", most));
  std::ifstream stream(file_, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) refuse("reading it fails");
  return text;
}

void TomlFile::fail(const toml::node& at, std::string_view key, std::string_view message) const {
  throw InputError(
      fmt::format("{}:{}: {}: {}", file_.string(), at.source().begin.line, shown(key), message));
}

void TomlFile::expect_keys(const toml::table& table, const Keys& allowed) const {
  for (const auto& [key, node] : table)
    if (std::find(allowed.begin(), allowed.end(), key.str()) == allowed.end())
      fail(node, key.str(),
           fmt::format("unknown key{}; allowed here: {}",
                       suggestion(key.str(), {allowed.begin(), allowed.end()}),
                       fmt::join(allowed, ", ")));
}

std::optional<double> TomlFile::number(const toml::node& node) {
  if (const auto* const whole = node.as_integer()) return static_cast<double>(whole->get());
  return node.value<double>();
}

std::optional<std::string> TomlFile::text(const toml::table& in, std::string_view key) const {
  auto found = value<std::string>(in, key, "a string in quotes");
  if (found && *found != one_line(*found))
    fail(*in.get(key), key,
         fmt::format("must be one line, without control characters; not \"{}\"", shown(*found)));
  return found;
}

std::optional<double> TomlFile::time(const toml::table& in, std::string_view key) const {
  const auto found = value<double>(in, key, "a number (s)");
  if (found && !(std::isfinite(*found) && *found >= 0))
    fail(*in.get(key), key, fmt::format("must be a finite number not below 0 s, not {}", *found));
  return found;
}

const toml::table& TomlFile::table(const toml::table& in, std::string_view key) const {
  static const toml::table empty;
  const toml::node* node = in.get(key);
  if (!node) return empty;
  if (!node->is_table()) fail(*node, key, "must be a table");
  return *node->as_table();
}

std::vector<const toml::table*> TomlFile::tables(const toml::table& in,
                                                 std::string_view key) const {
  std::vector<const toml::table*> all;
  const toml::node* node = in.get(key);
  if (!node) return all;
  const toml::array* array = node->as_array();
  if (!array || !array->is_array_of_tables())
    fail(*node, key, fmt::format("must be given as [[{}]]", key));
  for (const toml::node& item : *array) all.push_back(item.as_table());
  return all;
}

}  // namespace rotor
