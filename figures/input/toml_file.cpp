#include "figures/input/toml_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "figures/data/csv.hpp"
#include "figures/data/files.hpp"

namespace rotor {
namespace {

/// The line of a key with too many parts for the parser's recursion; 0 if there is none.
long line_with_a_deep_key(const std::string& text) {
  constexpr int most = 200;
  int dots = 0;
  const auto is_deep = [&](char c) {
    dots = c == '.' ? dots + 1 : c == '=' || c == ',' || c == '\n' ? 0 : dots;
    return dots > most;
  };
  const auto at = std::find_if(text.begin(), text.end(), is_deep);
  return at == text.end() ? 0 : 1 + std::count(text.begin(), at, '\n');
}

/// Of a regular file or a pipe, of bounded size.
std::string content_of(const std::filesystem::path& file) {
  constexpr std::size_t most = 1U << 20U;
  std::error_code error;
  const auto refuse = [&](std::string_view reason) {
    throw InputError("{}: cannot be read: {}",
                     file.empty() ? "a scene file without a name" : file.string(), reason);
  };
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) refuse("there is no such file");
  if (error) refuse(error.message());
  if (!std::filesystem::is_regular_file(status) && !std::filesystem::is_fifo(status))
    refuse("it is neither a file nor a pipe");
  if (contains(std::array{".csv", ".json", ".journal"}, file.extension()))
    throw InputError("{}: holds results, not a scene or a sweep", file.string());
  std::string text = read_file(file, most + 1);
  if (text.size() > most) refuse(fmt::format("it is larger than {} bytes", most));
  return text;
}

/// The keys of inputs.
TomlFile::Keys input_keys() {
  TomlFile::Keys keys = {"no_mass_loss", "digits"};
  keys.insert(keys.end(), varied_inputs().begin(), varied_inputs().end());
  return keys;
}

}  // namespace

TomlFile::TomlFile(const std::filesystem::path& file) : TomlFile(file, content_of(file)) {}

TomlFile::TomlFile(std::filesystem::path name, std::string content)
    : file_(std::move(name)), content_(std::move(content)) {
  if (const long line = line_with_a_deep_key(content_); line > 0)
    throw InputError("{}:{}: a key has more than 200 parts", file_.string(), line);
  try {
    root_ = toml::parse(content_, file_.string());
  } catch (const toml::parse_error& error) {
    const std::string what = one_line(error.description());
    const auto has = [&](const char* text) { return what.find(text) != std::string::npos; };
    throw InputError("{}:{}: {}{}", file_.string(), error.source().begin.line, what,
                     has("value type") || has("'inf'") ? "; text needs quotes" : "");
  }
}

void TomlFile::refuse(const toml::node& at, std::string_view key, std::string_view reason) const {
  const std::string prefix = shown(key) + ": ";
  throw InputError("{}:{}: {}{}", file_.string(), at.source().begin.line,
                   reason.starts_with(prefix) ? "" : prefix, reason);
}

void TomlFile::expect_keys(const toml::table& table, const Keys& allowed) const {
  if (&table == &root_) keys_of_root_ = allowed;
  for (const auto& [key, node] : table)
    if (!contains(allowed, key.str()))
      fail(node, key.str(), "unknown key{}{}",
           contains(input_keys(), key.str())    ? ", which belongs below [parameters]"
           : contains(keys_of_root_, key.str()) ? ", which belongs above the first [table]"
                                                : "",
           choices(name_of_symbol(key.str()), {allowed.begin(), allowed.end()}, list_of_inputs));
}

std::optional<double> TomlFile::number(const toml::node& node) {
  if (const auto* const whole = node.as_integer()) return static_cast<double>(whole->get());
  return node.value<double>();
}

std::optional<std::string> TomlFile::text(const toml::table& in, std::string_view key) const {
  auto found = value<std::string>(in, key, "a string in quotes");
  if (found && *found != one_line(*found))
    fail_at(in, key, "must be one line, without control characters; not \"{}\"", shown(*found));
  return found;
}

std::optional<std::string> TomlFile::name(const toml::table& in) const {
  auto found = text(in, "name");
  if (found && !found->empty() && begins_formula(found->front()))
    fail_at(in, "name", "must not begin with \"{}\": spreadsheets would take it for a formula",
            found->front());
  return found;
}

std::optional<double> TomlFile::time(const toml::table& in, std::string_view key) const {
  const auto found = value<double>(in, key, "a number (s)");
  if (found && !(std::isfinite(*found) && *found >= 0))
    fail_at(in, key, "must be a finite number not below 0 s, not {}", *found);
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
  if (!array || !array->is_array_of_tables()) fail(*node, key, "must be given as [[{}]]", key);
  for (const toml::node& item : *array) all.push_back(item.as_table());
  return all;
}

ScenarioSpec stated_in(const TomlFile& file, const toml::table& table,
                       const TomlFile::Keys& other_keys) {
  TomlFile::Keys allowed = input_keys();
  allowed.insert(allowed.end(), other_keys.begin(), other_keys.end());
  file.expect_keys(table, allowed);

  ScenarioSpec stated;
  for (const auto& [quantity, instead_of, of_start] : input_quantities())
    if (const auto number = file.value<double>(table, quantity.name, quantity.range())) {
      if (!quantity.allows(*number))
        file.fail(*table.get(quantity.name), quantity.name, "must be {}, not {}", quantity.range(),
                  *number);
      stated.numbers.emplace(quantity.name, *number);
    }
  if (const auto none = file.value<bool>(table, "no_mass_loss", "true or false"))
    stated.loses_mass = !*none;
  if (const auto digits = file.value<double>(table, "digits", "a number"))
    stated.digits = file.at(*table.get("digits"), "digits", [&] { return parse_digits(*digits); });
  for (const NamedInput& input : named_inputs())
    if (const auto name = file.text(table, input.name))
      file.at(*table.get(input.name), input.name, [&] { input.state(stated, *name); });
  return stated;
}

}  // namespace rotor
