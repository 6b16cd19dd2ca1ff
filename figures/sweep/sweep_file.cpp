#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "figures/data/text.hpp"
#include "figures/input/toml_file.hpp"
#include "figures/sweep/sweep_row.hpp"

namespace rotor {
namespace {

/// Rows have some 600 bytes each; more of them would make a useless file.
constexpr double most_points = 1e8, bytes_a_row = 600;
/// Limit of the number of corners to check.
constexpr std::size_t most_dimensions = 12;

class SweepReader : TomlFile {
 public:
  explicit SweepReader(const std::filesystem::path& file) : TomlFile(file) {}

  Sweep read() {
    expect_keys(root(), {"title", "stop_on", "columns", "parameters", "axis", "sample"});
    Sweep sweep;
    sweep.title = text(root(), "title").value_or("");
    sweep.text = content();
    if (const auto stop = text(root(), "stop_on"))
      sweep.stop_on = at(*root().get("stop_on"), "stop_on", [&] { return parse_stop(*stop); });
    if (root().contains("columns")) sweep.columns = columns();
    sweep.base = stated_in(*this, table(root(), "parameters"), {});
    if (sweep.base.digits && sweep.stop_on)
      fail(*table(root(), "parameters").get("digits"), "digits",
           "needs stop_on = \"end\": where a run stops early depends on its steps");
    for (const toml::table* in : tables(root(), "axis")) sweep.axes.push_back(axis(*in));
    if (root().contains("sample")) sweep.sample = sample(table(root(), "sample"));
    require_points(sweep);
    require_one_statement_each(sweep);
    require_physical_corners(sweep);
    return sweep;
  }

 private:
  static std::optional<StopOn> parse_stop(std::string_view name) {
    if (name == "end") return std::nullopt;
    try {
      return parse_stop_on(name);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}; or \"end\", the end of the run", error.what()));
    }
  }

  std::vector<std::string> columns() const {
    const toml::node& node = *root().get("columns");
    const toml::array* const array = node.as_array();
    if (!array || array->empty()) fail(node, "columns", "must be a list that is not empty");
    const std::vector<std::string>& allowed = columns_on_request();
    std::vector<std::string> all;
    for (const toml::node& item : *array) {
      const auto name = item.value_or<std::string>("");
      if (std::find(allowed.begin(), allowed.end(), name) == allowed.end())
        fail(item, "columns",
             fmt::format("there is no result \"{}\"{}; there are: {}", shown(name),
                         suggestion(name, allowed), fmt::join(allowed, ", ")));
      if (std::find(all.begin(), all.end(), name) != all.end())
        fail(item, "columns", fmt::format("duplicate column \"{}\"", name));
      all.push_back(name);
    }
    return all;
  }

  static bool is_named(std::string_view quantity) {
    const auto named = named_inputs();
    return std::find(named.begin(), named.end(), quantity) != named.end();
  }

  std::string quantity(const toml::table& in) const {
    const auto name = text(in, "quantity");
    if (!name) fail(in, "quantity", "must be stated: it varies");
    if (is_named(*name) || find_input_quantity(*name)) return *name;
    std::vector<std::string> allowed(named_inputs().begin(), named_inputs().end());
    for (const InputQuantity& input_quantity : input_quantities())
      allowed.emplace_back(input_quantity.quantity.name);
    fail(*in.get("quantity"), "quantity",
         fmt::format("there is no quantity \"{}\"{}; there are: {}", shown(*name),
                     suggestion(*name, allowed), fmt::join(allowed, ", ")));
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
      fail(node, key,
           fmt::format("{} must be {}, not {}", quantity.name, quantity.range(), number));
  }

  Axis axis(const toml::table& in) const {
    expect_keys(in, {"quantity", "from", "to", "points", "spacing", "values"});
    Axis axis{quantity(in), {}};
    if (const toml::node* values = in.get("values")) {
      if (in.size() != 2) fail(*values, "values", "exclude from, to, points and spacing");
      const toml::array* array = values->as_array();
      if (!array || array->empty()) fail(*values, "values", "must be a list that is not empty");
      if (is_named(axis.quantity)) {
        axis.values = names(*array, axis.quantity);
      } else {
        const std::vector<double> all = numbers(*array, "values");
        for (std::size_t i = 0; i < all.size(); ++i)
          require_allowed((*array)[i], "values", all[i],
                          find_input_quantity(axis.quantity)->quantity);
        axis.values = all;
      }
    } else if (is_named(axis.quantity)) {
      fail(in, "values", fmt::format("must be stated: {} has no range", axis.quantity));
    } else {
      axis.values = range(in, find_input_quantity(axis.quantity)->quantity);
    }
    return axis;
  }

  std::vector<std::string> names(const toml::array& array, const std::string& quantity) const {
    std::vector<std::string> all;
    for (const toml::node& item : array) {
      all.push_back(item.value_or<std::string>(""));
      ScenarioSpec ignored;
      at(item, "values", [&] { state(ignored, quantity, all.back()); });
    }
    return all;
  }

  std::vector<double> numbers(const toml::array& array, std::string_view key) const {
    std::vector<double> all;
    for (const toml::node& item : array) {
      const auto found = TomlFile::number(item);
      if (!found) fail(item, key, "must be numbers");
      all.push_back(*found);
    }
    return all;
  }

  Range range(const toml::table& in, const Quantity& quantity) const {
    Range range{number(in, "from", quantity), number(in, "to", quantity), 0, false};
    if (!(range.from < range.until))
      fail(*in.get("to"), "to", fmt::format("must be greater than from = {}", range.from));
    const std::string spacing = text(in, "spacing").value_or("linear");
    if (spacing != "linear" && spacing != "log")
      fail(*in.get("spacing"), "spacing", R"(must be "linear" or "log")");
    range.logarithmic = spacing == "log";
    if (range.logarithmic && !(range.from > 0))
      fail(*in.get("from"), "from", "must be greater than 0 for equal ratios");
    range.points = count(in, "points", 2);
    if (!std::isfinite(range.at(1)))
      fail(*in.get("to"), "to", fmt::format("is too far from {} for equal steps", range.from));
    return range;
  }

  long count(const toml::table& in, std::string_view key, long least) const {
    const auto found = value<std::int64_t>(in, key, "a whole number");
    if (!found) fail(in, key, "must be stated");
    if (*found < least) fail(*in.get(key), key, fmt::format("must be at least {}", least));
    return static_cast<long>(*found);
  }

  Sample sample(const toml::table& in) const {
    expect_keys(in, {"count", "seed", "method", "over"});
    Sample sample;
    sample.count = count(in, "count", 1);
    if (in.contains("seed")) sample.seed = static_cast<unsigned long>(count(in, "seed", 0));
    const std::string method = text(in, "method").value_or("sobol");
    if (method != "sobol" && method != "random")
      fail(*in.get("method"), "method", R"(must be "sobol" or "random")");
    sample.method = method == "sobol" ? Sampling::sobol : Sampling::random;
    for (const toml::table* over : tables(in, "over")) sample.over.push_back(draw(*over));
    if (sample.over.empty())
      fail(in, "sample", "needs a [[sample.over]] for each quantity that is drawn");
    return sample;
  }

  Draw draw(const toml::table& in) const {
    expect_keys(in, {"quantity", "uniform", "log_uniform", "normal"});
    Draw draw{quantity(in), Distribution::uniform, 0, 0};
    if (is_named(draw.quantity)) fail(in, "quantity", "only numbers can be drawn; use an [[axis]]");
    if (in.size() != 2) fail(in, "sample.over", "needs one of: uniform, log_uniform, normal");
    const std::string_view key = in.contains("uniform")       ? "uniform"
                                 : in.contains("log_uniform") ? "log_uniform"
                                                              : "normal";
    const toml::node& node = *in.get(key);
    const toml::array* const array = node.as_array();
    if (!array || array->size() != 2)
      fail(node, key,
           fmt::format("must be {}", key == "normal" ? "[mean, deviation]" : "[from, to]"));
    const Quantity& of = find_input_quantity(draw.quantity)->quantity;
    const std::vector<double> pair = numbers(*array, "sample.over");
    draw.a = pair[0];
    draw.b = pair[1];
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
    return draw;
  }

  void require_points(const Sweep& sweep) const {
    if (sweep.axes.empty() && sweep.sample.over.empty())
      fail(root(), "axis", "nothing varies: there must be an [[axis]] or a [sample]");
    auto all = static_cast<double>(sweep.sample.count);
    for (const Axis& axis : sweep.axes) all *= static_cast<double>(axis.points());
    if (all > most_points)
      fail(root(), "points",
           fmt::format("{:.6g} points are more than {:.6g}: their rows would take some {:.3g} GB",
                       all, most_points, all * bytes_a_row / 1e9));
  }

  /// A quantity must not be stated or varied twice, or one would be ignored.
  void require_one_statement_each(const Sweep& sweep) const {
    std::vector<std::string> varied;
    for (const std::string& quantity : sweep.quantities()) {
      for (const std::string& other : varied)
        if (determined_by(other) == determined_by(quantity))
          fail(root(), quantity, fmt::format("varies, and so does {}, which determines it", other));
      varied.push_back(quantity);
      for (const auto& [stated, number] : sweep.base.numbers)
        if (determined_by(stated) == determined_by(quantity))
          fail(root(), quantity,
               fmt::format("varies, but [parameters] states {}, which determines it", stated));
      if (is_named(quantity) && table(root(), "parameters").contains(quantity))
        fail(root(), quantity, "varies, but [parameters] states it");
    }
    const auto is_stated = [&](const char* correction) {
      return table(root(), "parameters").contains(correction) ||
             std::find(varied.begin(), varied.end(), correction) != varied.end();
    };
    if (std::find(varied.begin(), varied.end(), "equations") != varied.end() &&
        is_stated("velocity_jump") && is_stated("gravity_moment"))
      fail(root(), "equations",
           "varies, but is determined by velocity_jump and gravity_moment, which are stated");
  }

  /// Checks the corners of the axes and draws; of a normal draw only the mean.
  void require_physical_corners(const Sweep& sweep) const {
    std::vector<Axis> ends;
    for (const Axis& axis : sweep.axes) {
      if (const auto* const range = std::get_if<Range>(&axis.values))
        ends.push_back({axis.quantity, std::vector<double>{range->from, range->until}});
      else if (const auto* const numbers = std::get_if<std::vector<double>>(&axis.values))
        ends.push_back({axis.quantity,
                        std::vector<double>{*std::min_element(numbers->begin(), numbers->end()),
                                            *std::max_element(numbers->begin(), numbers->end())}});
    }
    if (ends.size() + sweep.sample.over.size() > most_dimensions)
      fail(root(), "axis", fmt::format("more than {} quantities vary", most_dimensions));
    for (const Draw& draw : sweep.sample.over)
      ends.push_back({draw.quantity, draw.distribution == Distribution::normal
                                         ? std::vector<double>{draw.a}
                                         : std::vector<double>{draw.a, draw.b}});
    Sweep corners{
        .title = {}, .text = {}, .base = sweep.base, .axes = std::move(ends), .sample = {}};
    const SweepPoints points(corners);
    const auto quantities = corners.quantities();
    for (long n = 0; n < corners.points(); ++n) {
      const SweepPoint corner = points(n);
      try {
        check_numbers(corner.spec);
      } catch (const std::exception& error) {
        std::vector<std::string> where;
        for (std::size_t i = 0; i < quantities.size(); ++i)
          where.push_back(fmt::format("{} = {}", quantities[i], corner.values[i]));
        fail(root(), "corner", fmt::format("{}: {}", fmt::join(where, ", "), error.what()));
      }
    }
  }
};

}  // namespace

Sweep read_sweep(const std::filesystem::path& file) { return SweepReader(file).read(); }

}  // namespace rotor
