#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "figures/data/files.hpp"
#include "figures/data/read_csv.hpp"
#include "figures/program/commands.hpp"
#include "figures/results/provenance.hpp"
#include "figures/results/section_result.hpp"
#include "figures/sweep/results_file.hpp"
#include "figures/sweep/sweep_row.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr int code_of_refused = static_cast<int>(outcomes.size());  // as palette.gp has it

/// A column of results that is drawn. Without an outcome it has numbers.
struct Shown {
  std::string name, label;
  double unit = 1;
  std::vector<double> values{};  ///< of the points, in this unit; NaN: none
  double least = none, most = none;

  bool is_outcome() const { return name == "outcome"; }
  bool is_logarithmic() const { return least > 0 && most / least > 100; }
};

/// The results of a sweep, in the order of its points.
struct Results {
  Sweep sweep;
  std::vector<Shown> shown;
  std::vector<signed char> outcomes{};  ///< places in `outcomes`; empty without that column
  long remarked = 0;                    ///< points with remarks
  std::vector<std::vector<double>> x_once_a_turn{};  ///< of each point, mm; empty without sections
};

/// What a column is called, as in summaries or by its name, and its unit by the end of that.
Shown described(const std::string& name) {
  struct Unit {
    std::string_view ending, label;
    double in_SI;
  };
  constexpr auto units = std::to_array<Unit>({{"_Hz", "Hz", 1},
                                              {"_N", "kN", 1e3},
                                              {"_m", "mm", 1e-3},
                                              {"_s", "s", 1},
                                              {"_J", "J", 1},
                                              {"_kg", "kg", 1},
                                              {"_rad", "rad", 1}});
  Shown shown{.name = name, .label = name_in_words(name)};
  for (const Unit& unit : units)
    if (name.ends_with(unit.ending)) {
      shown.label.resize(name.size() - unit.ending.size());
      shown.unit = unit.in_SI;
    }
  for (const ResultInWords& result : results_in_words)
    if (result.key == name) shown.label = result.label;
  shown.label = order_in_words(name).value_or(shown.label);
  for (const Unit& unit : units)
    if (name.ends_with(unit.ending)) shown.label += fmt::format(", {}", unit.label);
  return shown;
}

/// The columns that are drawn unless others are stated.
std::vector<std::string> usual(const Sweep& sweep, bool with_outcome, std::size_t most) {
  std::vector<std::string> all;
  const auto add = [&](const char* name) {
    if (contains(sweep.columns, name) && all.size() < most) all.emplace_back(name);
  };
  if (with_outcome) add("outcome");
  add("peak_force_to_rolling_N");
  if (!contains(sweep.columns, "peak_force_to_rolling_N")) add("peak_normal_force_N");
  add("rolling_onset_speed_Hz");
  add("repeats_after_turns");
  return all;
}

std::string head_in(const std::string& file) {
  constexpr std::size_t most = 1U << 21U;  // twice as much as a sweep file
  const std::string start = read_file(file, most);
  std::size_t at = 0;
  while (at < start.size() && start[at] == '#') {
    at = start.find('\n', at);
    at = at == std::string::npos ? start.size() : at + 1;
  }
  const std::size_t end = start.find('\n', at);
  return start.substr(0, end == std::string::npos ? start.size() : end + 1);
}

void read_rows(const std::string& file, const ResultHeads& heads, Results& into) {
  const Sweep& sweep = into.sweep;
  std::vector<std::size_t> places;
  for (const Shown& shown : into.shown) places.push_back(place_of(shown.name, sweep).value());
  const std::size_t fields = place_of(sweep.columns.back(), sweep).value() + 2;  // and the refusal
  const std::optional<std::size_t> outcome = place_of("outcome", sweep);
  const std::optional<std::size_t> remarks = place_of("remarks", sweep);
  const std::vector<std::string> in_head =
      csv_cells(std::string_view(heads.sections).substr(start_of_header_row(heads.sections)));
  const auto x_a = static_cast<std::size_t>(std::find(in_head.begin(), in_head.end(), "x_a_m") -
                                            in_head.begin());
  long points = 0;
  std::string fault;  // of the first row with one
  const auto see = [&](std::string_view line) {
    const PointLine point(line);
    const std::vector<std::string> cells = csv_cells(point.row);
    ++points;
    const auto refuse = [&](std::string_view column, const std::string& cell, const char* wanted) {
      if (fault.empty())
        fault = fmt::format("{}: point {} has {} = \"{}\", which is not {}", one_line(file), points,
                            column, shown(cell), wanted);
    };
    if (cells.size() != fields)
      return refuse("fields", std::to_string(cells.size()), "the number of the header row");
    if (remarks && !cells[*remarks].empty()) ++into.remarked;
    if (sweep.section_turns) into.x_once_a_turn.emplace_back();
    for (const std::string_view row : point.section) {
      const std::vector<std::string> turn = csv_cells(row);
      const std::string cell = x_a < turn.size() ? turn[x_a] : "";
      const std::optional<double> number = number_in(cell);
      if (!number) refuse("x_a_m", cell, "a number");
      into.x_once_a_turn.back().push_back(1e3 * number.value_or(none));
    }
    if (outcome) {
      const std::string& cell = cells[*outcome];
      const auto* const found =
          std::find_if(outcomes.begin(), outcomes.end(),
                       [&](const OutcomeInWords& one) { return one.name == cell; });
      if (found == outcomes.end() && !cell.empty())
        refuse("outcome", cell, "an outcome of this version");
      into.outcomes.push_back(static_cast<signed char>(
          found == outcomes.end() ? code_of_refused : found - outcomes.begin()));
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      Shown& shown = into.shown[i];
      if (shown.is_outcome()) continue;
      const std::string& cell = cells[places[i]];
      const std::optional<double> number = number_in(cell);
      if (!number && !cell.empty()) refuse(shown.name, cell, "a number");
      shown.values.push_back(number ? *number / shown.unit : none);
      if (!number) continue;
      shown.least = std::fmin(shown.least, shown.values.back());
      shown.most = std::fmax(shown.most, shown.values.back());
    }
  };
  if (!read_results(file, heads, Part(), sweep.points(), see))
    throw InputError("{}", damage_in_words(file, heads));
  if (!fault.empty()) throw InputError("{}", fault);
}

/// The axes of a sweep by their roles, and the places of its points.
class Layout {
 public:
  Layout(const Sweep& sweep, const std::string& file) : sweep_(sweep) {
    constexpr std::size_t most_panels = 6;
    const std::vector<Axis>& axes = sweep.axes;
    for (std::size_t i = axes.size(); i-- > 0 && sweep.sample.over.empty() && over_.size() < 2;)
      if (axes[i].names.empty() && axes[i].points() > 1) over_.push_back(i);
    if (sweep.sample.over.empty() && over_.empty())
      throw InputError("{}: no quantity has several numbers to draw its results over",
                       one_line(file));
    for (std::size_t i = 0; i < axes.size(); ++i)
      if (!contains(over_, i) && axes[i].points() > 1) apart_.push_back(i);
    std::vector<std::string> names = {""};
    for (const std::size_t i : apart_) {
      std::vector<std::string> more;
      for (const std::string& name : names)
        for (long n = 0; n < axes[i].points(); ++n)
          more.push_back(name + (name.empty() ? "" : ", ") + value_in_words(axes[i], n));
      names = std::move(more);
      if (names.size() > most_panels)
        throw InputError(
            "{}: has more than {} combinations of {}: a picture is over the last two axes with "
            "numbers, or over a sample, and has a panel for each combination of the others",
            one_line(file), most_panels, quantities_apart());
    }
    names_ = std::move(names);
  }

  /// Of axes with numbers, the last one first; none for a sample.
  const std::vector<std::size_t>& over() const { return over_; }
  const std::vector<std::string>& panels() const { return names_; }

  long place(long point, std::size_t axis) const {
    long left = point / sweep_.sample.count;
    for (std::size_t i = sweep_.axes.size() - 1; i > axis; --i) left /= sweep_.axes[i].points();
    return left % sweep_.axes[axis].points();
  }
  std::size_t panel(long point) const {
    long panel = 0;
    for (const std::size_t i : apart_) panel = panel * sweep_.axes[i].points() + place(point, i);
    return static_cast<std::size_t>(panel);
  }

 private:
  std::string quantities_apart() const {
    std::vector<std::string> all;
    for (const std::size_t i : apart_) all.push_back(sweep_.axes[i].quantity);
    return fmt::format("{}", fmt::join(all, ", "));
  }
  static std::string value_in_words(const Axis& axis, long n) {
    if (axis.names.empty())
      return with_unit(find_input_quantity(axis.quantity)->quantity, axis.number(n));
    const std::string& name = axis.names[static_cast<std::size_t>(n)];
    return axis.quantity == "equations" ? std::string(equations_in_words(name))
                                        : name_in_words(axis.quantity) + ": " + name_in_words(name);
  }

  const Sweep& sweep_;
  std::vector<std::size_t> over_, apart_;
  std::vector<std::string> names_;
};

/// Cells along an axis, all of the same width: where they are, and the value in each. Values that
/// are not equally spaced have cells with borders half-way between them, in narrow strips.
struct Cells {
  bool is_logarithmic = false;
  std::vector<double> at{};
  std::vector<long> value{};

  explicit Cells(const Axis& axis, double unit) {
    const auto [least, most] = axis.ends();
    is_logarithmic =
        axis.numbers.empty() ? axis.range.logarithmic : least > 0 && most / least > 100;
    std::vector<std::pair<double, long>> values;
    for (long n = 0; n < axis.points(); ++n) {
      const double number = axis.number(n);
      values.emplace_back(is_logarithmic ? std::log10(number / unit) : number / unit, n);
    }
    std::sort(values.begin(), values.end());
    const double first = values.front().first, last = values.back().first,
                 step = (last - first) / static_cast<double>(values.size() - 1);
    bool is_even = true;
    for (std::size_t n = 0; n < values.size(); ++n) {
      constexpr double negligible = 1e-3;  // of a cell
      is_even = is_even && std::abs(values[n].first - first - static_cast<double>(n) * step) <
                               negligible * step;
    }
    if (is_even) {
      for (const auto& [place, n] : values) {
        at.push_back(place);
        value.push_back(n);
      }
      return;
    }
    constexpr int strips = 400;
    const auto border = [&](std::size_t n) {
      return 0.5 * (values[n].first + values[n + 1].first);
    };
    const std::size_t end = values.size() - 1;
    const double from = 2 * first - border(0), until = 2 * last - border(end - 1);
    std::size_t n = 0;
    for (int strip = 0; strip < strips; ++strip) {
      at.push_back(from + (until - from) * (strip + 0.5) / strips);
      while (n < end && at.back() > border(n)) ++n;
      value.push_back(values[n].second);
    }
  }
};

std::string number(double value) {
  return std::isnan(value) ? "NaN" : fmt::format("{:.8g}", value);
}

const Quantity& quantity_of(const Axis& axis) {
  return find_input_quantity(axis.quantity)->quantity;
}

std::string label_of(const Axis& axis) {
  const std::string unit = unit_in_words(quantity_of(axis));
  return name_in_words(axis.quantity) + (unit.empty() ? "" : ", " + unit);
}

double value_of(const Results& results, const Shown& shown, std::size_t point) {
  return shown.is_outcome() ? static_cast<double>(results.outcomes[point]) : shown.values[point];
}

/// The outcome of a point; that of refused ones without the column.
int code_of(const Results& results, std::size_t point) {
  return results.outcomes.empty() ? -1 : results.outcomes[point];
}

/// A file for each panel: places along the axes, and in each the values that are shown.
Drafts map_data(const Results& results, const Layout& layout, std::string& settings) {
  const Sweep& sweep = results.sweep;
  const std::size_t x_axis = layout.over()[0], y_axis = layout.over()[1];
  const Axis &along = sweep.axes[x_axis], &up = sweep.axes[y_axis];
  const Cells x(along, unit_of(quantity_of(along))), y(up, unit_of(quantity_of(up)));
  settings +=
      fmt::format("x_name = {}; y_name = {}; x_log = {}; y_log = {}; x_unit = {}; y_unit = {}\n",
                  gnuplot_text(label_of(along)), gnuplot_text(label_of(up)), int{x.is_logarithmic},
                  int{y.is_logarithmic}, unit_of(quantity_of(along)), unit_of(quantity_of(up)));
  settings += fmt::format("cells = {}\n", x.at.size() * y.at.size());
  const auto width = static_cast<std::size_t>(along.points()),
             height = static_cast<std::size_t>(up.points());
  std::vector<std::vector<std::size_t>> points(layout.panels().size(),
                                               std::vector<std::size_t>(width * height));
  for (long n = 0; n < sweep.points(); ++n)
    points[layout.panel(n)][static_cast<std::size_t>(layout.place(n, y_axis)) * width +
                            static_cast<std::size_t>(layout.place(n, x_axis))] =
        static_cast<std::size_t>(n);
  Drafts drafts;
  for (std::size_t panel = 0; panel < points.size(); ++panel) {
    std::string text;
    for (std::size_t row = 0; row < y.at.size(); ++row)
      for (std::size_t column = 0; column < x.at.size(); ++column) {
        text += number(x.at[column]) + ',' + number(y.at[row]);
        const std::size_t point = points[panel][static_cast<std::size_t>(y.value[row]) * width +
                                                static_cast<std::size_t>(x.value[column])];
        for (const Shown& shown : results.shown)
          text += ',' + number(value_of(results, shown, point));
        text += '\n';
      }
    drafts.emplace_back(fmt::format("panel{}.csv", panel + 1), std::move(text));
  }
  return drafts;
}

/// A file for each panel: the number on the axis, and x_a once a turn; one of places that a picture
/// does not tell apart.
Drafts section_data(const Results& results, const Layout& layout, std::string& settings) {
  const Axis& along = results.sweep.axes[layout.over()[0]];
  double least = none, most = none;
  for (const std::vector<double>& of_point : results.x_once_a_turn)
    for (const double x : of_point) {
      least = std::fmin(least, x);
      most = std::fmax(most, x);
    }
  settings += fmt::format("sections = {}; low0 = {}; high0 = {}\n",
                          int{!results.x_once_a_turn.empty()}, number(least), number(most));
  const double told_apart = most > least ? (most - least) / 600 : 1;
  std::vector<std::string> texts(layout.panels().size());
  for (std::size_t point = 0; point < results.x_once_a_turn.size(); ++point) {
    const auto n = static_cast<long>(point);
    std::map<long, double> places;
    for (const double x : results.x_once_a_turn[point])
      places.emplace(std::lround((x - least) / told_apart), x);
    for (const auto& [place, x] : places)
      texts[layout.panel(n)] += fmt::format(
          "{},{}\n",
          number(along.number(layout.place(n, layout.over()[0])) / unit_of(quantity_of(along))),
          number(x));
  }
  Drafts drafts;
  for (std::size_t panel = 0; panel < texts.size(); ++panel) {
    settings += fmt::format("turns{} = {}\n", panel + 1, int{!texts[panel].empty()});
    drafts.emplace_back(fmt::format("section{}.csv", panel + 1), std::move(texts[panel]));
  }
  return drafts;
}

/// A file for each panel: the number on the axis, the outcome, the values that are shown, and
/// whether they are missing.
Drafts curve_data(const Results& results, const Layout& layout, std::string& settings) {
  const Sweep& sweep = results.sweep;
  const std::size_t axis = layout.over()[0];
  const Axis& along = sweep.axes[axis];
  const double unit = unit_of(quantity_of(along));
  settings += fmt::format("x_name = {}; x_log = {}; x_low = {}; x_high = {}\n",
                          gnuplot_text(label_of(along)), int{Cells(along, unit).is_logarithmic},
                          along.ends().first / unit, along.ends().second / unit);
  std::vector<std::string> texts(layout.panels().size());
  for (long n = 0; n < sweep.points(); ++n) {
    const auto point = static_cast<std::size_t>(n);
    std::string& text = texts[layout.panel(n)];
    text += fmt::format("{},{}", number(along.number(layout.place(n, axis)) / unit),
                        code_of(results, point));
    for (const Shown& shown : results.shown) text += ',' + number(value_of(results, shown, point));
    for (const Shown& shown : results.shown)
      text += std::isnan(value_of(results, shown, point)) ? ",1" : ",0";
    text += '\n';
  }
  Drafts drafts = section_data(results, layout, settings);
  for (std::size_t panel = 0; panel < texts.size(); ++panel)
    drafts.emplace_back(fmt::format("panel{}.csv", panel + 1), std::move(texts[panel]));
  return drafts;
}

/// A file for each panel and column: the bars of a histogram, by outcome one on the other, in
/// percent of the draws.
Drafts bar_data(const Results& results, const Layout& layout, std::string& settings) {
  const Sweep& sweep = results.sweep;
  const auto draws = static_cast<double>(sweep.sample.count);
  constexpr int codes = code_of_refused + 1;
  Drafts drafts;
  for (std::size_t c = 0; c < results.shown.size(); ++c) {
    const Shown& shown = results.shown[c];
    const bool is_log = shown.is_logarithmic();
    const auto place = [&](double value) { return is_log ? std::log10(value) : value; };
    const int bins =
        shown.is_outcome() ? codes : std::clamp(static_cast<int>(std::sqrt(draws)), 5, 40);
    const double from = shown.is_outcome() ? -0.5 : place(shown.least),
                 until = shown.is_outcome() ? codes - 0.5 : place(shown.most),
                 wide = until > from ? (until - from) / bins : 1;
    // Of each panel and bin, by outcome, from -1 on: without any.
    std::vector<std::vector<std::vector<long>>> counts(
        layout.panels().size(),
        std::vector<std::vector<long>>(static_cast<std::size_t>(bins),
                                       std::vector<long>(static_cast<std::size_t>(codes) + 1)));
    std::vector<long> empty(layout.panels().size());
    double tallest = 0;
    for (long n = 0; n < sweep.points(); ++n) {
      const auto point = static_cast<std::size_t>(n);
      const double value = value_of(results, shown, point);
      if (std::isnan(value)) {
        ++empty[layout.panel(n)];
        continue;
      }
      const double at = shown.is_outcome() ? value : place(value);
      const int bin = std::clamp(static_cast<int>((at - from) / wide), 0, bins - 1);
      ++counts[layout.panel(n)][static_cast<std::size_t>(bin)]
              [static_cast<std::size_t>(code_of(results, point)) + 1];
    }
    for (std::size_t panel = 0; panel < counts.size(); ++panel) {
      std::string text;
      for (int bin = 0; bin < bins; ++bin) {
        double below = 0;
        for (int code = -1; code < codes; ++code) {
          const long count =
              counts[panel][static_cast<std::size_t>(bin)][static_cast<std::size_t>(code) + 1];
          if (count == 0) continue;
          const double above = below + 100 * static_cast<double>(count) / draws,
                       left = from + bin * wide, right = left + wide;
          text += fmt::format("{},{},{},{},{}\n", number(is_log ? std::pow(10, left) : left),
                              number(is_log ? std::pow(10, right) : right), number(below),
                              number(above), code);
          below = above;
          tallest = std::max(tallest, above);
        }
      }
      settings += fmt::format("empty{}_{} = {}\n", panel + 1, c + 1,
                              number(100 * static_cast<double>(empty[panel]) / draws));
      drafts.emplace_back(fmt::format("bars{}-{}.csv", panel + 1, c + 1), std::move(text));
    }
    settings += fmt::format("tallest{} = {}\n", c + 1, number(tallest));
  }
  return drafts;
}

/// What all points share, in lines.
std::string conditions_of(const Sweep& sweep) {
  Items items;
  const std::vector<std::string> varied = sweep.quantities();
  if (!contains(varied, "equations") && !contains(varied, "velocity_jump") &&
      !contains(varied, "gravity_moment"))
    items.add(std::string(equations_in_words(name_of(equations_of(sweep.base)))));
  if (sweep.base.drive == Drive::constant_speed) items.add("held speed");
  if (sweep.base.loses_mass == false) items.add("no mass loss");
  for (const auto& [quantity, instead_of, of_start] : input_quantities())
    if (const auto stated = sweep.base.numbers.find(quantity.name);
        stated != sweep.base.numbers.end())
      items.add(with_unit(quantity, stated->second));
  if (!sweep.base.states("until") && !contains(varied, "until"))
    items.add("each run ends " + default_end_in_words());
  if (!sweep.sample.over.empty()) items.add(fmt::format("{} draws", sweep.sample.count));
  return items.text();
}

std::string heading_of(const Sweep& sweep, const Layout& layout) {
  if (!sweep.title.empty()) return sweep.title;
  std::vector<std::string> names;
  for (const std::size_t axis : layout.over())
    names.push_back(name_in_words(sweep.axes[axis].quantity));
  const char* const what = names.empty() ? "Sample of" : "Sweep over";
  for (const Draw& draw : sweep.sample.over) names.push_back(name_in_words(draw.quantity));
  return fmt::format("{} {}", what, fmt::join(names, ", "));
}

}  // namespace

void plot_sweep(const PlotOptions& options) {
  if (options.from_s || options.until_s || options.stated != ScenarioSpec())
    throw InputError(
        "{}: results of a sweep are drawn as they are: of the options only --columns, "
        "--drafts and --out have an effect",
        one_line(options.file));
  const std::string out = options.out.empty() ? name_made_from(options.file, ".svg") : options.out;
  const std::string head = head_in(options.file);
  Results results{sweep_of(head, options.file), {}};
  const Sweep& sweep = results.sweep;
  const Layout layout(sweep, options.file);
  const bool is_map = layout.over().size() == 2, is_sample = layout.over().empty();
  std::vector<std::string> names = options.columns;
  if (names.empty()) names = usual(sweep, is_map || is_sample, is_map ? 2 : 3);
  if (names.empty())
    throw InputError("{}: has neither outcome, force nor speed: --columns states what to draw: {}",
                     one_line(options.file), fmt::join(sweep.columns, ", "));
  for (const std::string& name : names) {
    if (!contains(sweep.columns, name))
      throw InputError("--columns: {} has no column {}{}", one_line(options.file), shown(name),
                       choices(name, sweep.columns, "its header row lists them"));
    if (name == "outcome" && !is_map && !is_sample)
      throw InputError("--columns: outcome is drawn as the colour of the others");
    results.shown.push_back(described(name));
  }
  if (options.drafts.empty()) require_picture(out, options.file);
  ResultHeads heads{head};
  if (const std::string other = heads_of(sweep).sections; !other.empty() && !is_map && !is_sample) {
    heads.sections = head.substr(0, start_of_header_row(head)) +  // perhaps of another version
                     other.substr(start_of_header_row(other));
  }
  read_rows(options.file, heads, results);
  std::string settings =
      fmt::format("heading = {}; conditions = {}; panels = {}; columns = {}\n",
                  gnuplot_text(with_indices(heading_of(sweep, layout))),
                  gnuplot_text(conditions_of(sweep)), layout.panels().size(), results.shown.size());
  for (std::size_t n = 0; n < layout.panels().size(); ++n)
    settings += fmt::format("panel{} = {}\n", n + 1, gnuplot_text(layout.panels()[n]));
  for (std::size_t n = 0; n < results.shown.size(); ++n) {
    const Shown& shown = results.shown[n];
    const bool has_gaps = std::any_of(shown.values.begin(), shown.values.end(),
                                      [](double value) { return std::isnan(value); });
    settings += fmt::format(
        "of_outcome{0} = {1}; label{0} = {2}; low{0} = {3}; high{0} = {4}; log{0} = {5}; gaps{0} = "
        "{6}\n",
        n + 1, int{shown.is_outcome()}, gnuplot_text(shown.label), number(shown.least),
        number(shown.most), int{shown.is_logarithmic()}, int{has_gaps});
  }
  const std::set<int> found(results.outcomes.begin(), results.outcomes.end());
  settings +=
      fmt::format("found = \"{}\"; is_sample = {}\n", fmt::join(found, " "), int{is_sample});
  Drafts drafts = is_map      ? map_data(results, layout, settings)
                  : is_sample ? bar_data(results, layout, settings)
                              : curve_data(results, layout, settings);
  drafts.emplace_back("settings.gp", settings);
  if (!options.drafts.empty()) return write_drafts(options.drafts, drafts);
  draw(out, is_map ? "maps/map.gp" : "program/sweep.gp", drafts);
  say_how_many_have_remarks(results.remarked, sweep.points());
}

}  // namespace rotor
