/// The names of choices, events and outcomes in options, scene files and CSV.
#pragma once

#include <stdexcept>
#include <string_view>
#include <vector>

#include "model/phases/transition.hpp"
#include "model/results/stop_on.hpp"

namespace rotor {

/// States what is wrong with an input, where, and what is allowed.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

Equations parse_equations(std::string_view name);           ///< throws InputError
Method parse_method(std::string_view name);                 ///< throws InputError
VelocityJump parse_velocity_jump(std::string_view name);    ///< throws InputError
GravityMoment parse_gravity_moment(std::string_view name);  ///< throws InputError
StopOn parse_stop_on(std::string_view name);                ///< throws InputError

/// The name of one of: Equations ("mixed" if neither published nor consistent), VelocityJump,
/// GravityMoment, Method, Event, Outcome, StopOn.
template <class Kind>
std::string_view name_of(Kind kind);

/// All names of a kind.
template <class Kind>
std::vector<std::string_view> all_names();

}  // namespace rotor
