#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
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
  const std::vector<std::pair<const char*, const char*>> columns = {
      {"run", "run"},
      {"outcome", "outcome"},
      {"touch_downs", "touch-downs"},
      {"first_contact_s", "contact, s"},
      {"rolling_onset_s", "rolling, s"},
      {"peak_normal_force_N", "force, N"},
      {"final_speed_Hz", "f at end, Hz"}};
  std::vector<std::string> lines(runs.size() + 1);
  for (const auto& [key, label] : columns) {
    std::vector<std::string> cells = {label};
    for (const Json& run : runs) cells.push_back(text_of(run.at(key), asked_digits(run)));
    std::size_t width = 0;
    for (const std::string& cell : cells) width = std::max(width, cell.size());
    for (std::size_t n = 0; n < cells.size(); ++n)
      lines[n] += fmt::format("{:<{}}", cells[n], key == columns.back().first ? 0 : width + 2);
  }
  for (const std::string& line : lines) fmt::print(to, "{}\n", line);
}

/// A result in the units of people, with four digits.
std::string in_unit(double value, double of_unit, const char* unit) {
  return fmt::format("{:.4g} {}", value / of_unit, unit);
}

std::string force(double newtons) {
  return std::abs(newtons) < 1000 ? in_unit(newtons, 1, "N") : in_unit(newtons, 1e3, "kN");
}
std::string elapsed(double seconds) {
  return std::abs(seconds) < 1 ? in_unit(seconds, 1e-3, "ms") : in_unit(seconds, 1, "s");
}
std::string millimetres(double metres) { return in_unit(metres, 1e-3, "mm"); }
std::string hertz(double value) { return in_unit(value, 1, "Hz"); }

/// What becomes of the rotor.
std::string outcome_of(const Json& run) {
  const auto outcome = parse_name<Outcome>(run.at("outcome").get<std::string>());
  const auto number = [&](const char* key) { return run.at(key).get<double>(); };
  const Json& inputs = run.at("inputs");
  const auto touch_downs = run.at("touch_downs_to_rolling").get<long>();
  const std::string times = fmt::format("{} time{}", touch_downs, touch_downs == 1 ? "" : "s");
  using enum Outcome;
  switch (outcome) {
    case rolling:
      return fmt::format("The rotor comes to roll on the ring {} after the first contact, at {}",
                         elapsed(number("rolling_onset_s") - number("first_contact_s")),
                         hertz(number("rolling_onset_speed_Hz")));
    case sliding:
      return "The rotor slides along the ring";
    case stalled:
      return "The rotor stalls below 1.5 times its critical speed";
    case freed:
      return fmt::format("The rotor touches the ring {} and comes free", times);
    case bouncing:
      return fmt::format("The rotor has touched the ring {}, and may touch it again", times);
    case no_contact:
      return fmt::format("The rotor does not touch the ring; the clearance is {}",
                         millimetres(inputs.at("stator_radius").get<double>() -
                                     inputs.at("rotor_radius").get<double>()));
    default:
      return "The rotor has not touched the ring yet, but still may";
  }
}

void say_what_is_assumed(bool leaves_equations_open, const std::vector<std::string>& of_paper) {
  if (leaves_equations_open)
    print_message(
        "rotor: no equations were stated, so the published ones were used: the velocity jump of "
        "the mass loss counts twice, and the moment of gravity in full; the corrected equations "
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

void print_brief(const Json& run, std::FILE* to) {
  const double loss_s = run.at("inputs").at("mass_loss_time").get<double>();
  const bool loses = run.at("mass_loss_reached") == true;  // may be open
  const auto instant = [&](double time_s) {
    return loses && time_s >= loss_s ? elapsed(time_s - loss_s) + " after the mass loss"
                                     : in_unit(time_s, 1, "s");
  };
  const auto ratio = [](double value) { return fmt::format("{:.4g}", value); };
  struct Row {
    const char *label, *key;
    std::function<std::string(double)> text;
  };
  const std::vector<Row> rows = {{"speed at the mass loss", "speed_at_mass_loss_Hz", hertz},
                                 {"  over the critical speed", "speed_ratio_at_mass_loss", ratio},
                                 {"first contact", "first_contact_s", instant},
                                 {"touch-downs", "touch_downs", ratio},
                                 {"onset of rolling", "rolling_onset_s", instant},
                                 {"  rotation speed", "rolling_onset_speed_Hz", hertz},
                                 {"  normal force", "rolling_onset_force_N", force},
                                 {"largest normal force", "peak_normal_force_N", force},
                                 {"  at", "peak_time_s", instant},
                                 {"largest displacement", "max_displacement_m", millimetres},
                                 {"largest force on the bearings", "peak_bearing_force_N", force},
                                 {"mean whirl in the last rolling", "whirl_frequency_Hz", hertz},
                                 {"end of rolling", "rolling_until_s", instant},
                                 {"end of the run", "final_time_s", instant},
                                 {"  rotation speed", "final_speed_Hz", hertz}};
  const Json& whole = run.at("peak_normal_force_N");  // empty in a run that stops early
  const Json& peak = whole.is_null() ? run.at("peak_force_to_rolling_N") : whole;
  fmt::print(to, "{}{}.\n", outcome_of(run),
             peak.is_null()
                 ? ""
                 : fmt::format("; largest normal force {}{}", whole.is_null() ? "so far " : "",
                               force(peak.get<double>())));
  for (const Json& remark : run.at("remarks"))
    fmt::print(to, "Note: {}.\n", remark.get<std::string>());
  fmt::print(to, "\n");
  for (const Row& row : rows)
    if (const Json& value = run.at(row.key); !value.is_null())
      fmt::print(to, "  {:<31} {}\n", row.label, row.text(value.get<double>()));
  fmt::print(to, "  {}\n", equations_in_words(run.at("equations").get<std::string>()));
  if (run.contains("energy_J")) print_values(Json{{"energy_J", run["energy_J"]}}, 0, to, "  ");
  fmt::print(to, "\nAll results: --all, or --json with all digits.\n");
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
