/// Quadruple precision: gcc's where there is libquadmath, long double where that is quadruple, and
/// Boost's elsewhere.
#pragma once

#include <boost/multiprecision/eigen.hpp>
#include <cfloat>
#ifdef ROTOR_QUADMATH
#include <boost/multiprecision/float128.hpp>
#elif LDBL_MANT_DIG < 113
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

namespace rotor {

#ifdef ROTOR_QUADMATH
using Quad = boost::multiprecision::float128;
#elif LDBL_MANT_DIG >= 113
using Quad = long double;
#else
using Quad = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_quad::backend_type,
                                           boost::multiprecision::et_off>;
#endif

}  // namespace rotor
