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

/// z x a: the vector rotated by a quarter turn.
template <class S>
Vector<S> quarter_turn(const Vector<S>& a) {
  return {-a.y(), a.x()};
}

/// The vector rotated by the angle with this cosine and sine.
template <class S>
Vector<S> turned(const Vector<S>& a, const S& cosine, const S& sine) {
  return {cosine * a.x() - sine * a.y(), sine * a.x() + cosine * a.y()};
}

/// The product of two vectors as complex numbers: a rotation and a scaling.
template <class S>
Vector<S> complex_product(const Vector<S>& a, const Vector<S>& b) {
  return turned(a, b.x(), b.y());
}

}  // namespace rotor
