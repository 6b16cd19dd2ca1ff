#include "figures/program/summaries.hpp"

#include <fmt/format.h>

#include <string>

#include "figures/scenes/certain_account.hpp"

namespace rotor {
namespace {

using Json = nlohmann::ordered_json;

/// Names and values, those of a part under its name.
void print_values(const Json& object, int digits, const std::string& indent, std::FILE* to) {
  for (const auto& [key, value] : object.items()) {
    const std::string name = indent + key;
    if (value.is_object() && !value.contains("error")) {
      fmt::print(to, "{}\n", name);
      print_values(value, digits, indent + "  ", to);
    } else if (key != "events") {
      fmt::print(to, "{:<24} {}\n", name, text_of(value, digits));
    }
  }
}

/// Several runs, a row each.
void print_table(const Json& runs, std::FILE* to) {
  const auto keys = {"run",
                     "outcome",
                     "collisions",
                     "first_contact_s",
                     "rolling_onset_s",
                     "peak_normal_force_N",
                     "final_speed_Hz"};
  for (const char* key : keys) fmt::print(to, "{:<20} ", key);
  for (const Json& run : runs) {
    fmt::print(to, "\n");
    for (const char* key : keys) {
      const Json& value = run.at(key);
      fmt::print(to, "{:<20} ",
                 value.is_string() ? value.get<std::string>() : text_of(value, asked_digits(run)));
    }
  }
  fmt::print(to, "\n");
}

}  // namespace

void print_summaries(const Json& runs, bool as_json, std::FILE* to) {
  const bool is_one = runs.size() == 1;
  if (as_json)
    fmt::print(to, "{}\n", (is_one ? runs.front() : Json{{"runs", runs}}).dump(2));
  else if (is_one)
    print_values(runs.front(), asked_digits(runs.front()), "", to);
  else
    print_table(runs, to);
}

}  // namespace rotor
