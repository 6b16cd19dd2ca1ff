/// Quadruple precision: gcc's own where there is libquadmath, and Boost's elsewhere.
#pragma once

#include <boost/multiprecision/eigen.hpp>
#ifdef ROTOR_QUADMATH
#include <boost/multiprecision/float128.hpp>
#else
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

namespace rotor {

#ifdef ROTOR_QUADMATH
using Quad = boost::multiprecision::float128;
#else
using Quad = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_quad::backend_type,
                                           boost::multiprecision::et_off>;
#endif

}  // namespace rotor
