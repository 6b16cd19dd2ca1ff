#include "figures/runs/scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

#include "figures/input/toml_file.hpp"

namespace rotor {
namespace {

class SceneReader : TomlFile {
 public:
  SceneReader(const std::filesystem::path& file, Overrides overrides, RunUps& run_ups)
      : TomlFile(file), overrides_(std::move(overrides)), run_ups_(run_ups) {}

  Scene read() {
    const toml::table& root = this->root();
    if (root.empty()) fail(root, "scene", "states nothing");
    if (root.contains("axis") || root.contains("sample"))
      throw InputError("{}: is a sweep, which rotor sweep runs", path().string());
    for (const toml::table* in : {&root, &table(root, "parameters")})
      for (const char* key : {"stop_on", "budget"})
        if (in->contains(key))
          fail_at(*in, key, "is no key of a scene; rotor run has the option {}", option_of(key));
    expect_keys(root, {"title", "columns", "window", "parameters", "run"});
    Scene scene;
    scene.file = path();
    scene.title = text(root, "title").value_or("");
    scene.columns = columns(root);
    scene.runs = runs(
        root,
        stated_in(*this, table(root, "parameters"), {}).overridden_by(overrides_.of_parameters));
    if (!overrides_.run.empty()) leave_out_others(scene.runs);
    for (SceneRun& run : scene.runs) run.name += overridden_[run.name];
    scene.window = window(root, scene);
    return scene;
  }

 private:
  std::vector<const Column*> columns(const toml::table& root) const {
    const toml::node* node = root.get("columns");
    if (!node) return all_columns();
    std::vector<std::string> names;
    if (const toml::array* array = node->as_array())
      for (const toml::node& item : *array) names.push_back(item.value_or<std::string>(""));
    if (names.empty() || contains(names, ""))
      fail(*node, "columns", "must be a list of names of columns, in quotes");
    if (names.front() != "time_s" || names.size() == 1)
      fail(*node, "columns", "must start with \"time_s\" and have another column");
    return at(*node, "columns", [&] { return parse_columns(names); });
  }

  /// A refusal blames an option among its inputs, a key of the [[run]], or a parameter.
  SceneRun run(const std::string& name, const ScenarioSpec& stated, const toml::table& own) {
    const ScenarioSpec all = stated.overridden_by(overrides_.of_runs);
    try {
      return {name, scenario_of(all, run_ups_), all};
    } catch (const ScenarioError& error) {
      const std::vector<std::string> inputs = error.message().inputs();
      for (const std::string& input : inputs)
        if (overrides_.of_runs.states(input) || overrides_.of_parameters.states(input))
          throw InputError("{}, with {}: {}", option_of(input), path().string(), error.what());
      for (const toml::table* in : {&own, &table(root(), "parameters")})
        for (const std::string& input : inputs)
          if (in->contains(input)) fail_at(*in, input, "{}", error.what());
      fail(own.empty() ? root() : own, name, "{}", error.what());
    }
  }

  std::vector<SceneRun> runs(const toml::table& root, const ScenarioSpec& base) {
    const auto tables = this->tables(root, "run");
    if (tables.empty()) return {run("run", base, table(root, "parameters"))};
    std::vector<SceneRun> all;
    for (const toml::table* table : tables) {
      const auto name = this->name(*table);
      if (!name || name->empty()) fail(*table, "name", "every [[run]] needs a name");
      const auto same = [&](const SceneRun& other) { return other.name == *name; };
      if (std::any_of(all.begin(), all.end(), same))
        fail(*table, "name", "there is a run \"{}\" already", shown(*name));
      const ScenarioSpec own = stated_in(*this, *table, {"name"});
      overridden_[*name] = overridden_in(own);
      all.push_back(run(*name, base.overridden_by(own), *table));
    }
    return all;
  }

  /// What options change in what a [[run]] states itself, and perhaps its name.
  std::string overridden_in(const ScenarioSpec& own) const {
    const ScenarioSpec& options = overrides_.of_runs;
    std::string all;
    for (const auto& [name, number] : options.numbers)
      for (const auto& [lower, ignored] : own.numbers)
        if (determined_by(lower) == determined_by(name))
          all += fmt::format(", but {} = {}", name, number);
    if (own.states_equations() && options.states_equations()) all += ", but other equations";
    if (own.method && options.method) all += ", but another method";
    return all;
  }

  void leave_out_others(std::vector<SceneRun>& runs) const {
    std::vector<std::string> names;
    for (const SceneRun& run : runs) names.push_back(run.name);
    std::erase_if(runs, [&](const SceneRun& run) { return run.name != overrides_.run; });
    if (runs.empty())
      throw InputError("--run {}: there is no such run in {}{}", shown(overrides_.run),
                       path().string(),
                       choices(overrides_.run, names, "rotor run without --run lists them"));
  }

  /// Whether options may move the end: --until, or others if the scene does not state the end.
  bool may_end_elsewhere(const SceneRun& run) const {
    const ScenarioSpec& options = overrides_.of_runs;
    return run.stated.numbers.contains("until")
               ? options.numbers.contains("until")
               : !options.numbers.empty() || options.loses_mass.has_value();
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
        fail(in, "window", "from needs length_s, and excludes other keys");
      return {.from_rolling_onset = true, .length_s = *length};
    }
    if (in.contains("length_s")) fail(in, "window", "length_s needs from");
    const double from =
        time(in, "from_s").value_or(in.empty() ? window_about_loss(scene.runs).from_s : 0);
    const auto stated_until = time(in, "until_s");
    const double until = stated_until.value_or(shortest);
    // A run whose end was moved by options may end before the window does.
    const bool lies_in_runs =
        std::all_of(scene.runs.begin(), scene.runs.end(), [&](const SceneRun& run) {
          const double end_s = run.scenario.until;
          return (from < end_s && until <= end_s) || may_end_elsewhere(run);
        });
    if (!lies_in_runs || (stated_until && from >= until))
      fail(in.empty() ? static_cast<const toml::node&>(root) : *root.get("window"), "window",
           "must lie inside the run, with 0 <= from_s < until_s <= {} s; it extends from {} s to "
           "{} s",
           shortest, from, until);
    if (!stated_until) return {.from_s = from};  // to the end of each run
    return {.from_s = from, .length_s = until - from};
  }

  Overrides overrides_;
  RunUps& run_ups_;
  std::map<std::string, std::string> overridden_;  ///< by the runs' names
};

}  // namespace

std::map<int, std::filesystem::path> figure_files(const std::filesystem::path& folder) {
  std::map<int, std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    const std::size_t digits = std::min(name.size(), std::string_view("fig").size());
    int number = 0;
    std::from_chars(name.data() + digits, name.data() + name.size(), number);
    if (name == fmt::format("fig{:02}.toml", number)) files[number] = entry.path();
  }
  return files;
}

Scene read_scene(const std::filesystem::path& file, const Overrides& overrides, RunUps& run_ups) {
  return SceneReader(file, overrides, run_ups).read();
}

Scene read_scene(const std::filesystem::path& file, const Overrides& overrides) {
  RunUps none;
  return read_scene(file, overrides, none);
}

Window window_about_loss(const std::vector<SceneRun>& runs) {
  constexpr double part_before = 0.05;  // of the time after the mass loss
  double from_s = std::numeric_limits<double>::infinity();
  for (const SceneRun& run : runs) {
    const double loss_s = run.scenario.loses_mass() ? run.scenario.parameters.mass_loss_time : 0;
    from_s = std::min(from_s, std::max(0., loss_s - part_before * (run.scenario.until - loss_s)));
  }
  return {.from_s = from_s};
}

Window stated_window(Window window, std::optional<double> from_s, std::optional<double> until_s,
                     const std::vector<SceneRun>& runs) {
  if (!from_s && !until_s) return window;
  const double until = until_s.value_or(std::numeric_limits<double>::infinity());
  const bool lies_before = window.from_rolling_onset || until <= window.from_s;
  const double from = from_s.value_or(lies_before ? 0 : window.from_s);
  double last_s = 0;
  for (const SceneRun& run : runs) last_s = std::max(last_s, run.scenario.until);
  if (until_s && !(*until_s > 0 && *until_s <= last_s))
    throw InputError("--until {}: must lie between 0 s and {} s, the end of the run", until,
                     last_s);
  for (const SceneRun& run : runs) {
    const double end_s = run.scenario.until;
    if (!(from >= 0 && from < std::min(until, end_s)))
      throw InputError("--from {}: must lie between 0 s and {} s, the end of the run or --until",
                       from, std::min(until, end_s));
  }
  return {.from_s = from, .length_s = until - from};
}

std::vector<const Column*> parse_columns(const std::vector<std::string>& names) {
  std::vector<const Column*> columns;
  for (const std::string& name : names) {
    const Column* column = find_column(name);
    if (!column) {
      std::vector<std::string> allowed;
      for (const Column* known : all_columns()) allowed.emplace_back(known->name);
      throw InputError("there is no column \"{}\"{}", shown(name),
                       choices(name, allowed, "rotor run --columns help lists them"));
    }
    if (contains(columns, column)) throw InputError("duplicate column \"{}\"", name);
    columns.push_back(column);
  }
  return columns;
}

}  // namespace rotor
