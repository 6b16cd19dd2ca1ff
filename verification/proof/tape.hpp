/// Formulas as lists of operations, and the Taylor series of their values along solutions of
/// z' = f(z, p), with derivatives in any number of directions. The recurrences for the coefficients
/// are those of products, quotients, roots and sines of power series; each coefficient encloses the
/// exact one for all z and p in the balls that are given.
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
  enum class Kind {
    state,
    parameter,
    constant,
    sum,
    difference,
    product,
    quotient,
    root,
    slope,
    sine,
    cosine
  };

  /// A state variable, whose rate is given later, and a parameter. Their values are given in the
  /// order in which they are made, those of the states first.
  Term state();
  Term parameter();
  void set_rates(const std::vector<Term>& rates) { rates_ = rates; }
  Term constant(const Ball& value);
  /// An operation on terms.
  Term add(Kind kind, Term a, Term b);
  /// The cosine of an angle stands behind its sine.
  Term add_sine(Term angle);

 private:
  friend class Series;
  struct Operation {
    Kind kind;
    std::size_t a = 0, b = 0;  // operands, or number of the input
    bool steady = false;       // constant in time
    Ball value{};
  };

  Term push(const Operation& operation);

  std::vector<Operation> operations_;
  std::vector<Term> rates_;
  std::size_t inputs_ = 0;
};

inline Term operator+(Term a, Term b) { return a.tape->add(Tape::Kind::sum, a, b); }
inline Term operator-(Term a, Term b) { return a.tape->add(Tape::Kind::difference, a, b); }
inline Term operator*(Term a, Term b) { return a.tape->add(Tape::Kind::product, a, b); }
inline Term operator/(Term a, Term b) { return a.tape->add(Tape::Kind::quotient, a, b); }
inline Term operator*(int a, Term b) { return b.tape->constant(a) * b; }
inline Term operator/(int a, Term b) { return b.tape->constant(a) / b; }
inline Term operator-(Term a) { return -1 * a; }
inline Term sqrt(Term a) { return a.tape->add(Tape::Kind::root, a, a); }

struct SineAndCosine {
  Term sine, cosine;

  explicit SineAndCosine(Term angle)
      : sine(angle.tape->add_sine(angle)), cosine{sine.tape, sine.index + 1} {}
};

/// A value and its derivatives.
struct Dual {
  Ball value;
  Row slopes{};
};

/// The Taylor coefficients of all terms up to an order.
class Series {
 public:
  /// `inputs` are states and parameters, each with `directions` slopes.
  Series(const Tape& tape, const std::vector<Dual>& inputs, std::size_t order,
         std::size_t directions);

  std::size_t directions() const { return rows_ - 1; }
  /// The k-th coefficient, and its derivative in a direction.
  const Ball& operator()(Term t, std::size_t k) const { return row(t.index, 0)[k]; }
  const Ball& slope(Term t, std::size_t k, std::size_t direction) const {
    return row(t.index, direction + 1)[k];
  }

 private:
  using Operation = Tape::Operation;
  const Ball* row(std::size_t term, std::size_t d) const {
    return &coefficients_[(term * rows_ + d) * (order_ + 1)];
  }
  Ball* row(std::size_t term, std::size_t d) {
    return &coefficients_[(term * rows_ + d) * (order_ + 1)];
  }
  void extend(const Tape& tape, std::size_t k);
  Ball product(const Tape& tape, std::size_t a, std::size_t da, std::size_t b, std::size_t db,
               std::size_t k) const;
  Ball coefficient(const Tape& tape, std::size_t i, std::size_t d, std::size_t k) const;

  std::size_t order_, rows_;
  std::vector<Ball> coefficients_;  // [term][value or direction][order]
};

}  // namespace proof
