#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "figures/data/files.hpp"
#include "figures/program/commands.hpp"
#include "figures/results/laws.hpp"
#include "figures/results/run_result.hpp"
#include "figures/sweep/sweep_row.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

/// The sweep file that sweep_head repeats above the results.
std::string sweep_above(const fs::path& results) {
  std::ifstream file(results);
  if (!file) throw InputError("{}: cannot be read", results.string());
  std::string text;
  for (std::string line; file.peek() == '#' && std::getline(file, line);)
    if (line.starts_with("#   ")) text += line.substr(4) + '\n';
  if (file.bad()) throw InputError("{}: cannot be read", results.string());
  if (text.empty())
    throw InputError("{}: must be results of rotor sweep, with the sweep file above them",
                     results.string());
  return text;
}

std::string with_spaces(std::string text) {
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

/// Tics at powers of ten, or at 1, 2 and 5 times them if there are few, by the logarithm.
std::string logarithmic_tics(const Range& range) {
  const double least = std::log10(range.from), greatest = std::log10(range.until);
  std::string tics;
  for (int power = static_cast<int>(std::floor(least)); power <= greatest; ++power)
    for (const int factor : {1, 2, 5}) {
      const double at = power + std::log10(factor);
      if (at < least - 1e-9 || at > greatest + 1e-9 || (factor > 1 && greatest - least > 2))
        continue;
      const std::string label =
          power >= -3 && power < 4
              ? fmt::format("{:.6g}", std::pow(10, at))
              : fmt::format("{}10^{{{}}}", factor > 1 ? fmt::format("{}·", factor) : "", power);
      tics += fmt::format("{}'{}' {}", tics.empty() ? "" : ", ", label, at);
    }
  return tics;
}

/// What gnuplot needs about an axis of numbers: its column, its values, and how to show them.
std::string settings_of(const char* letter, const Axis& axis, long stride) {
  const std::string_view unit = find_input_quantity(axis.quantity)->quantity.unit;
  std::string text = with_spaces(axis.quantity), listed;
  if (text.ends_with(" hz")) text.resize(text.size() - 3);
  if (!unit.empty()) text += fmt::format(", {}", unit);
  for (std::size_t n = 0; n < axis.numbers.size(); ++n)
    listed += fmt::format("{}'{:.4g}' {}", n > 0 ? ", " : "", axis.numbers[n], n);
  return fmt::format(
      "{0}_key = '{1}'; {0}_name = '{2}'; {0}_points = {3}; {0}_stride = {4}; {0}_log = {5}; "
      "{0}_are_listed = {6}; {0}_tics = \"{7}\"\n",
      letter, column_of(axis.quantity), text, axis.points(), stride, axis.range.logarithmic ? 1 : 0,
      listed.empty() ? 0 : 1, axis.range.logarithmic ? logarithmic_tics(axis.range) : listed);
}

/// Whether an axis has numbers to draw along it; a single one only if nothing else is drawn.
bool is_drawn(const Axis& axis, const Sweep& sweep) {
  const auto varies = [](const Axis& other) { return other.names.empty() && other.points() > 1; };
  if (!axis.names.empty() || axis.points() > 1) return axis.names.empty();
  return sweep.sample.over.empty() && std::none_of(sweep.axes.begin(), sweep.axes.end(), varies);
}

/// Axes of numbers, the last one along x, and an axis of names with a panel for each.
std::string settings_of(const Sweep& sweep) {
  std::string text, panels = "panels = 1; of_panel = ''; panel0 = ''\n";
  int numbers = 0, names = 0;
  long stride = sweep.sample.count;
  const std::vector from_the_last(sweep.axes.rbegin(), sweep.axes.rend());
  for (const auto& axis : from_the_last) {
    if (!axis.names.empty()) {
      ++names;
      panels = fmt::format("panels = {}; of_panel = '{}'\n", axis.names.size(),
                           column_of(axis.quantity));
      for (std::size_t n = 0; n < axis.names.size(); ++n)
        panels += fmt::format("panel{} = '{}'\n", n, axis.names[n]);
    } else if (is_drawn(axis, sweep) && (axis.points() > 1 || numbers == 0)) {
      text += settings_of(numbers++ == 0 ? "x" : "y", axis, stride);
    }
    stride *= axis.points();
  }
  if (numbers > 2 || names > 1)
    throw InputError("a picture can show at most two axes of numbers and one of names");
  if (numbers == 0 && sweep.sample.over.empty())
    throw InputError("the sweep has neither an axis of numbers nor a sample to draw");
  return text + panels + fmt::format("dimensions = {}; draws = {}\n", numbers, sweep.sample.count);
}

bool is_number(const std::string& key) {
  static const Json law = laws(Scenario{}), properties = summary_schema()["properties"];
  if (law.contains(key)) return law[key].is_number();
  const std::string types = properties[key].value("type", Json()).dump();
  return types.find("number") != std::string::npos || types.find("integer") != std::string::npos;
}

/// What is drawn beside the outcome.
std::string settings_of_result(const std::string& stated, const Sweep& sweep) {
  const std::vector<std::string> all = sweep.columns.empty() ? result_columns() : sweep.columns;
  const auto has = [&](const std::string& name) { return contains(all, name); };
  const auto number = std::find_if(all.begin(), all.end(), is_number);
  const std::string key = !stated.empty()                  ? stated
                          : has("peak_force_to_rolling_N") ? "peak_force_to_rolling_N"
                          : number != all.end()            ? *number
                                                           : "outcome";
  if (!has(key))
    throw InputError("--column {}: there is no such result{}; there are: {}", shown(key),
                     suggestion(key, all), fmt::join(all, ", "));
  const bool has_axis = std::any_of(sweep.axes.begin(), sweep.axes.end(),
                                    [&](const Axis& axis) { return is_drawn(axis, sweep); });
  if (key == "outcome" ? !has_axis : !is_number(key))
    throw InputError("{}: must be a result with numbers",
                     stated.empty() ? "columns" : "--column " + key);
  return fmt::format("result = '{}'; has_outcome = {}; has_value = {}\n", key,
                     has("outcome") ? 1 : 0, key == "outcome" ? 0 : 1);
}

}  // namespace

void plot_sweep(const PlotOptions& options) {
  const ScenarioSpec& stated = options.equations_and_method;
  if (options.from_s || options.until_s || options.spectrum || stated.states_equations() ||
      stated.method)
    throw InputError("{}: is a sweep; the only options for it are --out and --column",
                     shown(options.file));
  const Drawing drawing(options.file, options.out);
  const bool has_results = fs::path(options.file).extension() == ".csv";
  fs::path source = options.file, results = fs::absolute(options.file);
  if (has_results) {
    source = drawing.file("sweep.toml");
    drawing.write("sweep.toml", sweep_above(options.file));
  }
  const Sweep sweep = read_sweep(source);
  const std::string heading = drawing.heading(sweep.title);
  const std::string settings = settings_of(sweep) + settings_of_result(options.column, sweep) +
                               fmt::format("heading = {}; data = ", numbered(heading));
  if (!has_results) {
    results = drawing.file("sweep.csv");
    try {
      write_sweep(sweep, results.string());
    } catch (const Interrupted&) {
      throw Interrupted(
          "interrupted; no picture has been drawn. rotor sweep --out NAME.csv can resume, and "
          "rotor "
          "plot NAME.csv draws its results");
    }
  }
  drawing.finish(settings + numbered(results.string()) + '\n', "sweep.gp");
  say_what_is_assumed(sweep);
}

}  // namespace rotor
