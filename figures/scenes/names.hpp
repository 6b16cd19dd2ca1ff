/// How kinds of things are called in options, scene files and CSV.
#pragma once

#include <stdexcept>
#include <string_view>

#include "model/phases/transition.hpp"
#include "model/simulation/stop_on.hpp"

namespace rotor {

/// Says what is wrong with an input, where, and what would be right.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

Equations parse_equations(std::string_view name);           ///< throws InputError
Method parse_method(std::string_view name);                 ///< throws InputError
VelocityJump parse_velocity_jump(std::string_view name);    ///< throws InputError
GravityMoment parse_gravity_moment(std::string_view name);  ///< throws InputError
std::string_view name_of(Equations equations);  ///< "mixed" if they have no name of their own
std::string_view name_of(VelocityJump velocity_jump);
std::string_view name_of(GravityMoment gravity_moment);
std::string_view name_of(Method method);
std::string_view name_of(Event event);
std::string_view name_of(Outcome outcome);
StopOn parse_stop_on(std::string_view name);  ///< throws InputError
std::string_view name_of(StopOn stop_on);

}  // namespace rotor
