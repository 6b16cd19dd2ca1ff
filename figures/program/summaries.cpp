#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "figures/program/commands.hpp"
#include "figures/results/estimated_result.hpp"

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
  std::vector<std::string> lines(runs.size() + 2);  // heads have two
  const auto add = [&](std::string_view key, const std::string& label) {
    const std::size_t last = label.rfind(' ', label.find(',')) + 1;  // word, with its unit
    std::vector<std::string> cells = {label.substr(0, last), label.substr(last)};
    for (const Json& run : runs)
      cells.push_back(text_of(run.at(std::string(key)), asked_digits(run)));
    std::size_t width = 0;
    for (const std::string& cell : cells) width = std::max(width, cell.size());
    for (std::size_t n = 0; n < cells.size(); ++n)
      lines[n] += fmt::format("{:<{}}", cells[n], width + 2);
  };
  add("run", "run");
  add("outcome", "outcome");
  for (const auto& [key, label, is_in_table] : results_in_words)
    if (is_in_table)
      add(key, fmt::format("{}{}", label,
                           key.ends_with("_N")    ? ", N"
                           : key.ends_with("_s")  ? ", s"
                           : key.ends_with("_Hz") ? ", Hz"
                                                  : ""));
  for (const std::string& line : lines)
    fmt::print(to, "{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
}

/// A result in the unit of people that follows from its key's, with four digits.
std::string in_print(std::string_view key, double value) {
  const auto shown = [](double number, const char* unit) {
    return fmt::format("{:.4g}{}", number, unit);
  };
  const bool is_small = std::abs(value) < 1;
  if (key.ends_with("_N"))
    return std::abs(value) < 1e3   ? shown(value, " N")
           : std::abs(value) < 1e6 ? shown(value / 1e3, " kN")
                                   : shown(value / 1e6, " MN");
  if (key.ends_with("_s")) return is_small ? shown(1e3 * value, " ms") : shown(value, " s");
  if (key.ends_with("_m")) return shown(1e3 * value, " mm");
  return shown(value, key.ends_with("_Hz") ? " Hz" : "");
}

/// What becomes of the rotor.
std::string outcome_of(const Json& run) {
  const auto name = run.at("outcome").get<std::string>();
  const auto number = [&](const char* key) { return run.at(key).get<double>(); };
  const auto* const its = std::find_if(outcomes.begin(), outcomes.end(),
                                       [&](const OutcomeInWords& of) { return of.name == name; });
  std::string sentence = fmt::format("The rotor {}", its->sentence);
  if (its->outcome == Outcome::rolling)
    sentence += fmt::format(" {} after the first contact, at {}",
                            in_print("_s", number("rolling_onset_s") - number("first_contact_s")),
                            in_print("_Hz", number("rolling_onset_speed_Hz")));
  if (its->outcome == Outcome::no_contact)
    sentence += fmt::format("; the clearance is {}",
                            in_print("_m", run.at("inputs").at("stator_radius").get<double>() -
                                               run.at("inputs").at("rotor_radius").get<double>()));
  return sentence;
}

void say_what_is_assumed(const std::vector<std::string>& of_paper) {
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
  const auto text = [&](std::string_view key, double value) {
    if (!key.ends_with("_s")) return in_print(key, value);
    return loses && value >= loss_s ? in_print(key, value - loss_s) + " after the mass loss"
                                    : fmt::format("{:.4g} s", value);
  };
  const Json& whole = run.at("peak_normal_force_N");  // empty in a run that stops early
  const Json& peak = whole.is_null() ? run.at("peak_force_to_rolling_N") : whole;
  fmt::print(to, "{}{}.\n", outcome_of(run),
             peak.is_null()
                 ? ""
                 : fmt::format("; largest normal force {}{}", whole.is_null() ? "so far " : "",
                               in_print("_N", peak.get<double>())));
  for (const Json& remark : run.at("remarks"))
    fmt::print(to, "Note: {}.\n", remark.get<std::string>());
  fmt::print(to, "\n");
  for (const ResultInWords& result : results_in_words)
    if (const Json& value = run.at(std::string(result.key)); !value.is_null())
      fmt::print(to, "  {:<31} {}\n", result.label, text(result.key, value.get<double>()));
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
  for (const SceneRun& run : runs) {
    if (!is_own_rotor(run.stated)) continue;
    for (const std::string& quantity : left_to_the_paper(run.stated))
      if (!contains(of_paper, quantity)) of_paper.push_back(quantity);
  }
  say_what_is_assumed(of_paper);
}

void say_what_is_assumed(const Sweep& sweep) {
  if (is_own_rotor(sweep.base)) say_what_is_assumed(left_to_the_paper(SweepPoints(sweep)(0).spec));
}

}  // namespace rotor
