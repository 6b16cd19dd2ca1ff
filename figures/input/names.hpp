/// How kinds of things are called in options, scene files and CSV.
#pragma once

#include <stdexcept>
#include <string_view>
#include <vector>

#include "model/phases/transition.hpp"
#include "model/results/stop_on.hpp"

namespace rotor {

/// Says what is wrong with an input, where, and what would be right.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

Equations parse_equations(std::string_view name);           ///< throws InputError
Method parse_method(std::string_view name);                 ///< throws InputError
VelocityJump parse_velocity_jump(std::string_view name);    ///< throws InputError
GravityMoment parse_gravity_moment(std::string_view name);  ///< throws InputError
StopOn parse_stop_on(std::string_view name);                ///< throws InputError

/// "mixed" for equations that have no name of their own. Of: Equations, VelocityJump,
/// GravityMoment, Method, Event, Outcome, StopOn.
template <class Kind>
std::string_view name_of(Kind kind);

/// All of a kind.
template <class Kind>
std::vector<std::string_view> all_names();

}  // namespace rotor
