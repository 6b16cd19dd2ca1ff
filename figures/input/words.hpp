/// What people are shown of outcomes, equations and results, in text, pictures and on the page:
/// their words and colours. `make approve` writes figures/paper/palette.gp and the page's words.js
/// from here.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "model/results/outcome.hpp"

namespace rotor {

/// An outcome: its name in files, its colour on paper and light pages and on dark ones, what
/// follows "The rotor", and its definition.
struct OutcomeInWords {
  Outcome outcome;
  std::string_view name, light, dark, sentence, meaning;
};

/// In the order of pictures. Their colours differ in lightness, so also in grey.
inline constexpr auto outcomes = std::to_array<OutcomeInWords>(
    {{Outcome::no_contact, "no_contact", "#f7f7f5", "#20262c",
      "does not touch the ring up to the end of the run",
      "there was no contact, and the free rotor cannot reach the ring at this speed"},
     {Outcome::undecided, "undecided", "#efe0a0", "#453d1f",
      "has not touched the ring so far, but contact is possible",
      "there was no contact, but one is possible"},
     {Outcome::freed, "freed", "#a5d4b8", "#33604c",
      "has touched the ring, and cannot reach it again at its speed",
      "there were contacts, but the free rotor cannot reach the ring at this speed"},
     {Outcome::bouncing, "bouncing", "#62b08c", "#48917a",
      "bounces, and further contacts are possible", "there were contacts, and more are possible"},
     {Outcome::sliding, "sliding", "#1f6b52", "#a5e3cb", "slides along the ring",
      "the last contact has lasted longer than a natural period of the contact"},
     {Outcome::rolling, "rolling", "#bf5b98", "#d77db4", "has come to roll along the ring",
      "rolling, contact without slip that friction holds, has set in, whatever followed"},
     {Outcome::stalled, "stalled", "#333333", "#ebebe6",
      "is below 1.5 times its critical speed and gains less than a tenth of what its motor would "
      "add",
      "the speed is below 1.5 times the critical speed, over ten natural periods the motor raised "
      "it "
      "by less than a tenth of what it would without resistance, and no backward whirl along the "
      "ring brakes it"}});

/// Of a point without a result, as pictures show it beside outcomes.
inline constexpr std::string_view no_result = "no result", no_result_light = "#b0b0b0";

struct EquationsInWords {
  std::string_view name, light, dark, words, short_words;
};

inline constexpr auto sets_in_words = std::to_array<EquationsInWords>(
    {{"published", "#0072b2", "#56b4e9", "equations as printed", "as printed"},
     {"corrected", "#b34700", "#f0934f", "corrected equations", "corrected"}});

/// What else has one colour in all pictures; instants share that of axes.
inline constexpr auto others_in_words =
    std::to_array<EquationsInWords>({{"paper", "#707070", "#a3adb7", "the paper's values", "paper"},
                                     {"law", "#7a0177", "#d59ae0", "closed forms", "closed form"},
                                     {"event", "#000000", "#ffffff", "events", "event"}});

/// Where a closed form equals what it is compared with, as maps show it: its column of map-theory,
/// its width and pattern of dashes and gaps, and the outcomes with the motion that it assumes.
struct LineInWords {
  std::string_view name;
  double width;
  std::string_view dashes, words;
  std::array<Outcome, 2> assumed;
};

inline constexpr std::array free_motion = {Outcome::no_contact, Outcome::undecided};
inline constexpr auto lines_in_words = std::to_array<LineInWords>(
    {{"greatest", 2, "", "closed forms: border of contact", free_motion},
     {"bound", 1.6, "5,4", "upper bound of the swing reaches the ring", free_motion},
     {"steady", 1.6, "1,4", "steady response reaches the ring", free_motion},
     {"forward",
      1.6,
      "14,4",
      "friction up to which forward rub lasts",
      {Outcome::sliding, Outcome::sliding}},
     {"rebound",
      1.6,
      "10,4,2,4",
      "friction from which rebounds lead to backward whirl",
      {Outcome::bouncing, Outcome::freed}},
     {"peak",
      1.6,
      "14,4,2,4,2,4",
      "largest force of 300 kN",
      {Outcome::rolling, Outcome::rolling}}});

/// What summaries call equations by their name, "mixed" and "corrected" included.
constexpr std::string_view equations_in_words(std::string_view name) {
  for (const EquationsInWords& set : sets_in_words)
    if (name == set.name || name == set.short_words) return set.words;
  return "equations corrected in part";
}

/// A result by its key, as short summaries show it; and whether the table of several runs does.
struct ResultInWords {
  std::string_view key, label;
  bool is_in_table = false;
};

inline constexpr auto results_in_words = std::to_array<ResultInWords>({
    {"speed_at_mass_loss_Hz", "speed at the mass loss"},
    {"speed_ratio_at_mass_loss", "speed over the critical speed"},
    {"touch_downs", "touch-downs", true},
    {"first_contact_s", "first contact", true},
    {"rolling_onset_s", "onset of rolling", true},
    {"rolling_onset_speed_Hz", "speed at the onset of rolling"},
    {"rolling_onset_force_N", "force at the onset of rolling"},
    {"peak_normal_force_N", "largest normal force", true},
    {"peak_time_s", "time of the largest force"},
    {"peak_displacement_m", "largest displacement"},
    {"contact_time_s", "time in contact"},
    {"peak_bearing_force_N", "bearing force without weight"},
    {"whirl_frequency_Hz", "mean whirl in the last rolling"},
    {"rolling_until_s", "end of rolling"},
    {"final_time_s", "end of the run"},
    {"final_speed_Hz", "speed at the end", true},
});

/// A name with spaces, without the unit of a speed.
inline std::string name_in_words(std::string_view name) {
  for (const std::string_view unit : {"_Hz", "_rpm"})
    if (name.ends_with(unit)) name.remove_suffix(unit.size());
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

/// The content of figures/paper/palette.gp, in which gnuplot reads these.
std::string palette_of_gnuplot();

}  // namespace rotor
