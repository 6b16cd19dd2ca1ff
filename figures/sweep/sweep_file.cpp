#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "figures/input/toml_file.hpp"
#include "figures/results/estimated_result.hpp"
#include "figures/results/section_result.hpp"
#include "figures/sweep/sweep_row.hpp"

namespace rotor {
namespace {

/// Rows with the usual columns have some 280 bytes each, those of a section 130; more of them would
/// make a useless file.
constexpr double bytes_a_row = 280, bytes_a_turn = 130, most_bytes = 28e9;
/// Limit of the number of corners to check.
constexpr std::size_t most_dimensions = 12;

/// Whether steps in a range exceed the roundings of its numbers (see Range::at), so that all
/// differ.
bool has_room(double from, double until, double steps) {
  constexpr double roundings = 8 * std::numeric_limits<double>::epsilon();
  return (until - from) / steps > roundings * std::max(std::abs(from), std::abs(until));
}

class SweepReader : TomlFile {
 public:
  using TomlFile::TomlFile;

  Sweep read() {
    if (root().contains("run"))
      fail_at(root(), "run",
              "a sweep has none; a scene without [[axis]] and [sample] is for rotor run");
    if (root().contains("stop_on"))
      fail_at(root(), "stop_on",
              "a sweep has none: each point runs until nothing can change its columns");
    expect_keys(root(), {"title", "columns", "budget", "section", "parameters", "axis", "sample"});
    Sweep sweep;
    sweep.title = text(root(), "title").value_or("");
    sweep.text = content();
    if (root().contains("section")) sweep.section_turns = section(table(root(), "section"));
    const bool has_section = sweep.section_turns.has_value();
    sweep.columns = root().contains("columns") ? columns(has_section) : usual_columns(has_section);
    sweep.budget_s = value<double>(root(), "budget", "a number of seconds");
    if (sweep.budget_s)
      at(*root().get("budget"), "budget", [&] { require_budget("budget", *sweep.budget_s); });
    sweep.base = stated_in(*this, table(root(), "parameters"), {});
    for (const toml::table* in : tables(root(), "axis")) sweep.axes.push_back(axis(*in));
    if (root().contains("sample")) sweep.sample = sample(table(root(), "sample"));
    require_points(sweep);
    require_one_statement_each(sweep);
    require_physical_corners(sweep);
    if (has_section) require_turns(sweep);
    return sweep;
  }

 private:
  const toml::array& list(const toml::table& in, std::string_view key) const {
    const toml::array* const array = in.get(key)->as_array();
    if (!array || array->empty()) fail_at(in, key, "must be a list that is not empty");
    return *array;
  }

  long section(const toml::table& in) const {
    expect_keys(in, {"turns"});
    if (!in.contains("turns")) return Section::usual_turns;
    const long turns = count(in, "turns", 1);
    if (turns > Section::most_turns)
      fail_at(in, "turns", "must be at most {}", Section::most_turns);
    return turns;
  }

  std::vector<std::string> columns(bool has_section) const {
    if (const auto* name = root().get("columns")->as_string()) {
      if (name->get() == "all") return result_columns(has_section);
      fail_at(root(), "columns", "must be a list of results, or \"all\"");
    }
    const std::vector<std::string> allowed = columns_on_request(has_section);
    std::vector<std::string> all;
    for (const toml::node& item : list(root(), "columns")) {
      const auto name = item.value_or<std::string>("");
      if (!has_section && contains(section_columns(), name))
        fail(item, "columns", "{} needs section = {{ turns = {} }}", name, Section::usual_turns);
      if (!contains(allowed, name))
        fail(item, "columns", "there is no result \"{}\"{}", shown(name),
             choices(
                 name, allowed,
                 "rotor run --json-schema and rotor estimate --help list them; refusal is in each "
                 "row; columns = \"all\" are all results of a run"));
      add_new(all, name, item, "columns");
    }
    return all;
  }

  std::string quantity(const toml::table& in) const {
    const auto name = text(in, "quantity");
    if (!name) fail(in, "quantity", "must be stated: it varies");
    if (find_named_input(*name) || find_input_quantity(*name)) return *name;
    fail_at(in, "quantity", "there is no quantity \"{}\"{}", shown(*name),
            choices(name_of_symbol(*name), varied_inputs(), list_of_inputs));
  }

  double number(const toml::table& in, std::string_view key, const Quantity& quantity) const {
    const auto found = value<double>(in, key, "a number");
    if (!found) fail(in, key, "must be stated");
    require_allowed(*in.get(key), key, *found, quantity);
    return *found;
  }

  void require_allowed(const toml::node& node, std::string_view key, double number,
                       const Quantity& quantity) const {
    if (!quantity.allows(number))
      fail(node, key, "{} must be {}, not {}", quantity.name, quantity.range(), number);
  }

  Axis axis(const toml::table& in) const {
    expect_keys(in, {"quantity", "from", "to", "points", "spacing", "values"});
    Axis axis{quantity(in)};
    const NamedInput* const named = find_named_input(axis.quantity);
    const InputQuantity* const input = find_input_quantity(axis.quantity);
    if (named && !in.contains("values"))
      fail(in, "values", "must be stated: {} has no range", axis.quantity);
    if (!in.contains("values")) {
      axis.range = range(in, input->quantity);
      return axis;
    }
    if (in.size() != 2) fail_at(in, "values", "exclude from, to, points and spacing");
    for (const toml::node& item : list(in, "values"))
      if (named) {
        const auto name = item.value_or<std::string>("");
        ScenarioSpec ignored;
        at(item, "values", [&] { named->state(ignored, name); });
        add_new(axis.names, name, item, "values");
      } else {
        const double number = listed_number(item, "values");
        require_allowed(item, "values", number, input->quantity);
        add_new(axis.numbers, number, item, "values");
      }
    return axis;
  }

  /// Adds to a list what must not be in it already: its points would count twice.
  template <class T>
  void add_new(std::vector<T>& list, const T& value, const toml::node& item,
               std::string_view key) const {
    if (contains(list, value)) fail(item, key, "duplicate {}", value);
    list.push_back(value);
  }

  double listed_number(const toml::node& item, std::string_view key) const {
    const auto found = TomlFile::number(item);
    if (!found) fail(item, key, "must be numbers");
    return *found;
  }

  Range range(const toml::table& in, const Quantity& quantity) const {
    Range range{number(in, "from", quantity), number(in, "to", quantity), 0, false};
    if (!(range.from < range.until))
      fail_at(in, "to", "must be greater than from = {}", range.from);
    const std::string spacing = text(in, "spacing").value_or("linear");
    if (spacing != "linear" && spacing != "log")
      fail_at(in, "spacing", R"(must be "linear" or "log")");
    range.logarithmic = spacing == "log";
    if (range.logarithmic && !(range.from > 0))
      fail_at(in, "from", "must be greater than 0 for equal ratios");
    range.points = count(in, "points", 2);
    if (!has_room(range.from, range.until, static_cast<double>(range.points - 1)))
      fail_at(in, "points", "{} numbers from {} to {} cannot all differ", range.points, range.from,
              range.until);
    return range;
  }

  long count(const toml::table& in, std::string_view key, long least) const {
    const auto found = value<std::int64_t>(in, key, "a whole number");
    if (!found) fail(in, key, "must be stated");
    if (*found < least) fail_at(in, key, "must be at least {}", least);
    return static_cast<long>(*found);
  }

  Sample sample(const toml::table& in) const {
    expect_keys(in, {"count", "seed", "method", "over"});
    Sample sample;
    sample.count = count(in, "count", 1);
    if (in.contains("seed")) sample.seed = static_cast<unsigned long>(count(in, "seed", 0));
    const std::string method = text(in, "method").value_or("sobol");
    if (method != "sobol" && method != "random")
      fail_at(in, "method", R"(must be "sobol" or "random")");
    sample.method = method == "sobol" ? Sampling::sobol : Sampling::random;
    for (const toml::table* over : tables(in, "over"))
      sample.over.push_back(draw(*over, sample.count));
    if (sample.over.empty())
      fail(in, "sample", "needs a [[sample.over]] for each quantity that is drawn");
    return sample;
  }

  Draw draw(const toml::table& in, long count) const {
    expect_keys(in, {"quantity", "uniform", "log_uniform", "normal"});
    Draw draw{quantity(in), Distribution::uniform, 0, 0};
    if (find_named_input(draw.quantity))
      fail(in, "quantity", "only numbers can be drawn; use an [[axis]]");
    if (in.size() != 2) fail(in, "sample.over", "needs one of: uniform, log_uniform, normal");
    const std::string_view key = in.contains("uniform")       ? "uniform"
                                 : in.contains("log_uniform") ? "log_uniform"
                                                              : "normal";
    const toml::node& node = *in.get(key);
    const toml::array* const array = node.as_array();
    if (!array || array->size() != 2)
      fail(node, key, "must be {}", key == "normal" ? "[mean, deviation]" : "[from, to]");
    const Quantity& of = find_input_quantity(draw.quantity)->quantity;
    draw.a = listed_number((*array)[0], "sample.over");
    draw.b = listed_number((*array)[1], "sample.over");
    require_allowed(node, key, draw.a, of);
    if (key == "normal") {
      draw.distribution = Distribution::normal;
      if (!(draw.b > 0 && std::isfinite(draw.b)))
        fail(node, key, "the deviation must be greater than 0");
    } else {
      require_allowed(node, key, draw.b, of);
      if (!(draw.a < draw.b)) fail(node, key, "must be two numbers, the greater one last");
    }
    if (key == "log_uniform") {
      draw.distribution = Distribution::log_uniform;
      if (!(draw.a > 0)) fail(node, key, "must start above 0");
    }
    constexpr double least_share = 1e-16;  // the least of a draw
    if (!std::isfinite(draw.quantile(least_share)) ||
        !std::isfinite(draw.quantile(1 - least_share)))
      fail(node, key, "is too wide: numbers in it cannot be computed");
    const auto [least, greatest] = draw.ends(count);
    for (const double end : {least, greatest})
      if (!of.allows(end))
        fail(node, key,
             "count = {} draws may reach {:.4g}, and {} must be {}: state a smaller deviation, "
             "uniform or log_uniform",
             count, end, of.name, of.range());
    if (!has_room(draw.quantile(0.25), draw.quantile(0.75), static_cast<double>(count) / 2))
      fail(node, key, "is too narrow: count = {} draws cannot all differ", count);
    return draw;
  }

  void require_points(const Sweep& sweep) const {
    if (sweep.axes.empty() && sweep.sample.over.empty())
      fail(root(), "axis",
           "nothing varies: there must be an [[axis]] or a [sample]; a scene is for rotor run");
    auto all = static_cast<double>(sweep.sample.count);
    for (const Axis& axis : sweep.axes) all *= static_cast<double>(axis.points());
    const double bytes_each =
        bytes_a_row + bytes_a_turn * static_cast<double>(sweep.section_turns.value_or(0));
    if (all * bytes_each > most_bytes)
      fail(root(), "points",
           "{:.6g} points are more than {:.6g}: their rows would take some {:.3g} GB{}", all,
           std::floor(most_bytes / bytes_each), all * bytes_each / 1e9,
           sweep.section_turns
               ? fmt::format(" with section = {{ turns = {} }}", *sweep.section_turns)
               : "");
  }

  /// Points that have no section are refused one by one, unless it is for what does not vary.
  void require_turns(const Sweep& sweep) const {
    if (sweep.base.digits)
      fail_at(root(), "section", "excludes digits: they are not estimated in it");
    Scenario first;
    first.parameters.drive = sweep.base.drive.value_or(first.parameters.drive);
    first.method = sweep.base.method.value_or(first.method);
    const std::vector<std::string> varied = sweep.quantities();
    if (contains(varied, "drive")) first.parameters.drive = Drive::constant_speed;
    if (contains(varied, "method")) first.method = Method::event;
    try {
      require_equal_turns(first);
    } catch (const ScenarioError& error) {
      fail_at(root(), "section", "{}", error.what());
    }
  }

  std::vector<const toml::table*> varying() const {
    std::vector<const toml::table*> all = tables(root(), "axis");
    for (const toml::table* in : tables(table(root(), "sample"), "over")) all.push_back(in);
    return all;
  }

  /// A quantity must not be stated or varied twice, or one would be ignored.
  void require_one_statement_each(const Sweep& sweep) const {
    std::vector<std::string> varied;
    for (const std::string& quantity : sweep.quantities()) {
      const toml::table& in = *varying()[varied.size()];
      for (const std::string& other : varied)
        if (other == quantity)
          fail_at(in, "quantity", "{} varies twice", quantity);
        else if (determined_by(other) == determined_by(quantity))
          fail_at(in, "quantity", "{} varies, and so does {}: one determines the other", quantity,
                  other);
      varied.push_back(quantity);
      for (const auto& [stated, number] : sweep.base.numbers)
        if (determined_by(stated) == determined_by(quantity))
          fail_at(table(root(), "parameters"), stated, "is stated, and {} varies: remove one",
                  quantity);
      if (find_named_input(quantity) && table(root(), "parameters").contains(quantity))
        fail_at(table(root(), "parameters"), quantity, "is stated and varies: remove one");
    }
    const auto is_stated = [&](const char* correction) {
      return table(root(), "parameters").contains(correction) || contains(varied, correction);
    };
    if (contains(varied, "equations") && is_stated("velocity_jump") && is_stated("gravity_moment"))
      fail(root(), "equations",
           "varies, but is determined by velocity_jump and gravity_moment, which are stated");
  }

  /// Checks the corners of the axes and draws.
  void require_physical_corners(const Sweep& sweep) const {
    std::vector<Axis> ends;
    for (const Axis& axis : sweep.axes)
      if (axis.names.empty())
        ends.push_back({axis.quantity, {}, {axis.ends().first, axis.ends().second}});
    if (ends.size() + sweep.sample.over.size() > most_dimensions)
      fail(root(), "axis", "more than {} quantities vary", most_dimensions);
    for (const Draw& draw : sweep.sample.over) {
      const auto [least, greatest] = draw.ends(sweep.sample.count);
      ends.push_back({draw.quantity, {}, {least, greatest}});
    }
    Sweep corners{
        .title = {}, .text = {}, .base = sweep.base, .axes = std::move(ends), .sample = {}};
    const SweepPoints points(corners);
    const auto quantities = corners.quantities();
    for (long n = 0; n < corners.points(); ++n) {
      const SweepPoint corner = points(n);
      try {
        check_numbers(corner.spec);
      } catch (const ScenarioError& error) {
        std::vector<std::string> where;
        for (std::size_t i = 0; i < quantities.size(); ++i)
          where.push_back(fmt::format("{} = {}", quantities[i], corner.values[i]));
        const Message reason = as_stated(error.message(), corner.spec);
        const toml::node* at = &root();
        for (const std::string& input : reason.inputs()) {
          if (at == &root() && table(root(), "parameters").contains(input))
            at = table(root(), "parameters").get(input);
          for (const toml::table* in : varying())
            if (quantity(*in) == input) at = in;
        }
        fail(*at, fmt::format("where {}", fmt::join(where, ", ")), "{}", reason.text());
      }
    }
  }
};

}  // namespace

Sweep read_sweep(const std::filesystem::path& file) { return SweepReader(file).read(); }

Sweep read_sweep(const std::string& name, const std::string& content) {
  return SweepReader(name, content).read();
}

}  // namespace rotor
