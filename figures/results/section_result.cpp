#include "figures/results/section_result.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rotor {

std::optional<double> phase(const std::complex<double>& mean) {
  return mean == 0. ? std::nullopt : std::optional(std::arg(mean));
}

const std::vector<SectionValue>& section_values() {
  static const std::vector<SectionValue> all = {
      {"section_turns", "The number of turns in the section", "integer",
       [](const SectionSummary& s) { return Json(s.turns); }},
      {"repeats_after_turns",
       fmt::format(
           "After how many turns position and velocity of O come back, in all turns of the "
           "section, to within a millionth of the clearance, and of the clearance times the "
           "speed; null if after none up to {}, or half of the turns",
           SectionSummary::longest_period),
       "integer",
       [](const SectionSummary& s) {
         return s.repeats_after_turns ? Json(*s.repeats_after_turns) : Json();
       }},
      {"orders_over_turns",
       "The number of last turns over which the means of orders are taken: a multiple of six, and "
       "of repeats_after_turns if there are so many",
       "integer", [](const SectionSummary& s) { return Json(s.orders_over_turns); }},
      {"orders_over_whole_periods",
       "Whether that is a multiple of repeats_after_turns; null over less than six turns",
       "boolean", [](const SectionSummary& s) {
         return s.orders_over_turns > 0 ? Json(s.orders_over_whole_periods) : Json();
       }}};
  return all;
}

std::string key_of(const Order& order, const OrderValue& value) {
  std::string name(order.name);
  std::replace(name.begin(), name.end(), '/', '_');
  return fmt::format("order_{}_{}", name, value.ending);
}

std::optional<std::string> order_in_words(std::string_view key) {
  for (const Order& order : orders)
    for (const OrderValue& value : order_values)
      if (key_of(order, value) == key) return fmt::format("order {}, {}", order.name, value.words);
  return std::nullopt;
}

std::vector<std::string> section_columns() {
  std::vector<std::string> keys;
  const Json all = to_json(SectionSummary{});
  for (const auto& [key, value] : all.items()) keys.push_back(key);
  return keys;
}

Json to_json(const SectionSummary& section) {
  Json all;
  for (const SectionValue& value : section_values())
    all[std::string(value.key)] = value.of(section);
  for (std::size_t n = 0; n < orders.size(); ++n)
    for (const OrderValue& value : order_values)
      all[key_of(orders[n], value)] =
          section.orders_over_turns > 0 ? json_of(value.of(section.means[n])) : Json();
  return all;
}

Json section_schema() {
  const auto described = [](std::string_view type, const std::string& meaning) {
    return Json{{"type", {type, "null"}}, {"description", meaning}};
  };
  Json values, of_orders;
  for (const SectionValue& value : section_values())
    values[std::string(value.key)] = described(value.type, value.meaning);
  for (const OrderValue& value : order_values)
    of_orders[fmt::format("^order_.*_{}$", value.ending)] = described(
        "number", fmt::format("{} at the order o of the rotation, 1_2 for 1/2", value.meaning));
  return {{"type", "object"},
          {"description",
           "Only with --section: of the turns that it lists. F(o) is the mean of z exp(-i o phi), "
           "z = x_a + i y_a the position of O, phi the angle turned since the start"},
          {"properties", values},
          {"patternProperties", of_orders}};
}

}  // namespace rotor
