#include "verification/proof/series.hpp"

namespace proof {

Term Tape::add(const Operation& operation) {
  operations_.push_back(operation);
  return {this, operations_.size() - 1};
}

Term Tape::operation(Kind kind, Term a, Term b) {
  const bool steady = operations_[a.index].steady && operations_[b.index].steady;
  return add({.kind = kind, .a = a.index, .b = b.index, .steady = steady});
}

std::pair<Term, Term> Tape::sine_and_cosine(Term angle, Term rate) {
  const Term sine = add({.kind = Kind::sine, .a = angle.index});
  const Term cosine = add({.kind = Kind::cosine, .a = angle.index});
  set_rate(sine, rate * cosine);
  set_rate(cosine, -(rate * sine));
  return {sine, cosine};
}

Series::Series(const Tape& tape, const Matrix& inputs, std::size_t order)
    : order_(order),
      width_(inputs.front().size()),
      coefficients_(tape.operations_.size() * width_ * (order + 1)) {
  for (std::size_t k = 0; k <= order; ++k)
    for (std::size_t i = 0; i < tape.operations_.size(); ++i) {
      const auto& [kind, a, b, steady, value] = tape.operations_[i];
      for (std::size_t d = 0; d < width_ && !(steady && k > 0); ++d)
        coefficients_[(i * width_ + d) * (order + 1) + k] =
            kind == Tape::Kind::input && k == 0 ? inputs[a][d] : coefficient(tape, i, k, d);
    }
}

/// The k-th coefficient of a product, or its derivative, from the coefficients known so far. The
/// others are zero, as are those of constants.
Ball Series::of_product(const Tape& tape, std::size_t a, std::size_t b, std::size_t k,
                        std::size_t d) const {
  const std::size_t first = tape.operations_[b].steady ? k : 0;
  const std::size_t last = tape.operations_[a].steady ? 0 : k;
  const auto sum = [&](const Ball* x, const Ball* y) {
    return dot(x + first, y + k - first, last - first + 1, -1);
  };
  if (d == 0) return sum(row(a, 0), row(b, 0));
  return sum(row(a, d), row(b, 0)) + sum(row(a, 0), row(b, d));
}

/// From the lower orders of all terms, and from the operands.
Ball Series::coefficient(const Tape& tape, std::size_t term, std::size_t k, std::size_t d) const {
  using Kind = Tape::Kind;
  const auto& [kind, a, b, steady, value] = tape.operations_[term];
  const Ball &a_k = row(a, d)[k], &b_k = row(b, d)[k], &a_0 = row(a, 0)[0], &b_0 = row(b, 0)[0];
  switch (kind) {
    case Kind::constant:
      return d == 0 ? value : Ball(0);
    case Kind::sum:
      return a_k + b_k;
    case Kind::difference:
      return a_k - b_k;
    case Kind::product:
      return of_product(tape, a, b, k, d);
    case Kind::quotient:  // q b = a, in which q_k is still zero
      return (a_k - of_product(tape, term, b, k, d)) / b_0;
    case Kind::root:  // s s = a
      if (k == 0 && d == 0) return sqrt(a_0);
      return (a_k - of_product(tape, term, term, k, d)) / (2 * row(term, 0)[0]);
    default:
      break;
  }
  if (k > 0) return row(b, d)[k - 1] / static_cast<long>(k);  // z' = b
  if (kind == Kind::sine) return d == 0 ? sin(a_0) : cos(a_0) * a_k;
  return d == 0 ? cos(a_0) : -(sin(a_0) * a_k);
}

}  // namespace proof
