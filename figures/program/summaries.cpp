#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <string>

#include "figures/program/commands.hpp"
#include "figures/results/estimated_result.hpp"
#include "figures/results/laws.hpp"
#include "figures/results/section_result.hpp"

namespace rotor {
namespace {

/// Six digits of a number, or those that are estimated; "-" for nothing.
std::string text_of(const Json& object, const std::string& key) {
  const Json& value = object.at(key);
  if (const auto sure = sure_text(object, key)) return *sure;
  if (value.is_null() || (value.is_array() && value.empty())) return "-";
  if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string four_digits(double number) {
  return fmt::format("{:.{}g}", number, std::abs(number) < 1e4 ? 4 : 6);
}

/// The unit in which people read a result, and its size; from that of its key.
std::pair<const char*, double> unit_of(std::string_view key, double value, bool in_rpm) {
  using Unit = std::pair<const char*, double>;
  const double size = std::abs(value);
  if (key.ends_with("_N"))
    return size < 1e3 ? Unit(" N", 1) : size < 1e6 ? Unit(" kN", 1e3) : Unit(" MN", 1e6);
  if (key.ends_with("_s")) return size < 1 ? Unit(" ms", 1e-3) : Unit(" s", 1);
  if (key.ends_with("_m")) return {" mm", 1e-3};
  if (!key.ends_with("_Hz")) return {"", 1};
  return in_rpm && key.find("speed") != std::string_view::npos ? Unit(" rpm", 1 / 60.)
                                                               : Unit(" Hz", 1);
}

/// Four digits in that unit.
std::string in_units(std::string_view key, double value, bool in_rpm) {
  const auto [unit, in_si] = unit_of(key, value, in_rpm);
  return four_digits(value / in_si) + unit;
}

/// A result in that unit, with four digits or those that are estimated; otherwise times are after
/// the mass loss.
std::string in_print(const Json& run, const std::string& key, bool in_rpm, bool in_table = false) {
  if (!run.at(key).is_number_float()) return text_of(run, key);
  auto value = run.at(key).get<double>();
  const double loss_s = run.at("inputs").at("mass_loss_time").get<double>();
  const bool is_after_loss = key.ends_with("_s") && key != "contact_time_s" &&
                             run.at("mass_loss_reached") == true && value >= loss_s &&
                             !run.contains("errors");
  if (is_after_loss) value -= loss_s;
  const auto [unit, in_si] = unit_of(key, value, in_rpm);
  const auto sure = sure_text(run, key, in_si);
  const std::string text = sure ? *sure : four_digits(value / in_si);
  return (is_after_loss && in_table ? "+" : "") + text + unit +
         (is_after_loss && !in_table ? " after the mass loss" : "");
}

/// What becomes of the rotor.
std::string outcome_of(const Json& run, bool in_rpm) {
  const auto name = run.at("outcome").get<std::string>();
  const auto number = [&](const char* key) { return run.at(key).get<double>(); };
  const auto* const words = std::find_if(outcomes.begin(), outcomes.end(),
                                         [&](const OutcomeInWords& of) { return of.name == name; });
  std::string sentence = fmt::format("the rotor {}", words->sentence);
  if (words->outcome == Outcome::rolling) {
    const double time_s = number("rolling_onset_s") - number("first_contact_s");
    sentence += fmt::format(" {} after the first contact, at {}", in_units("_s", time_s, in_rpm),
                            in_print(run, "rolling_onset_speed_Hz", in_rpm));
  }
  if (words->outcome == Outcome::no_contact) {
    const Json& inputs = run["inputs"];
    const auto in_mm = [](double length_m) { return four_digits(1e3 * length_m); };
    const double clearance =
        inputs["stator_radius"].get<double>() - inputs["rotor_radius"].get<double>();
    const double start = inputs["start_x"].is_null() ? 0
                                                     : std::hypot(inputs["start_x"].get<double>(),
                                                                  inputs["start_y"].get<double>());
    sentence += fmt::format("; the clearance is {} mm", in_mm(clearance));
    if (start > clearance)
      sentence += fmt::format(
          ", and the rotor leaves its start, {} mm beyond it, so fast that the "
          "ring does not press on it",
          in_mm(start - clearance));
  }
  return sentence;
}

void print_notes(const Json& result, std::FILE* to) {
  for (const Json& remark : result.at("remarks"))
    fmt::print(to, "Note: {}.\n", remark.get<std::string>());
  fmt::print(to, "\n");
}

/// "Corrected equations"
std::string equations_of(const Json& result) {
  std::string words(equations_in_words(result.at("equations").get<std::string>()));
  words.front() = static_cast<char>(std::toupper(words.front()));
  return words;
}

/// After how many turns the motion repeats, and its orders in a table.
void print_section(const Json& section, std::FILE* to) {
  for (const char* key : {"section_turns", "repeats_after_turns", "orders_over_turns"})
    fmt::print(to, "  {:<31} {}\n", name_in_words(key), text_of(section, key));
  if (section.at("orders_over_turns") == 0) return;
  fmt::print(to, "\n{:<8}{:>12}{:>24}{:>30}\n{:<8}", "", "forward", "backward", "peak to peak, mm",
             "  order");
  for (const char* head : {"mm", "rad", "mm", "rad", "x_a", "y_a"}) fmt::print(to, "{:>12}", head);
  fmt::print(to, "\n");
  for (const Order& order : orders) {
    fmt::print(to, "  {:<6}", order.name);
    for (const OrderValue& column : order_values) {
      const Json& value = section.at(key_of(order, column));
      const double in_si = column.ending.ends_with("_m") ? 1e-3 : 1;
      fmt::print(to, "{:>12}", value.is_null() ? "-" : four_digits(value.get<double>() / in_si));
    }
    fmt::print(to, "\n");
  }
}

constexpr auto about_other_results = "\nAll results: --all, or --json with all digits.\n";

void say_what_is_assumed(const std::vector<std::string>& of_paper) {
  if (!of_paper.empty())
    print_message(fmt::format("rotor: not stated, so the paper's: {}", fmt::join(of_paper, ", ")));
}

}  // namespace

void print_all(const Json& object, std::FILE* to, const std::string& indent, bool are_inputs) {
  if (object.contains("equations")) fmt::print(to, "{}\n", equations_of(object));
  for (const auto& [key, value] : object.items()) {
    const std::string name = indent + key;
    const auto print = [&](const std::string& text) { fmt::print(to, "{:<32} {}\n", name, text); };
    if (key == "errors" || key == "events" || key == "short") continue;  // for JSON
    if (value.is_object()) {
      fmt::print(to, "{}\n", name);
      print_all(value, to, indent + "  ", key == "inputs");
    } else if (are_inputs && value.is_number()) {
      print(fmt::format("{:.15g}", value.get<double>()));
    } else if (key == "remarks" && !value.empty()) {
      for (const Json& remark : value) print(remark.get<std::string>());
    } else {
      print(text_of(object, key));
    }
  }
}

void print_brief(const Json& run, bool in_rpm, std::FILE* to) {
  const bool is_whole = !run.at("peak_normal_force_N").is_null();  // or the run stopped early
  const char* const peak = is_whole ? "peak_normal_force_N" : "peak_force_to_rolling_N";
  fmt::print(to, "{}: {}{}.\n", equations_of(run), outcome_of(run, in_rpm),
             run.at(peak).is_null()
                 ? ""
                 : fmt::format("; largest normal force {}{}", is_whole ? "" : "so far ",
                               in_print(run, peak, in_rpm)));
  print_notes(run, to);
  for (const auto& [key, label, is_in_table] : results_in_words)
    if (const std::string name(key); !run.at(name).is_null())
      fmt::print(to, "  {:<31} {}\n",
                 name == "peak_displacement_m" && run.at("mass_loss_reached") == true
                     ? fmt::format("{} after loss", label)
                     : label,
                 in_print(run, name, in_rpm));
  if (run.contains("energy_J")) print_all(Json{{"energy_J", run["energy_J"]}}, to, "  ");
  if (run.contains("section")) print_section(run["section"], to);
  fmt::print(to, about_other_results);
}

void print_laws(const Json& runs, bool in_rpm, std::FILE* to) {
  const Law& contact = all_laws().front();
  for (const Json& run : runs) {
    const bool touches = run.at(std::string(contact.key)).get<bool>();
    fmt::print(to, "{}{}: the rotor {} the ring, {}.\n",
               run.contains("run") ? run["run"].get<std::string>() + ": " : "", equations_of(run),
               touches ? "touches" : "does not touch", contact.assumption);
    print_notes(run, to);
    for (const Law& law : all_laws()) {
      const Json& value = run.at(std::string(law.key));
      if (&law == &contact || (value.is_null() && !touches && law.none == no_value)) continue;
      const std::string text =
          value.is_null() ? std::string(law.none) : in_units(law.key, value.get<double>(), in_rpm);
      fmt::print(to, "  {:<30} {:<9} {}\n", law.label, text, law.assumption);
    }
    fmt::print(to, "\n");
  }
  fmt::print(to, "{}{}", assumption_of_laws, about_other_results);
}

void print_table(const Json& runs, bool in_rpm, std::FILE* to) {
  std::vector<std::string> lines(runs.size() + 2);  // heads have two
  bool has_times_after_loss = false;
  const auto add = [&](const std::string& key, std::string_view label) {
    const std::size_t last = label.rfind(' ') + 1;
    std::vector<std::string> cells = {std::string(label.substr(0, last)),
                                      std::string(label.substr(last))};
    std::size_t width = 0;
    for (const Json& run : runs) cells.push_back(in_print(run, key, in_rpm, true));
    for (const std::string& cell : cells) width = std::max(width, cell.size());
    if (key.ends_with("_s"))
      for (const std::string& cell : cells)
        has_times_after_loss = has_times_after_loss || cell.starts_with('+');
    for (std::size_t n = 0; n < cells.size(); ++n)
      lines[n] += fmt::format("{:<{}}", cells[n], width + 2);
  };
  add("run", "run");
  add("outcome", "outcome");
  const Json& first = runs.front().at("equations");
  if (std::ranges::any_of(runs, [&](const Json& run) { return run.at("equations") != first; }))
    add("equations", "equations");
  else
    fmt::print(to, "{}\n\n", equations_of(runs.front()));
  for (const auto& [key, label, is_in_table] : results_in_words)
    if (is_in_table) add(std::string(key), label);
  for (const std::string& line : lines)
    fmt::print(to, "{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
  if (has_times_after_loss) fmt::print(to, "\n+: after the mass loss\n");
  for (const Json& run : runs)
    if (run.contains("section")) {
      fmt::print(to, "\n{}\n", run["run"].get<std::string>());
      print_section(run["section"], to);
    }
  if (runs.front().contains("errors")) fmt::print(to, "\ntimes since the start of the run\n");
}

void say_how_many_have_remarks(long remarked, long points) {
  if (remarked > 0)
    print_message(
        fmt::format("rotor: {} of {} points have remarks (column remarks)", remarked, points));
}

void say_what_is_assumed(const Scene& scene) {
  std::error_code error;  // no file
  if (std::filesystem::equivalent(scene.file.parent_path(), figures_folder() / "paper", error))
    return;
  std::vector<std::string> of_paper;
  for (const SceneRun& run : scene.runs)
    for (const std::string& quantity : left_to_the_paper(run.stated))
      if (!contains(of_paper, quantity)) of_paper.push_back(quantity);
  say_what_is_assumed(of_paper);
}

void say_what_is_assumed(const Sweep& sweep) {
  say_what_is_assumed(left_to_the_paper(SweepPoints(sweep)(0).spec));
}

}  // namespace rotor
