#include "figures/results/estimated_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rotor {
namespace {

/// Values by their names, and then their errors.
void add(const std::vector<NamedEstimate>& values, Json& to) {
  Json errors;
  for (const NamedEstimate& value : values) {
    to[value.name] = json_of(value.value);
    errors[value.name] = value.value ? Json(value.error) : Json();
  }
  to["errors"] = errors;
}

std::string what_is_missing(const Comparison& comparison, int digits) {
  constexpr auto course = "counts and outcome cannot be determined at this precision: ";
  if (!comparison.same_course)
    return fmt::format("{}two computations agree on the first {} events only", course,
                       comparison.events.size() - 1);
  if (!comparison.is_course_sure)
    return fmt::format(
        "{}a glancing contact, or an event near another or the end, is closer than "
        "its error",
        course);
  const auto all = short_of_digits(comparison, digits);
  std::string text =
      fmt::format("{} has {} of {} digits", all.front().value, all.front().digits, digits);
  if (all.size() > 1) text += fmt::format(", and {} others have too few", all.size() - 1);
  return text;
}

}  // namespace

void require_budget(std::string_view name, double budget_s) {
  if (!(budget_s > 0 && std::isfinite(budget_s)))
    throw InputError("{} {}: must be a finite number greater than 0 s", name, budget_s);
}

std::vector<ShortOfDigits> short_of_digits(const Comparison& comparison, int digits) {
  std::vector<ShortOfDigits> all;
  const auto look_at = [&](const std::string& where, const NamedEstimate& value) {
    const int has = value.digits();
    if (has < digits) all.push_back({where + std::string(value.name), has});
  };
  for (const NamedEstimate& value : comparison.summary) look_at("", value);
  for (std::size_t i = 0; i < comparison.events.size(); ++i)
    for (const NamedEstimate& value : comparison.events[i].values)
      look_at(fmt::format("events[{}].", i), value);
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.digits < b.digits; });
  return all;
}

Comparison comparison_to_digits(const Scenario& scenario, int digits, const Interruptible& monitor,
                                const std::function<void(double time_s)>& on_step) {
  const auto found = run_to_digits(scenario, digits, [&](double time_s) {
    if (on_step) on_step(time_s);
    return monitor.may_continue();
  });
  if (is_interrupted()) throw Interrupted();
  if (!found)
    throw std::runtime_error(
        fmt::format("a budget of {} s is not enough for a first estimate", monitor.budget_s()));
  return *found;
}

std::string complaint(const Comparison& comparison, int digits, const Interruptible& monitor) {
  if (comparison.has_digits(digits)) return "";
  return fmt::format("{}: {}",
                     monitor.has_time()
                         ? "no precision is enough"
                         : fmt::format("a budget of {} s is not enough", monitor.budget_s()),
                     what_is_missing(comparison, digits));
}

RunResult result_of(const Comparison& comparison, const Scenario& scenario) {
  Scenario computed = scenario;
  const double finer = comparison.tolerance / Comparison::finer;
  computed.tolerance = number_in(fmt::format("{:.15g}", finer)).value_or(finer);  // 1e-22
  return {computed, comparison.values, {{}, comparison.counters}, {}, comparison.is_course_sure};
}

Json to_json(const Comparison& comparison, const Scenario& scenario, int digits) {
  Json json = to_json(result_of(comparison, scenario));
  add(comparison.summary, json);
  for (const auto& field : summary_fields<double>)
    if (!comparison.is_course_sure && (std::holds_alternative<Outcome Summary::*>(field.value) ||
                                       std::holds_alternative<long Summary::*>(field.value)))
      json[std::string(field.key)] = nullptr;
  Json short_ones = Json::array();
  for (const auto& [value, has] : short_of_digits(comparison, digits))
    short_ones.push_back({{"value", value}, {"digits", has}});
  json["digits"] = {{"asked", digits},
                    {"short", short_ones},
                    {"course_is_sure", comparison.is_course_sure},
                    {"precision", name_of(comparison.precision)}};
  json["events"] = Json::array();
  for (const EventEstimate& event : comparison.events) {
    Json row = {{"event", event.event == Event::none ? "end" : name_of(event.event)}};
    add(event.values, row);
    json["events"].push_back(row);
  }
  return json;
}

std::string rounded_to(double value, int digits) {
  std::string text = fmt::format("{:#.{}g}", value, digits);
  if (text.ends_with('.')) text.pop_back();     // fmt 10; with fmt 9 it ends in .0
  const std::size_t nothing = text.size() - 2;  // no digits follow the point
  if (text.ends_with(".0") && std::abs(value) >= 1 &&
      static_cast<int>(nothing) - (value < 0 ? 1 : 0) == digits)
    text.resize(nothing);
  return text;
}

std::string text_within(double value, double error, int digits) {
  if (error == 0) return fmt::format("{}", value);
  for (; digits > 0; --digits) {
    const auto rounded = [&](double number) { return rounded_to(number, digits); };
    if (rounded(value - error) == rounded(value + error)) return rounded(value);
  }
  return std::string(no_digit);
}

std::optional<std::string> sure_text(const Json& summary, const std::string& key, double unit) {
  const auto errors = summary.find("errors");
  if (errors == summary.end() || !errors->contains(key) || summary.at(key).is_null()) return {};
  return text_within(summary.at(key).get<double>() / unit, errors->at(key).get<double>() / unit,
                     summary.at("digits").at("asked").get<int>());
}

}  // namespace rotor
