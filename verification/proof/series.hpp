/// Formulas as lists of operations, and the Taylor series in time of their values along solutions
/// of z' = f(z, p), with derivatives in any number of directions. Each coefficient encloses the
/// exact one for all states z and parameters p of the given balls.
#pragma once

#include "verification/proof/ball.hpp"

namespace proof {

class Tape;

/// The value of a formula.
struct Term {
  Tape* tape;
  std::size_t index;
};

/// Mixing up tapes or inputs throws std::logic_error. A copy's terms belong to the original.
class Tape {
 public:
  enum class Kind { input, constant, sum, difference, product, quotient, root, sine, cosine };

  /// The inputs of a series, in the order of their creation: the states, before all other terms,
  /// and the parameters.
  Term state() {
    require(operations_.size() == states_.size(), "a state that is made after other terms");
    return states_.emplace_back(add({.kind = Kind::input, .a = states_.size()}));
  }
  /// Within `half` of `centre`; a constant, if that is zero.
  Term parameter(const Ball& centre, const Ball& half) {
    if (!(half > 0)) return constant(centre);
    parameters_.emplace_back(centre, half);
    return add({.kind = Kind::input, .a = inputs() - 1, .steady = true});
  }
  Term constant(const Ball& value) {
    return add({.kind = Kind::constant, .steady = true, .value = value});
  }
  Term operation(Kind kind, Term a, Term b) {
    const bool a_steady = operations_[own(a)].steady, b_steady = operations_[own(b)].steady;
    return add({.kind = kind, .a = a.index, .b = b.index, .steady = a_steady && b_steady});
  }
  /// The sine of an angle with a given rate, and its cosine.
  std::pair<Term, Term> sine_and_cosine(Term angle, Term rate) {
    const Term sine = add({.kind = Kind::sine, .a = own(angle)});
    const Term cosine = add({.kind = Kind::cosine, .a = own(angle)});
    operations_[sine.index].b = operation(Kind::product, rate, cosine).index;
    const Term fall = operation(Kind::product, rate, sine);
    operations_[cosine.index].b = operation(Kind::product, constant(-1), fall).index;
    return {sine, cosine};
  }

  const std::vector<Term>& states() const { return states_; }
  const std::vector<std::pair<Ball, Ball>>& parameters() const { return parameters_; }
  /// The time derivatives of the states.
  void set_rates(const std::vector<Term>& rates) {
    require(rates.size() == states_.size(), "rates of another number of states");
    for (std::size_t i = 0; i < rates.size(); ++i) operations_[i].b = own(rates[i]);
    has_rates_ = true;
  }

 private:
  friend class Series;
  struct Operation {
    Kind kind;
    // Operands, or the number of an input; b is the rate of a state and of a sine.
    std::size_t a = 0, b = 0;
    bool steady = false;  // constant in time
    Ball value{};
  };

  Term add(const Operation& operation) {
    operations_.push_back(operation);
    return {this, operations_.size() - 1};
  }
  std::size_t inputs() const { return states_.size() + parameters_.size(); }
  std::size_t own(Term term) const {
    require(term.tape == this, "a term of another tape");
    return term.index;
  }

  std::vector<Operation> operations_;
  std::vector<Term> states_;
  std::vector<std::pair<Ball, Ball>> parameters_;
  bool has_rates_ = false;
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
  /// A row of `inputs` is a value and its derivatives, of which `width` numbers are used.
  Series(const Tape& tape, const Matrix& inputs, std::size_t order, std::size_t width)
      : tape_(&tape),
        order_(order),
        width_(width),
        coefficients_(tape.operations_.size() * width_ * (order + 1)) {
    require(inputs.size() == tape.inputs(), "another number of inputs than the formulas have");
    require(order == 0 || tape.has_rates_, "a series in time of states without rates");
    for (const Row& input : inputs)
      require(input.size() >= width, "an input with too few derivatives");
    for (std::size_t k = 0; k <= order; ++k)
      for (std::size_t i = 0; i < tape.operations_.size(); ++i) {
        const auto& [kind, a, b, steady, value] = tape.operations_[i];
        for (std::size_t d = 0; d < width_ && !(steady && k > 0); ++d)
          coefficients_[(i * width_ + d) * (order + 1) + k] =
              kind == Tape::Kind::input && k == 0 ? inputs[a][d] : coefficient(i, k, d);
      }
  }

  /// The k-th coefficient (d = 0), and its derivative in direction d = 1, 2, ...
  const Ball& operator()(Term term, std::size_t k, std::size_t d = 0) const {
    return row(tape_->own(term), d)[k];
  }
  std::size_t order() const { return order_; }

 private:
  const Ball* row(std::size_t term, std::size_t d) const {
    return &coefficients_[(term * width_ + d) * (order_ + 1)];
  }

  /// The k-th coefficient of a product, or its derivative, from the coefficients known so far. The
  /// others are zero, as are those of constants.
  Ball of_product(std::size_t a, std::size_t b, std::size_t k, std::size_t d) const {
    const std::size_t first = tape_->operations_[b].steady ? k : 0;
    const std::size_t last = tape_->operations_[a].steady ? 0 : k;
    const auto sum = [&](const Ball* x, const Ball* y) {
      return dot(x + first, y + k - first, last - first + 1, -1);
    };
    if (d == 0) return sum(row(a, 0), row(b, 0));
    return sum(row(a, d), row(b, 0)) + sum(row(a, 0), row(b, d));
  }

  /// From the lower orders of all terms, and from the operands.
  Ball coefficient(std::size_t term, std::size_t k, std::size_t d) const {
    using Kind = Tape::Kind;
    const auto& [kind, a, b, steady, value] = tape_->operations_[term];
    const Ball &a_k = row(a, d)[k], &b_k = row(b, d)[k], &a_0 = row(a, 0)[0], &b_0 = row(b, 0)[0];
    switch (kind) {
      case Kind::constant:
        return d == 0 ? value : Ball(0);
      case Kind::sum:
        return a_k + b_k;
      case Kind::difference:
        return a_k - b_k;
      case Kind::product:
        return of_product(a, b, k, d);
      case Kind::quotient:  // q b = a, in which q_k is still zero
        return (a_k - of_product(term, b, k, d)) / b_0;
      case Kind::root:  // s s = a
        if (k == 0 && d == 0) return sqrt(a_0);
        return (a_k - of_product(term, term, k, d)) / (2 * row(term, 0)[0]);
      case Kind::sine:
        if (k == 0) return d == 0 ? sin(a_0) : cos(a_0) * a_k;
        break;
      case Kind::cosine:
        if (k == 0) return d == 0 ? cos(a_0) : -(sin(a_0) * a_k);
        break;
      case Kind::input:  // which is given for k = 0
        break;
    }
    return row(b, d)[k - 1] / k;  // z' = b
  }

  const Tape* tape_;
  std::size_t order_, width_;
  std::vector<Ball> coefficients_;  // [term][d][k]
};

}  // namespace proof
