#include "figures/scenes/scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>

namespace rotor {
namespace {

using Keys = std::vector<std::string_view>;

template <class Kind>
struct Named {
  std::string_view name;
  Kind kind;
};

template <class Kind>
Named(const char*, Kind) -> Named<Kind>;  // which clang 14 does not find itself

constexpr std::array equations_names = {Named{"published", Equations::published},
                                        Named{"consistent", Equations::consistent}};
constexpr std::array method_names = {Named{"event", Method::event}, Named{"rk4", Method::rk4}};

constexpr std::array event_names = {Named{"none", Event::none},
                                    Named{"touch_down", Event::touch_down},
                                    Named{"release", Event::release},
                                    Named{"ring_clear", Event::ring_clear},
                                    Named{"renewed_contact", Event::renewed_contact},
                                    Named{"rolling_onset", Event::rolling_onset},
                                    Named{"slip_reversal", Event::slip_reversal},
                                    Named{"break_away", Event::break_away},
                                    Named{"motor_off", Event::motor_off},
                                    Named{"mass_loss", Event::mass_loss}};

template <class Names>
auto parse_name(const Names& names, std::string_view text) {
  Keys allowed;
  for (const auto& named : names) {
    if (named.name == text) return named.kind;
    allowed.push_back(named.name);
  }
  throw InputError(fmt::format("must be one of: {}; not \"{}\"", fmt::join(allowed, ", "), text));
}

template <class Names, class Kind>
std::string_view find_name(const Names& names, Kind kind) {
  return std::ranges::find(names, kind, &Names::value_type::kind)->name;
}

/// Reads one file, and knows where in it a mistake stands.
class SceneReader {
 public:
  SceneReader(std::filesystem::path file, const Scenario& defaults)
      : file_(std::move(file)), defaults_(defaults) {}

  Scene read() {
    const toml::table root = parse();
    expect_keys(root, {"title", "columns", "window", "parameters", "run"});
    Scene scene;
    scene.title = text(root, "title").value_or("");
    if (scene.title.find('\n') != std::string::npos)
      fail(*root.get("title"), "title", "must be a single line");
    scene.columns = columns(root);
    const Scenario base = scenario(table(root, "parameters"), defaults_, {});
    scene.runs = runs(root, base);
    scene.window = window(root, scene);
    return scene;
  }

 private:
  [[noreturn]] void fail(const toml::node& at, std::string_view key,
                         std::string_view message) const {
    throw InputError(
        fmt::format("{}:{}: {}: {}", file_.string(), at.source().begin.line, key, message));
  }

  toml::table parse() const {
    try {
      return toml::parse_file(file_.string());
    } catch (const toml::parse_error& error) {
      const auto line = error.source().begin.line;
      throw InputError(
          line == 0 ? fmt::format("{}: cannot be read: {}", file_.string(), error.description())
                    : fmt::format("{}:{}: {}", file_.string(), line, error.description()));
    }
  }

  void expect_keys(const toml::table& table, const Keys& allowed) const {
    for (const auto& [key, node] : table)
      if (std::ranges::find(allowed, key.str()) == allowed.end())
        fail(node, key.str(),
             fmt::format("unknown key; allowed here: {}", fmt::join(allowed, ", ")));
  }

  template <class T>
  std::optional<T> value(const toml::table& in, std::string_view key, std::string_view kind) const {
    const toml::node* node = in.get(key);
    if (!node) return std::nullopt;
    std::optional<T> found = node->value<T>();
    if (!found) fail(*node, key, fmt::format("must be {}", kind));
    return found;
  }

  std::optional<std::string> text(const toml::table& in, std::string_view key) const {
    return value<std::string>(in, key, "a string in quotes");
  }

  /// A time, if it is stated: finite and not below zero.
  std::optional<double> time(const toml::table& in, std::string_view key) const {
    const auto found = value<double>(in, key, "a number (s)");
    if (found && !(std::isfinite(*found) && *found >= 0))
      fail(*in.get(key), key, fmt::format("must be a finite number not below 0 s, not {}", *found));
    return found;
  }

  /// The sub-table of that name, empty if there is none.
  const toml::table& table(const toml::table& in, std::string_view key) const {
    static const toml::table empty;
    const toml::node* node = in.get(key);
    if (!node) return empty;
    if (!node->is_table()) fail(*node, key, "must be a table");
    return *node->as_table();
  }

  /// What a function throws without a place is reported at this node.
  template <class F>
  auto at(const toml::node& node, std::string_view key, F parse) const {
    try {
      return parse();
    } catch (const std::exception& error) {
      fail(node, key, error.what());
    }
  }

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
    const toml::node* node = root.get("run");
    const toml::node* parameters = root.get("parameters");
    if (!node) return {{"run", checked(parameters ? *parameters : root, "parameters", base)}};
    const toml::array* array = node->as_array();
    if (!array || !array->is_array_of_tables()) fail(*node, "run", "must be given as [[run]]");
    std::vector<SceneRun> all;
    for (const toml::node& item : *array) {
      const toml::table& table = *item.as_table();
      const auto name = text(table, "name");
      if (!name || name->empty() || name->starts_with('#') ||
          name->find_first_of(",\"\n") != std::string::npos)
        fail(item, "name",
             "every [[run]] needs a name, without commas, quotes, line breaks and # in front");
      if (std::ranges::find(all, *name, &SceneRun::name) != all.end())
        fail(item, "name", fmt::format("there is a run \"{}\" already", *name));
      all.push_back({*name, checked(item, "run", scenario(table, base, {"name"}))});
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

  std::filesystem::path file_;
  Scenario defaults_;
};

}  // namespace

Scene read_scene(const std::filesystem::path& file, const Scenario& defaults) {
  return SceneReader(file, defaults).read();
}

Equations parse_equations(std::string_view name) { return parse_name(equations_names, name); }
Method parse_method(std::string_view name) { return parse_name(method_names, name); }
std::string_view name_of(Equations equations) { return find_name(equations_names, equations); }
std::string_view name_of(Method method) { return find_name(method_names, method); }
std::string_view name_of(Event event) { return find_name(event_names, event); }

std::vector<const Column*> parse_columns(const std::vector<std::string>& names) {
  std::vector<const Column*> columns;
  for (const std::string& name : names) {
    const Column* column = find_column(name);
    if (!column) {
      Keys allowed;
      for (const Column& known : all_columns()) allowed.push_back(known.name);
      throw InputError(
          fmt::format("there is no column \"{}\"; there are: {}", name, fmt::join(allowed, ", ")));
    }
    columns.push_back(column);
  }
  return columns;
}

}  // namespace rotor
