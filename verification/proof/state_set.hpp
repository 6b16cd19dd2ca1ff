/// Sets of states: a centre, and a matrix times a box (Lohner).
#pragma once

#include "verification/proof/tape.hpp"

namespace proof {

/// The parameters: each lies within `half` of its centre. Those with a width are directions of all
/// sets. Errors of the states weigh alike if they are in proportion to `scale`.
struct Inputs {
  Row centre, half, scale;

  std::size_t wide() const;  ///< how many have a width
};

/// A value that depends on the directions x of a set: it lies in centre + slopes x.
struct Form {
  Ball centre;
  Row slopes;
};

/// The states centre + by_input p + frame r, where p are the parameters' deviations as shares of
/// their widths, -1 ... 1, and r are any numbers of `rest`.
struct StateSet {
  Row centre;
  Matrix by_input, frame;
  Row rest;

  /// p and r.
  Row directions() const;
  /// Balls of the states.
  Row hull() const;
  /// One state, known to within its balls.
  static StateSet at(const Row& state, const Inputs& inputs);
  /// The set of the values of forms over the directions of another set.
  static StateSet of(const std::vector<Form>& forms, const Row& directions, const Inputs& inputs);
};

/// The values of terms of no time, such as a reset, over a set. States come first in the tape.
StateSet map(const Tape& tape, const std::vector<Term>& terms, const Inputs& inputs,
             const StateSet& set);
/// A ball of one of them.
Ball range(const Tape& tape, Term term, const Inputs& inputs, const StateSet& set);

/// What series are given: one state, balls of all, or these with their slopes along the directions
/// of a set. States come before parameters.
std::vector<Dual> values(const Row& states, const Row& inputs);
std::vector<Dual> anywhere(const Row& states, const Inputs& inputs);
std::vector<Dual> over(const StateSet& set, const Inputs& inputs);

/// The k-th coefficients of terms over a set, from those at its centre and the slopes all over it.
std::vector<Form> forms_of(const Series& centre, const Series& all, const std::vector<Term>& terms,
                           std::size_t k);

}  // namespace proof
