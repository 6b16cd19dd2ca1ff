#include "figures/results/certified_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rotor {
namespace {

Json to_json(const NamedEstimate& value) {
  if (!value.estimate) return nullptr;
  return {{"value", value.estimate->value}, {"error", value.estimate->error}};
}

}  // namespace

std::vector<ShortOfDigits> short_of_digits(const Comparison& comparison, int digits) {
  std::vector<ShortOfDigits> all;
  const auto look_at = [&](const std::string& where, const NamedEstimate& value) {
    const int sure = sure_digits(value);
    if (value.estimate && sure < digits) all.push_back({where + std::string(value.name), sure});
  };
  for (const NamedEstimate& value : comparison.summary) look_at("", value);
  for (std::size_t i = 0; i < comparison.events.size(); ++i)
    for (const NamedEstimate& value : comparison.events[i].values)
      look_at(fmt::format("events[{}].", i), value);
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.digits < b.digits; });
  return all;
}

std::string complaint(const Comparison& comparison, int digits) {
  if (has_digits(comparison, digits)) return "";
  std::string text;
  if (!comparison.same_course) {
    text = fmt::format(
        "counts and outcome cannot be determined at this precision: computations agree only on the "
        "first {} events",
        comparison.events.size() - 1);
  } else if (!comparison.is_course_sure()) {
    text =
        "counts and outcome cannot be determined at this precision: a glancing contact, or an "
        "event "
        "near the mass loss or the end, is closer than its error";
  } else if (const auto all = short_of_digits(comparison, digits); !all.empty()) {
    text = fmt::format("{} has {} of {} digits", all.front().value, all.front().digits, digits);
    if (all.size() > 1) text += fmt::format(", and {} others have too few", all.size() - 1);
  }
  if (comparison.amplification)
    text += fmt::format("; a disturbance grows by a factor of {:.1e} from the first contact on",
                        *comparison.amplification);
  return text;
}

RunResult result_of(const Comparison& comparison, const Scenario& scenario) {
  Scenario computed = scenario;
  computed.tolerance = comparison.tolerance / Comparison::finest;
  double largest = 0;
  for (const NamedEstimate& value : comparison.summary)
    if (value.estimate && value.estimate->error > 0)
      largest = std::max(largest, value.estimate->error / value.size);
  return {computed,
          comparison.values,
          comparison.end,
          {},
          std::isfinite(largest) ? std::optional(largest) : std::nullopt};
}

Json to_json(const Comparison& comparison, const Scenario& scenario, int digits) {
  Json json = to_json(result_of(comparison, scenario));
  for (const NamedEstimate& value : comparison.summary) json[value.name] = to_json(value);
  Json short_ones = Json::array();
  for (const auto& [value, sure] : short_of_digits(comparison, digits))
    short_ones.push_back({{"value", value}, {"digits", sure}});
  json["digits"] = {{"asked", digits},
                    {"short", short_ones},
                    {"course_is_sure", comparison.is_course_sure()},
                    {"precision", name_of(comparison.precision)},
                    {"amplification_from_first_contact", nullptr}};
  if (comparison.amplification)
    json["digits"]["amplification_from_first_contact"] = *comparison.amplification;
  json["events"] = Json::array();
  for (const EventEstimate& event : comparison.events) {
    Json row = {{"event", event.event == Event::none ? "end" : name_of(event.event)}};
    for (const NamedEstimate& value : event.values) row[value.name] = to_json(value);
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

std::string certified_text(double value, double error, int digits) {
  if (error == 0) return fmt::format("{}", value);
  for (; digits > 0; --digits) {
    const auto rounded = [&](double number) { return rounded_to(number, digits); };
    if (rounded(value - error) == rounded(value + error)) return rounded(value);
  }
  return std::string(no_sure_digit);
}

std::string text_of(const Json& value, int digits) {
  if (value.is_null()) return "-";
  if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
  if (value.is_string()) return value.get<std::string>();
  if (value.is_array())
    return value.empty() ? "-" : fmt::format("{} values; --json has them", value.size());
  if (!value.is_object() || !value.contains("error")) return value.dump();
  return certified_text(value["value"].get<double>(), value["error"].get<double>(), digits);
}

int asked_digits(const Json& summary) {
  return summary.contains("digits") ? summary["digits"]["asked"].get<int>() : 0;
}

}  // namespace rotor
