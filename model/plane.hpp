/// Vectors in the plane of the rotor. The third axis, z, is the axis of rotation; a positive angle
/// turns x towards y.
#pragma once

#include <Eigen/Core>

namespace rotor {

template <class S>
using Vector = Eigen::Matrix<S, 2, 1>;

/// z component of a x b.
template <class S>
S cross(const Vector<S>& a, const Vector<S>& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// z x a: the vector turned by a quarter turn.
template <class S>
Vector<S> quarter_turn(const Vector<S>& a) {
  return {-a.y(), a.x()};
}

/// The vector with the direction cosines `cosine`, `sine` added to its own direction.
template <class S>
Vector<S> turned(const Vector<S>& a, const S& cosine, const S& sine) {
  return {cosine * a.x() - sine * a.y(), sine * a.x() + cosine * a.y()};
}

}  // namespace rotor
