#include "figures/scenes/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
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
Named(const char*, Kind) -> Named<Kind>;  // which clang 14 does not find itself

constexpr std::array equations_names = {Named{"published", Equations::published},
                                        Named{"consistent", Equations::consistent}};
constexpr std::array velocity_jump_names = {Named{"once", VelocityJump::once},
                                            Named{"twice", VelocityJump::twice}};
constexpr std::array gravity_moment_names = {Named{"balanced", GravityMoment::balanced},
                                             Named{"whole", GravityMoment::whole}};
constexpr std::array method_names = {Named{"event", Method::event}, Named{"rk4", Method::rk4}};

constexpr std::array event_names = {Named{"none", Event::none},
                                    Named{"touch_down", Event::touch_down},
                                    Named{"release", Event::release},
                                    Named{"ring_clear", Event::ring_clear},
                                    Named{"renewed_contact", Event::renewed_contact},
                                    Named{"rolling_onset", Event::rolling_onset},
                                    Named{"slip_reversal", Event::slip_reversal},
                                    Named{"break_away", Event::break_away},
                                    Named{"motor_off", Event::motor_off},
                                    Named{"mass_loss", Event::mass_loss}};

constexpr std::array outcome_names = {
    Named{"rolling", Outcome::rolling},       Named{"sliding", Outcome::sliding},
    Named{"stalled", Outcome::stalled},       Named{"freed", Outcome::freed},
    Named{"no_contact", Outcome::no_contact}, Named{"bouncing", Outcome::bouncing},
    Named{"undecided", Outcome::undecided}};

constexpr std::array stop_names = {Named{"outcome", StopOn::outcome},
                                   Named{"rolling", StopOn::rolling}, Named{"rest", StopOn::rest}};

template <class Names>
auto parse_name(const Names& names, std::string_view text) {
  std::vector<std::string> allowed;
  for (const auto& named : names) {
    if (named.name == text) return named.kind;
    allowed.emplace_back(named.name);
  }
  throw InputError(
      fmt::format("must be one of: {}; not \"{}\"", fmt::join(allowed, ", "), shown(text)));
}

template <class Names, class Kind>
std::string_view find_name(const Names& names, Kind kind) {
  const auto named =
      std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.kind == kind; });
  return named == names.end() ? "mixed" : named->name;
}

}  // namespace

Equations parse_equations(std::string_view name) { return parse_name(equations_names, name); }
VelocityJump parse_velocity_jump(std::string_view name) {
  return parse_name(velocity_jump_names, name);
}
GravityMoment parse_gravity_moment(std::string_view name) {
  return parse_name(gravity_moment_names, name);
}
Method parse_method(std::string_view name) { return parse_name(method_names, name); }
std::string_view name_of(Equations equations) { return find_name(equations_names, equations); }
std::string_view name_of(VelocityJump jump) { return find_name(velocity_jump_names, jump); }
std::string_view name_of(GravityMoment moment) { return find_name(gravity_moment_names, moment); }
std::string_view name_of(Method method) { return find_name(method_names, method); }
std::string_view name_of(Event event) { return find_name(event_names, event); }
StopOn parse_stop_on(std::string_view name) { return parse_name(stop_names, name); }
std::string_view name_of(StopOn stop_on) { return find_name(stop_names, stop_on); }
std::string_view name_of(Outcome outcome) { return find_name(outcome_names, outcome); }

}  // namespace rotor
