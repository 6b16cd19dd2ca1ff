#include "figures/scenes/scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "figures/data/text.hpp"
#include "figures/scenes/toml_file.hpp"

namespace rotor {
namespace {

class SceneReader : TomlFile {
 public:
  SceneReader(const std::filesystem::path& file, const Scenario& defaults)
      : TomlFile(file), defaults_(defaults) {}

  Scene read() {
    const toml::table& root = this->root();
    expect_keys(root, {"title", "columns", "window", "parameters", "run"});
    Scene scene;
    scene.title = text(root, "title").value_or("");
    scene.columns = columns(root);
    const Scenario base = scenario(table(root, "parameters"), defaults_, {});
    scene.runs = runs(root, base);
    scene.window = window(root, scene);
    return scene;
  }

 private:
  std::vector<const Column*> columns(const toml::table& root) const {
    const toml::node* node = root.get("columns");
    if (!node) return {all_columns_as_vector()};
    std::vector<std::string> names;
    if (const toml::array* array = node->as_array())
      for (const toml::node& item : *array) names.push_back(item.value_or<std::string>(""));
    if (names.empty()) fail(*node, "columns", "must be a list of names of columns, in quotes");
    if (names.front() != "time_s" || names.size() == 1)
      fail(*node, "columns", "must begin with \"time_s\" and have another column");
    return at(*node, "columns", [&] { return parse_columns(names); });
  }

  static std::vector<const Column*> all_columns_as_vector() {
    std::vector<const Column*> all;
    for (const Column& column : all_columns()) all.push_back(&column);
    return all;
  }

  /// The scenario that a table states, on top of another one.
  Scenario scenario(const toml::table& in, Scenario base, Keys other_keys) const {
    Keys allowed = std::move(other_keys);
    for (const Quantity& quantity : quantities()) allowed.push_back(quantity.name);
    allowed.insert(allowed.end(), {"no_separation", "equations", "method"});
    expect_keys(in, allowed);

    for (const Quantity& quantity : quantities())
      if (const auto number = value<double>(in, quantity.name, quantity.range())) {
        if (!quantity.allows(*number))
          fail(*in.get(quantity.name), quantity.name,
               fmt::format("must be {}, not {}", quantity.range(), *number));
        quantity.in(base) = *number;
      }
    if (const auto none = value<bool>(in, "no_separation", "true or false"))
      base.parameters.separates = !*none;
    if (const auto name = text(in, "equations"))
      base.equations =
          at(*in.get("equations"), "equations", [&] { return parse_equations(*name); });
    if (const auto name = text(in, "method"))
      base.method = at(*in.get("method"), "method", [&] { return parse_method(*name); });
    return base;
  }

  const Scenario& checked(const toml::node& node, std::string_view key,
                          const Scenario& scenario) const {
    at(node, key, [&] { return check(scenario), true; });
    return scenario;
  }

  std::vector<SceneRun> runs(const toml::table& root, const Scenario& base) const {
    const toml::node* parameters = root.get("parameters");
    const auto tables = this->tables(root, "run");
    if (tables.empty())
      return {{"run", checked(parameters ? *parameters : root, "parameters", base)}};
    std::vector<SceneRun> all;
    for (const toml::table* table : tables) {
      const auto name = text(*table, "name");
      if (!name || name->empty()) fail(*table, "name", "every [[run]] needs a name");
      const auto same = [&](const SceneRun& run) { return run.name == *name; };
      if (std::any_of(all.begin(), all.end(), same))
        fail(*table, "name", fmt::format("there is a run \"{}\" already", shown(*name)));
      all.push_back({*name, checked(*table, "run", scenario(*table, base, {"name"}))});
    }
    return all;
  }

  Window window(const toml::table& root, const Scene& scene) const {
    double shortest = scene.runs.front().scenario.until;
    for (const SceneRun& run : scene.runs) shortest = std::min(shortest, run.scenario.until);

    const toml::table& in = table(root, "window");
    expect_keys(in, {"from_s", "until_s", "from", "length_s"});
    if (const auto from = text(in, "from")) {
      if (*from != "rolling_onset") fail(*in.get("from"), "from", "must be \"rolling_onset\"");
      const auto length = time(in, "length_s");
      if (!length || in.size() != 2)
        fail(in, "window", "from goes with length_s, and nothing else");
      return {.from_rolling_onset = true, .length_s = *length};
    }
    if (in.contains("length_s")) fail(in, "window", "length_s goes with from");
    const double from = time(in, "from_s").value_or(0);
    const double until = time(in, "until_s").value_or(shortest);
    if (from >= until || until > shortest)
      fail(in.empty() ? static_cast<const toml::node&>(root) : *root.get("window"), "window",
           fmt::format(
               "must lie inside the run, with 0 <= from_s < until_s <= {} s; it goes from {} "
               "s to {} s",
               shortest, from, until));
    return {.from_s = from, .length_s = until - from};
  }

  Scenario defaults_;
};

}  // namespace

Scene read_scene(const std::filesystem::path& file, const Scenario& defaults) {
  return SceneReader(file, defaults).read();
}

std::vector<const Column*> parse_columns(const std::vector<std::string>& names) {
  std::vector<const Column*> columns;
  for (const std::string& name : names) {
    const Column* column = find_column(name);
    if (!column) {
      std::vector<std::string> allowed;
      for (const Column& known : all_columns()) allowed.emplace_back(known.name);
      throw InputError(fmt::format("there is no column \"{}\"{}; there are: {}", shown(name),
                                   suggestion(name, allowed), fmt::join(allowed, ", ")));
    }
    columns.push_back(column);
  }
  return columns;
}

}  // namespace rotor
