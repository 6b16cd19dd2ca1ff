#include "figures/input/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <vector>

#include "figures/data/text.hpp"

namespace rotor {
namespace {

template <class Kind>
struct Named {
  std::string_view name;
  Kind kind;
};

template <class Kind>
Named(const char*, Kind) -> Named<Kind>;  // clang 14 does not deduce it

template <class Kind>
constexpr std::array<Named<Kind>, 0> names_of;

template <>
constexpr std::array names_of<Equations> = {Named{"published", Equations::published},
                                            Named{"consistent", Equations::consistent}};
template <>
constexpr std::array names_of<VelocityJump> = {Named{"once", VelocityJump::once},
                                               Named{"twice", VelocityJump::twice}};
template <>
constexpr std::array names_of<GravityMoment> = {Named{"balanced", GravityMoment::balanced},
                                                Named{"whole", GravityMoment::whole}};
template <>
constexpr std::array names_of<Method> = {Named{"event", Method::event}, Named{"rk4", Method::rk4}};

template <>
constexpr std::array names_of<Event> = {Named{"none", Event::none},
                                        Named{"touch_down", Event::touch_down},
                                        Named{"release", Event::release},
                                        Named{"ring_clear", Event::ring_clear},
                                        Named{"renewed_contact", Event::renewed_contact},
                                        Named{"rolling_onset", Event::rolling_onset},
                                        Named{"slip_reversal", Event::slip_reversal},
                                        Named{"break_away", Event::break_away},
                                        Named{"motor_off", Event::motor_off},
                                        Named{"mass_loss", Event::mass_loss}};

template <>
constexpr std::array names_of<Outcome> = {
    Named{"rolling", Outcome::rolling},       Named{"sliding", Outcome::sliding},
    Named{"stalled", Outcome::stalled},       Named{"freed", Outcome::freed},
    Named{"no_contact", Outcome::no_contact}, Named{"bouncing", Outcome::bouncing},
    Named{"undecided", Outcome::undecided}};

template <>
constexpr std::array names_of<StopOn> = {Named{"outcome", StopOn::outcome},
                                         Named{"rolling", StopOn::rolling},
                                         Named{"rest", StopOn::rest}};

template <class Kind>
Kind parse_name(std::string_view text) {
  for (const Named<Kind>& named : names_of<Kind>)
    if (named.name == text) return named.kind;
  throw InputError(fmt::format("must be one of: {}; not \"{}\"", fmt::join(all_names<Kind>(), ", "),
                               shown(text)));
}

}  // namespace

template <class Kind>
std::vector<std::string_view> all_names() {
  std::vector<std::string_view> all;
  for (const Named<Kind>& named : names_of<Kind>) all.push_back(named.name);
  return all;
}

template <class Kind>
std::string_view name_of(Kind kind) {
  for (const Named<Kind>& named : names_of<Kind>)
    if (named.kind == kind) return named.name;
  return "mixed";
}

template std::string_view name_of(Event);

template std::vector<std::string_view> all_names<Equations>();
template std::string_view name_of(Equations);
Equations parse_equations(std::string_view name) { return parse_name<Equations>(name); }

template std::vector<std::string_view> all_names<VelocityJump>();
template std::string_view name_of(VelocityJump);
VelocityJump parse_velocity_jump(std::string_view name) { return parse_name<VelocityJump>(name); }

template std::vector<std::string_view> all_names<GravityMoment>();
template std::string_view name_of(GravityMoment);
GravityMoment parse_gravity_moment(std::string_view name) {
  return parse_name<GravityMoment>(name);
}

template std::vector<std::string_view> all_names<Method>();
template std::string_view name_of(Method);
Method parse_method(std::string_view name) { return parse_name<Method>(name); }

template std::vector<std::string_view> all_names<StopOn>();
template std::string_view name_of(StopOn);
StopOn parse_stop_on(std::string_view name) { return parse_name<StopOn>(name); }

template std::vector<std::string_view> all_names<Outcome>();
template std::string_view name_of(Outcome);

}  // namespace rotor
