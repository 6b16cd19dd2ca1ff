/// Fehlberg's Runge-Kutta pair of orders 7(8), as an Odeint error stepper: an independent check of
/// Verner's.
#pragma once

#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

namespace rotor {

template <class State, class S>
using Fehlberg78 =
    boost::numeric::odeint::runge_kutta_fehlberg78<State, S, State, S,
                                                   boost::numeric::odeint::array_algebra>;

}  // namespace rotor
