/// A TOML file whose errors name the line.
#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "figures/input/scenario_spec.hpp"

namespace rotor {

class TomlFile {
 public:
  using Keys = std::vector<std::string_view>;

  /// Reads and parses a file or a pipe of bounded size. All functions throw InputError.
  explicit TomlFile(const std::filesystem::path& file);
  /// Parses the content of a file that messages refer to by `name`.
  TomlFile(std::filesystem::path name, std::string content);

  const toml::table& root() const { return root_; }
  const std::filesystem::path& path() const { return file_; }
  const std::string& content() const { return content_; }

  template <class... Args>
  [[noreturn]] void fail(const toml::node& at, std::string_view key,
                         fmt::format_string<Args...> text, Args&&... args) const {
    refuse(at, key, fmt::format(text, std::forward<Args>(args)...));
  }
  /// Of a key that the table has.
  template <class... Args>
  [[noreturn]] void fail_at(const toml::table& in, std::string_view key,
                            fmt::format_string<Args...> text, Args&&... args) const {
    refuse(*in.get(key), key, fmt::format(text, std::forward<Args>(args)...));
  }

  void expect_keys(const toml::table& table, const Keys& allowed) const;

  template <class T>
  std::optional<T> value(const toml::table& in, std::string_view key, std::string_view kind) const {
    const toml::node* node = in.get(key);
    if (!node) return std::nullopt;
    std::optional<T> found;
    if constexpr (std::is_same_v<T, double>)
      found = number(*node);
    else if (node->is_boolean() == std::is_same_v<T, bool>)
      found = node->value<T>();
    const auto text = node->value<std::string>();
    if (!found)
      fail(*node, key, "must be {}{}", kind, text ? fmt::format(", not \"{}\"", shown(*text)) : "");
    return found;
  }
  /// The node as a double, if it is a number, whole or not.
  static std::optional<double> number(const toml::node& node);
  /// One line without control characters, because messages and pictures show it.
  std::optional<std::string> text(const toml::table& in, std::string_view key) const;
  /// A text with which rows of CSV may begin.
  std::optional<std::string> name(const toml::table& in) const;
  /// A time in seconds: finite and not below zero.
  std::optional<double> time(const toml::table& in, std::string_view key) const;
  /// The sub-table of that name, empty if there is none.
  const toml::table& table(const toml::table& in, std::string_view key) const;
  std::vector<const toml::table*> tables(const toml::table& in, std::string_view key) const;

  /// Calls a function, and adds file, line and key to the error that it throws.
  template <class F>
  auto at(const toml::node& node, std::string_view key, F parse) const {
    try {
      return parse();
    } catch (const std::exception& error) {
      fail(node, key, "{}", error.what());
    }
  }

 private:
  [[noreturn]] void refuse(const toml::node& at, std::string_view key,
                           std::string_view reason) const;

  std::filesystem::path file_;
  std::string content_;
  toml::table root_;
  mutable Keys keys_of_root_;  ///< once they have been checked
};

/// What a table states of a scenario, beside `other_keys`. Throws InputError with file, line and
/// key.
ScenarioSpec stated_in(const TomlFile& file, const toml::table& table,
                       const TomlFile::Keys& other_keys);

}  // namespace rotor
