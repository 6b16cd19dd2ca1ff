#include "verification/proof/tape.hpp"

#include <algorithm>

namespace proof {

Term Tape::push(const Operation& operation) {
  operations_.push_back(operation);
  return {this, operations_.size() - 1};
}

Term Tape::state() { return push({.kind = Kind::state, .a = inputs_++}); }

Term Tape::parameter() { return push({.kind = Kind::parameter, .a = inputs_++, .steady = true}); }

Term Tape::constant(const Ball& value) {
  return push({.kind = Kind::constant, .steady = true, .value = value});
}

Term Tape::add(Kind kind, Term a, Term b) {
  const bool steady = operations_[a.index].steady && operations_[b.index].steady;
  return push({.kind = kind, .a = a.index, .b = b.index, .steady = steady});
}

Term Tape::add_sine(Term angle) {
  const std::size_t slope = add(Kind::slope, angle, angle).index;
  const bool steady = operations_[angle.index].steady;
  const Term sine = push({.kind = Kind::sine, .a = angle.index, .b = slope, .steady = steady});
  push({.kind = Kind::cosine, .a = angle.index, .b = slope, .steady = steady});
  return sine;
}

Series::Series(const Tape& tape, const std::vector<Dual>& inputs, std::size_t order,
               std::size_t directions)
    : order_(order),
      rows_(directions + 1),
      coefficients_(tape.operations_.size() * rows_ * (order + 1)) {
  for (std::size_t i = 0; i < tape.operations_.size(); ++i) {
    const Operation& op = tape.operations_[i];
    if (op.kind == Tape::Kind::constant) row(i, 0)[0] = op.value;
    if (op.kind != Tape::Kind::state && op.kind != Tape::Kind::parameter) continue;
    row(i, 0)[0] = inputs[op.a].value;
    for (std::size_t d = 0; d < directions; ++d) row(i, d + 1)[0] = inputs[op.a].slopes[d];
  }
  for (std::size_t k = 0; k <= order; ++k) extend(tape, k);
}

/// The k-th coefficients, from those before.
void Series::extend(const Tape& tape, std::size_t k) {
  for (std::size_t i = 0; i < tape.operations_.size(); ++i) {
    const Operation& op = tape.operations_[i];
    if (k > 0 && (op.steady || op.kind == Tape::Kind::state)) continue;
    for (std::size_t d = 0; d < rows_; ++d)
      if (op.kind > Tape::Kind::constant) row(i, d)[k] = coefficient(tape, i, d, k);
  }
  if (k == order_) return;
  for (std::size_t i = 0; i < tape.rates_.size(); ++i)  // states are the first operations
    for (std::size_t d = 0; d < rows_; ++d)
      row(i, d)[k + 1] = row(tape.rates_[i].index, d)[k] / static_cast<long>(k + 1);
}

/// The k-th coefficient of the product of two series, of which those that are steady are short.
Ball Series::product(const Tape& tape, std::size_t a, std::size_t da, std::size_t b, std::size_t db,
                     std::size_t k) const {
  if (tape.operations_[a].steady) return row(a, da)[0] * row(b, db)[k];
  if (tape.operations_[b].steady) return row(a, da)[k] * row(b, db)[0];
  return convolution(row(a, da), row(b, db), 0, static_cast<long>(k), static_cast<long>(k));
}

/// That of a value (d = 0), or of its derivative.
Ball Series::coefficient(const Tape& tape, std::size_t i, std::size_t d, std::size_t k) const {
  using Kind = Tape::Kind;
  const Operation& op = tape.operations_[i];
  const Ball* const a = row(op.a, 0);
  const Ball* const b = row(op.b, 0);
  const Ball* const self = row(i, 0);
  const Ball* const a_d = row(op.a, d);
  const Ball* const b_d = row(op.b, d);
  const Ball* const self_d = row(i, d);
  const auto n = static_cast<long>(k);
  switch (op.kind) {
    case Kind::sum:
      return a_d[k] + b_d[k];
    case Kind::difference:
      return a_d[k] - b_d[k];
    case Kind::slope:
      return a_d[k] * n;
    case Kind::product: {
      const Ball value = product(tape, op.a, d, op.b, 0, k);
      return d == 0 ? value : value + product(tape, op.a, 0, op.b, d, k);
    }
    case Kind::quotient: {  // from q b = a
      Ball rest = a_d[k] - convolution(b, self_d, 1, n, n);
      if (d > 0) rest -= convolution(b_d, self, 0, n, n);
      return rest / b[0];
    }
    case Kind::root:  // from s s = a
      if (d > 0) return (a_d[k] / 2 - convolution(self, self_d, 1, n, n)) / self[0];
      if (k == 0) return sqrt(a[0]);
      return (a[k] - convolution(self, self, 1, n - 1, n)) / (2 * self[0]);
    default:
      break;
  }
  // Sine and cosine, from s' = c a', c' = -s a'. The other one stands beside.
  const bool is_sine = op.kind == Kind::sine;
  const std::size_t other = is_sine ? i + 1 : i - 1;
  if (k == 0) {
    if (d > 0) return is_sine ? cos(a[0]) * a_d[0] : -sin(a[0]) * a_d[0];
    return is_sine ? sin(a[0]) : cos(a[0]);
  }
  Ball sum = convolution(b_d, row(other, 0), 1, n, n);
  if (d > 0) sum += convolution(b, row(other, d), 1, n, n);
  return (is_sine ? sum : -sum) / n;
}

}  // namespace proof
