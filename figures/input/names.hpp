/// The names of choices and events, and those of outcomes, in options, scene files and CSV.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "figures/data/text.hpp"
#include "figures/input/words.hpp"
#include "model/results/stop_on.hpp"

namespace rotor {

/// States what is wrong with an input, where, and what is allowed.
struct InputError : std::runtime_error {
  template <class... Args>
  explicit InputError(fmt::format_string<Args...> text, Args&&... args)
      : std::runtime_error(fmt::format(text, std::forward<Args>(args)...)) {}
};

template <class Kind>
using Named = std::pair<std::string_view, Kind>;

template <class Kind>
inline constexpr std::array<Named<Kind>, 0> names_of;

template <>
inline constexpr auto names_of<Equations> = std::to_array<Named<Equations>>(
    {{"published", Equations::published}, {"corrected", Equations::corrected}});
template <>
inline constexpr auto names_of<VelocityJump> = std::to_array<Named<VelocityJump>>(
    {{"once", VelocityJump::once}, {"twice", VelocityJump::twice}});
template <>
inline constexpr auto names_of<GravityMoment> = std::to_array<Named<GravityMoment>>(
    {{"balanced", GravityMoment::balanced}, {"whole", GravityMoment::whole}});
template <>
inline constexpr auto names_of<Drive> = std::to_array<Named<Drive>>(
    {{"motor", Drive::motor}, {"constant_speed", Drive::constant_speed}});
template <>
inline constexpr auto names_of<Method> = std::to_array<Named<Method>>({{"event", Method::event},
                                                                       {"rk4", Method::rk4}});
template <>
inline constexpr auto names_of<StopOn> = std::to_array<Named<StopOn>>({{"outcome", StopOn::outcome},
                                                                       {"rolling", StopOn::rolling},
                                                                       {"rest", StopOn::rest}});
template <>
inline constexpr auto names_of<Outcome> = [] {
  std::array<Named<Outcome>, outcomes.size()> names;
  for (std::size_t n = 0; n < names.size(); ++n) names[n] = {outcomes[n].name, outcomes[n].outcome};
  return names;
}();
template <>
inline constexpr auto names_of<Event> =
    std::to_array<Named<Event>>({{"none", Event::none},
                                 {"touch_down", Event::touch_down},
                                 {"release", Event::release},
                                 {"ring_clear", Event::ring_clear},
                                 {"renewed_contact", Event::renewed_contact},
                                 {"rolling_onset", Event::rolling_onset},
                                 {"slip_reversal", Event::slip_reversal},
                                 {"break_away", Event::break_away},
                                 {"motor_off", Event::motor_off},
                                 {"mass_loss", Event::mass_loss}});

template <class Kind>
std::vector<std::string_view> all_names() {
  std::vector<std::string_view> all;
  for (const auto& [name, kind] : names_of<Kind>) all.push_back(name);
  return all;
}

/// "mixed" for equations that are neither published nor corrected.
template <class Kind>
constexpr std::string_view name_of(Kind kind) {
  for (const auto& [name, named] : names_of<Kind>)
    if (named == kind) return name;
  return "mixed";
}

/// Throws InputError, listing the names.
template <class Kind>
Kind parse_name(std::string_view text) {
  for (const auto& [name, kind] : names_of<Kind>)
    if (name == text) return kind;
  throw InputError("must be one of: {}; not \"{}\"", fmt::join(all_names<Kind>(), ", "),
                   shown(text));
}

}  // namespace rotor
