#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>

#include "figures/program/commands.hpp"
#include "figures/results/certified_result.hpp"

namespace rotor {
namespace {

/// Names and values; those of a part follow its name. Inputs have fifteen digits.
void print_values(const Json& object, int digits, std::FILE* to, const std::string& indent = "",
                  bool are_inputs = false) {
  for (const auto& [key, value] : object.items()) {
    const std::string name = indent + key;
    const auto print = [&](const std::string& text) { fmt::print(to, "{:<32} {}\n", name, text); };
    if (value.is_object() && !value.contains("error")) {
      fmt::print(to, "{}\n", name);
      print_values(value, digits, to, indent + "  ", key == "inputs");
    } else if (are_inputs && value.is_number()) {
      print(fmt::format("{:.15g}", value.get<double>()));
    } else if (key == "remarks" && !value.empty()) {
      for (const Json& remark : value) print(remark.get<std::string>());
    } else if (key != "events") {
      print(text_of(value, digits));
    }
  }
}

/// Several runs, one row each.
void print_table(const Json& runs, std::FILE* to) {
  const auto keys = {"run",
                     "outcome",
                     "touch_downs",
                     "first_contact_s",
                     "rolling_onset_s",
                     "peak_normal_force_N",
                     "final_speed_Hz"};
  const auto cell = [](const Json& run, const char* key) {
    return text_of(run.at(key), asked_digits(run));
  };
  std::size_t width = 20;  // names may need more
  for (const Json& run : runs) width = std::max(width, cell(run, "run").size());
  const auto print = [&](const char* key, const std::string& text) {
    fmt::print(to, "{:<{}} ", text, key == *keys.begin() ? width : 20);
  };
  for (const char* key : keys) print(key, key);
  for (const Json& run : runs) {
    fmt::print(to, "\n");
    for (const char* key : keys) print(key, cell(run, key));
  }
  fmt::print(to, "\n");
}

void say_what_is_assumed(bool leaves_equations_open, const std::vector<std::string>& of_paper) {
  if (leaves_equations_open)
    print_message(
        "rotor: no equations were stated, so the published ones were used: the velocity jump of "
        "the mass loss counts twice, and the moment of gravity in full; the consistent equations "
        "correct both");
  if (!of_paper.empty())
    print_message(fmt::format("rotor: not stated, so the paper's: {}", fmt::join(of_paper, ", ")));
}

}  // namespace

void print_summary(const Json& run, bool as_json, std::FILE* to) {
  if (as_json)
    fmt::print(to, "{}\n", run.dump(2));
  else
    print_values(run, asked_digits(run), to);
}

void print_summaries(const Json& runs, bool as_json, std::FILE* to) {
  if (as_json)
    fmt::print(to, "{}\n", Json{{"runs", runs}}.dump(2));
  else if (!runs.empty())
    print_table(runs, to);
}

void say_what_is_assumed(const std::vector<SceneRun>& runs) {
  std::vector<std::string> of_paper;
  bool leaves_equations_open = false;
  for (const SceneRun& run : runs) {
    leaves_equations_open = leaves_equations_open || run.leaves_equations_open();
    if (!is_own_rotor(run.stated)) continue;
    for (const std::string& quantity : left_to_the_paper(run.stated))
      if (!contains(of_paper, quantity)) of_paper.push_back(quantity);
  }
  say_what_is_assumed(leaves_equations_open, of_paper);
}

void say_what_is_assumed(const Sweep& sweep) {
  const ScenarioSpec first = SweepPoints(sweep)(0).spec;
  say_what_is_assumed(!first.states_equations(), is_own_rotor(sweep.base)
                                                     ? left_to_the_paper(first)
                                                     : std::vector<std::string>());
}

}  // namespace rotor
