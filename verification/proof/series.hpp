/// Formulas as lists of operations, and the Taylor series in time of their values along solutions
/// of z' = f(z, p), with derivatives in any number of directions. Each coefficient encloses the
/// exact one for all states z and parameters p of the given balls.
#pragma once

#include <cstddef>
#include <vector>

#include "verification/proof/ball.hpp"

namespace proof {

class Tape;

/// The value of a formula.
struct Term {
  Tape* tape;
  std::size_t index;
};

class Tape {
 public:
  enum class Kind { input, constant, sum, difference, product, quotient, root, sine, cosine };

  /// The inputs of a series, in the order of their creation: the states, before all other terms,
  /// and the parameters.
  Term state() { return add({.kind = Kind::input, .a = inputs_++}); }
  Term parameter() { return add({.kind = Kind::input, .a = inputs_++, .steady = true}); }
  Term constant(const Ball& value) {
    return add({.kind = Kind::constant, .steady = true, .value = value});
  }
  Term operation(Kind kind, Term a, Term b);
  /// The time derivative of a state.
  void set_rate(Term state, Term rate) { operations_[state.index].b = rate.index; }
  /// The sine of an angle with a given rate, and its cosine.
  std::pair<Term, Term> sine_and_cosine(Term angle, Term rate);

 private:
  friend class Series;
  struct Operation {
    Kind kind;
    std::size_t a = 0, b = 0;  // operands, or the number of an input; b also: the rate of a
                               // state, a sine or a cosine
    bool steady = false;       // constant in time
    Ball value{};
  };

  Term add(const Operation& operation);

  std::vector<Operation> operations_;
  std::size_t inputs_ = 0;
};

inline Term operator+(Term a, Term b) { return a.tape->operation(Tape::Kind::sum, a, b); }
inline Term operator-(Term a, Term b) { return a.tape->operation(Tape::Kind::difference, a, b); }
inline Term operator*(Term a, Term b) { return a.tape->operation(Tape::Kind::product, a, b); }
inline Term operator/(Term a, Term b) { return a.tape->operation(Tape::Kind::quotient, a, b); }
inline Term operator*(int a, Term b) { return b.tape->constant(a) * b; }
inline Term operator/(int a, Term b) { return b.tape->constant(a) / b; }
inline Term operator-(Term a) { return -1 * a; }
inline Term sqrt(Term a) { return a.tape->operation(Tape::Kind::root, a, a); }

/// The Taylor coefficients of all terms up to an order.
class Series {
 public:
  /// The rows of `inputs` are a value and its derivatives.
  Series(const Tape& tape, const Matrix& inputs, std::size_t order);

  /// The k-th coefficient (d = 0), and its derivative in direction d = 1, 2, ...
  const Ball& operator()(Term term, std::size_t k, std::size_t d = 0) const {
    return row(term.index, d)[k];
  }

 private:
  const Ball* row(std::size_t term, std::size_t d) const {
    return &coefficients_[(term * width_ + d) * (order_ + 1)];
  }
  Ball coefficient(const Tape& tape, std::size_t term, std::size_t k, std::size_t d) const;
  Ball of_product(const Tape& tape, std::size_t a, std::size_t b, std::size_t k,
                  std::size_t d) const;

  std::size_t order_, width_;
  std::vector<Ball> coefficients_;  // [term][d][k]
};

}  // namespace proof
