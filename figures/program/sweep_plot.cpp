#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <unordered_map>

#include "figures/data/csv.hpp"
#include "figures/data/files.hpp"
#include "figures/program/commands.hpp"
#include "figures/results/laws.hpp"
#include "figures/results/run_result.hpp"
#include "figures/sweep/sweep_row.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

/// The sweep file that sweep_head repeats above the results, in the same lines.
std::string sweep_above(const fs::path& results) {
  std::ifstream file(results);
  if (!file) throw InputError("{}: cannot be read", results.string());
  std::string text;
  for (std::string line; file.peek() == '#' && std::getline(file, line);)
    text += (line.starts_with("#   ") ? line.substr(4) : "") + '\n';
  if (file.bad()) throw InputError("{}: cannot be read", results.string());
  if (text.find_first_not_of('\n') == std::string::npos)
    throw InputError(
        "{}: must be results of rotor sweep, with the sweep file above them; a run is drawn from "
        "its scene",
        results.string());
  return text;
}

/// Tics at powers of ten, or at 1, 2 and 5 times them if there are few, by the logarithm.
std::string logarithmic_tics(const Range& range, double unit) {
  const double least = std::log10(range.from / unit), greatest = std::log10(range.until / unit);
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

/// The values of an axis in a picture, which repeat over the rows of the results.
struct Places {
  std::vector<double> of;
  long stride;  ///< of equal values, in rows

  double at(long row) const { return of[static_cast<std::size_t>(row / stride) % of.size()]; }
};

/// The axes of a picture: the last one of numbers is x, one before it y, and one of names
/// distinguishes panels.
struct PictureAxes {
  std::vector<Places> numbers;
  Places panels{{0}, 1};
  std::string settings;
  bool is_map() const { return numbers.size() == 2; }
};

/// An axis of numbers: its values or, listed, their numbers; and how gnuplot is to show them.
void add(PictureAxes& axes, const Axis& axis, long stride, bool at_equal_distances) {
  const auto [unit, in_si] = drawn_unit(find_input_quantity(axis.quantity)->quantity.unit);
  std::string text = name_in_words(axis.quantity), listed;
  if (!unit.empty()) text += fmt::format(", {}", unit);
  Places places{{}, stride};
  const bool is_listed = !axis.numbers.empty(), is_logarithmic = axis.range.logarithmic;
  for (long n = 0; n < axis.points(); ++n) {
    const double value = axis.number(n) / in_si;
    places.of.push_back(is_listed && at_equal_distances ? static_cast<double>(n)
                        : is_logarithmic                ? std::log10(value)
                                                        : value);
    if (is_listed) listed += fmt::format("{}'{:.4g}' {}", n > 0 ? ", " : "", value, n);
  }
  const auto [least, greatest] = std::minmax_element(places.of.begin(), places.of.end());
  axes.settings += fmt::format(
      "{0}_name = '{1}'; {0}_least = {2:#}; {0}_greatest = {3:#}; {0}_are_listed = {4}; {0}_tics = "
      "\"{5}\"\n",
      axes.numbers.empty() ? "x" : "y", text, *least, *greatest, is_listed ? 1 : 0,
      is_logarithmic ? logarithmic_tics(axis.range, in_si) : listed);
  axes.numbers.push_back(std::move(places));
}

/// Whether an axis has numbers to draw along it; a single one only if nothing else is drawn.
bool is_drawn(const Axis& axis, const Sweep& sweep) {
  const auto varies = [](const Axis& other) { return other.names.empty() && other.points() > 1; };
  if (!axis.names.empty() || axis.points() > 1) return axis.names.empty();
  const auto last = std::find_if(sweep.axes.rbegin(), sweep.axes.rend(),
                                 [](const Axis& other) { return other.names.empty(); });
  return sweep.sample.over.empty() && &axis == &*last &&
         std::none_of(sweep.axes.begin(), sweep.axes.end(), varies);
}

PictureAxes axes_of(const Sweep& sweep) {
  const auto is_of_numbers = [&](const Axis& axis) { return is_drawn(axis, sweep); };
  const auto numbers = std::count_if(sweep.axes.begin(), sweep.axes.end(), is_of_numbers);
  const auto names = std::count_if(sweep.axes.begin(), sweep.axes.end(),
                                   [](const Axis& axis) { return !axis.names.empty(); });
  if (numbers > 2 || names > 1)
    throw InputError("a picture can show at most two axes of numbers and one of names");
  if (numbers == 0 && sweep.sample.over.empty())
    throw InputError("the sweep has neither an axis of numbers nor a sample to draw");
  PictureAxes axes;
  long stride = sweep.sample.count;
  for (auto axis = sweep.axes.rbegin(); axis != sweep.axes.rend(); ++axis) {
    if (is_of_numbers(*axis)) add(axes, *axis, stride, numbers == 2 || sweep.sample.count > 1);
    if (!axis->names.empty()) axes.panels = {{}, stride};
    for (std::size_t n = 0; n < axis->names.size(); ++n) {
      axes.settings +=
          fmt::format("panel{} = '{}'\n", n,
                      axis->quantity == "equations"
                          ? std::string(equations_in_words(axis->names[n]))
                          : fmt::format("{} {}", name_in_words(axis->quantity), axis->names[n]));
      axes.panels.of.push_back(static_cast<double>(n));
    }
    stride *= axis->points();
  }
  axes.settings += fmt::format("dimensions = {}; draws = {}; panels = {}\n", numbers,
                               sweep.sample.count, axes.panels.of.size());
  return axes;
}

bool is_number(const std::string& key) {
  static const Json law = laws(Scenario{}), properties = summary_schema()["properties"];
  if (law.contains(key)) return law[key].is_number();
  const std::string types = properties[key].value("type", Json()).dump();
  return types.find("number") != std::string::npos || types.find("integer") != std::string::npos;
}

constexpr const char* usual_result = "peak_force_to_rolling_N";

/// A run without contact has no largest force, which is drawn as 0. One that stopped in rolling has
/// none either, since the rest of it could raise it: that is left out.
bool is_zero(const std::string& result, std::optional<Outcome> outcome) {
  return (result == usual_result || result == "peak_normal_force_N") && outcome &&
         outcome != Outcome::rolling;
}

/// What is drawn beside the outcome.
struct DrawnResult {
  std::string key;  ///< "outcome" if there is nothing else
  bool has_outcome, has_value;
};

DrawnResult drawn_result(const std::string& stated, const Sweep& sweep) {
  const std::vector<std::string>& all = result_columns(sweep);
  const auto has = [&](const std::string& name) { return contains(all, name); };
  const auto number = std::find_if(all.begin(), all.end(), is_number);
  const std::string key = !stated.empty()       ? stated
                          : has(usual_result)   ? usual_result
                          : number != all.end() ? *number
                                                : "outcome";
  if (!has(key))
    throw InputError("--column {}: there is no such result{}", shown(key),
                     choices(key, all, "rotor run --json-schema lists them"));
  const bool has_axis = std::any_of(sweep.axes.begin(), sweep.axes.end(),
                                    [&](const Axis& axis) { return is_drawn(axis, sweep); });
  if (key == "outcome" ? !has_axis : !is_number(key))
    throw InputError("{}: must be a result with numbers",
                     stated.empty() ? "columns" : "--column " + key);
  return {key, has("outcome"), key != "outcome"};
}

/// A result's name with the unit in which it is drawn, and that unit in SI units.
std::pair<std::string, double> label_and_unit(const std::string& key) {
  const std::size_t at = key.rfind('_');
  for (const std::string_view si : {"N", "m", "s", "Hz", "J", "kg"})
    if (at != std::string::npos && key.substr(at + 1) == si) {
      const auto [unit, in_si] = drawn_unit(si);
      return {fmt::format("{}, {}", name_in_words(key.substr(0, at)), unit), in_si};
    }
  return {name_in_words(key), 1};
}

/// The mean of numbers; NaN if there are none.
class Mean {
 public:
  void add(double value) {
    if (std::isnan(value)) return;
    sum_ += value;
    ++count_;
  }
  double take() {
    const double mean = count_ > 0 ? sum_ / static_cast<double>(count_) : NAN;
    *this = {};
    return mean;
  }

 private:
  double sum_ = 0;
  long count_ = 0;
};

/// What a row of results has to draw.
struct DrawnRow {
  std::optional<Outcome> outcome;
  double value = NAN;

  /// The place of its outcome among `outcomes`; of none that of stalled.
  std::size_t code() const {
    std::size_t n = 0;
    while (outcomes[n].outcome != outcome.value_or(Outcome::stalled)) ++n;
    return n;
  }
};

DrawnRow drawn_row(const CsvRow& row, const DrawnResult& result, double unit) {
  constexpr double most = 1e300;  // gnuplot's axes are wider than their values
  DrawnRow drawn;
  if (result.has_outcome && !row["outcome"].empty()) try {
      drawn.outcome = parse_name<Outcome>(row["outcome"]);
    } catch (const InputError& error) {
      row.fail(fmt::format("outcome: {}", error.what()));
    }
  if (!result.has_value) return drawn;
  if (const std::string& cell = row[result.key]; !cell.empty()) {
    const auto value = number_in(cell);
    if (!value || !(std::abs(*value / unit) < most))
      row.fail(fmt::format("{}: must be a number below {} in magnitude, not \"{}\"", result.key,
                           most * unit, shown(cell)));
    drawn.value = *value / unit;
  } else if (is_zero(result.key, drawn.outcome)) {
    drawn.value = 0;
  }
  return drawn;
}

/// What to draw of each point of a sweep, in the order of its file. Rows may have another order.
std::vector<DrawnRow> drawn_rows(const fs::path& results, const Sweep& sweep,
                                 const DrawnResult& result, double unit) {
  const auto name = [](const std::vector<std::string>& values) {
    return fmt::format("{}", fmt::join(values, ","));
  };
  const SweepPoints points(sweep);
  std::unordered_multimap<std::string, long> left;  // numbers of points by what varies
  for (long n = 0; n < sweep.points(); ++n) left.emplace(name(points(n).values), n);
  std::vector<std::string> columns = sweep.quantities(), values(columns.size());
  std::transform(columns.begin(), columns.end(), columns.begin(), column_of);
  std::vector<DrawnRow> drawn(left.size());
  read_csv(results, [&](const CsvRow& row) {
    std::transform(columns.begin(), columns.end(), values.begin(), [&](const auto& column) {
      const auto number = number_in(row[column]);  // 150.0 is 150
      return number ? fmt::format("{}", *number) : row[column];
    });
    const auto its = left.extract(name(values));
    if (!its)
      row.fail(
          fmt::format("is no point of the sweep file above the results, or one that an earlier "
                      "row has: {} = {}",
                      fmt::join(columns, ","), shown(name(values))));
    drawn[static_cast<std::size_t>(its.mapped())] = drawn_row(row, result, unit);
  });
  if (!left.empty())
    throw InputError("{}: has {} rows; the sweep file above them has {} points", results.string(),
                     drawn.size() - left.size(), sweep.points());
  return drawn;
}

/// Writes a table for each panel, so that gnuplot reads each number once: x and y, the code of the
/// outcome, and the result. A row is a draw or, in maps, the mean of the draws at a point, with the
/// share that rolls instead of the code. Returns what else gnuplot needs.
std::string write_panels(const Drawing& drawing, const PictureAxes& axes, const DrawnResult& result,
                         const fs::path& results, const Sweep& sweep) {
  const auto [label, unit] = label_and_unit(result.key);
  std::vector<std::string> panels(axes.panels.of.size());
  std::array<long, outcomes.size()> seen{};
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  const long draws = axes.is_map() ? sweep.sample.count : 1;
  Mean outcome, value;
  long n = 0;
  for (const DrawnRow& row : drawn_rows(results, sweep, result, unit)) {
    ++seen[row.code()];
    if (draws == 1)
      outcome.add(static_cast<double>(row.code()));
    else if (row.outcome)  // a refused point has none
      outcome.add(row.outcome == Outcome::rolling ? 1 : 0);
    value.add(row.value);
    if (++n % draws != 0) continue;
    const auto place = [&](std::size_t axis) {
      return axis < axes.numbers.size() ? axes.numbers[axis].at(n - 1) : 0;
    };
    const double its_outcome = outcome.take(), its_value = value.take();
    least = std::fmin(least, its_value);
    greatest = std::fmax(greatest, its_value);
    fmt::format_to(std::back_inserter(panels[static_cast<std::size_t>(axes.panels.at(n - 1))]),
                   "{},{},{},{}\n", place(0), place(1), its_outcome, its_value);
  }
  for (std::size_t p = 0; p < panels.size(); ++p)
    drawing.write(fmt::format("panel{}.csv", p), panels[p]);
  const bool is_empty = least > greatest;
  return fmt::format(
      "result_name = '{}'; has_outcome = {}; has_value = {}; is_empty = {}; least = {:#}; greatest "
      "= "
      "{:#}; array seen[{}] = [{}]\n",
      label, result.has_outcome ? 1 : 0, result.has_value ? 1 : 0,
      result.has_value && is_empty ? 1 : 0, is_empty ? 0 : least, is_empty ? 0 : greatest,
      seen.size(), fmt::join(seen, ", "));
}

/// What all points share, and what is drawn.
std::string conditions_of(const Sweep& sweep) {
  const auto vary = [&](const char* name) { return contains(sweep.quantities(), name); };
  std::string text = conditions(
      sweep.base, !vary("equations") && !vary("velocity_jump") && !vary("gravity_moment"));
  if (sweep.sample.over.empty()) return text;
  std::vector<std::string> drawn;
  for (const Draw& draw : sweep.sample.over) {
    const auto [unit, in_si] = drawn_unit(find_input_quantity(draw.quantity)->quantity.unit);
    drawn.push_back(fmt::format("{} {} {:.4g} {} {:.4g}{}{}", name_in_words(draw.quantity),
                                draw.distribution == Distribution::normal ? "of mean" : "from",
                                draw.a / in_si,
                                draw.distribution == Distribution::normal ? "and deviation" : "to",
                                draw.b / in_si, unit.empty() ? "" : " ", unit));
  }
  return fmt::format("{} draws of {}; {}", sweep.sample.count, fmt::join(drawn, ", "), text);
}

}  // namespace

void plot_sweep(const PlotOptions& options) {
  const ScenarioSpec& stated = options.stated;
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
  const Sweep sweep = read_sweep(source, options.file);
  const PictureAxes axes = axes_of(sweep);
  const bool is_square = axes.is_map() && axes.panels.of.size() < 3;
  const DrawnResult result = drawn_result(options.column, sweep);
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
  drawing.finish(axes.settings + write_panels(drawing, axes, result, results, sweep) +
                     drawing.headings(sweep.title, conditions_of(sweep), is_square ? 110 : 140),
                 "sweep.gp");
  say_what_is_assumed(sweep);
}

}  // namespace rotor
