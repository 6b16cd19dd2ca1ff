/// Sets of states as Lohner keeps them: a centre, and intervals along the columns of a frame.
#pragma once

#include <arb_mat.h>

#include <algorithm>

#include "verification/proof/series.hpp"

namespace proof {

/// Values over a set: each is form[0] + sum of form[d] x_d, where x_d is within the set's
/// directions[d]. directions[0] is 1, so that dot(form, directions) contains all of the values.
using Form = Row;

/// States, followed by parameters. The first directions are those of the parameters, one each, and
/// do not change; the others are a frame of the states, chosen again after each step.
struct StateSet {
  std::vector<Form> values;
  Row directions = {1};
  std::size_t frame_begin = 1;  ///< the first of its directions

  /// One state, and all parameters of a tape.
  StateSet(const Row& state, const Tape& tape) {
    for (const Ball& x : state) values.push_back({x});
    for (const auto& [centre, half] : tape.parameters()) {
      values.emplace_back(frame_begin++)[0] = centre;
      values.back().push_back(half);
      directions.push_back(Ball::within(1));
    }
    directions.resize(frame_begin + state.size());
    for (Form& form : values) form.resize(directions.size());
  }

  /// All values, where `values` begin with the centre, and their slopes.
  Matrix all() const {
    Matrix rows = values;
    for (Row& row : rows) row[0] = range(row);
    return rows;
  }

  Ball range(const Form& form) const { return dot(form, directions); }
  Ball range(Term steady) const { return range(map({steady})[0]); }
  /// The values of terms that do not depend on time, such as a reset, by the mean value theorem:
  /// at the centre, and slopes from anywhere in the set.
  std::vector<Form> map(const std::vector<Term>& terms) const {
    const Tape& tape = *terms[0].tape;
    const Series at_centre(tape, values, 0, 1), over_set(tape, all(), 0, directions.size());
    std::vector<Form> forms;
    for (const Term term : terms) {
      forms.push_back({at_centre(term, 0)});
      for (std::size_t d = 1; d < directions.size(); ++d)
        forms.back().push_back(over_set(term, 0, d));
    }
    return forms;
  }

  /// The set of new states. `scale` weights their errors.
  StateSet with(const std::vector<Form>& states, const Row& scale) const {
    const std::size_t n = directions.size() - frame_begin;
    require(states.size() == n && scale.size() == n, "a set of another number of states");
    StateSet next = *this;
    Matrix old_frame(n, Row(n)), columns = old_frame, frame = old_frame;  // columns first
    Row left(n);  // what is not along the frame, when midpoints are kept
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t d = 0; d < frame_begin; ++d) {
        next.values[i][d] = states[i][d].middle();
        left[i] = left[i] + (states[i][d] - next.values[i][d]) * directions[d];
      }
      for (std::size_t j = 0; j < n; ++j) {
        old_frame[j][i] = states[i][frame_begin + j];
        columns[j][i] = (old_frame[j][i] * directions[frame_begin + j].size() / scale[i]).middle();
      }
    }
    columns = orthonormal(columns);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        next.values[i][frame_begin + j] = frame[i][j] = (columns[j][i] * scale[i]).middle();
    // old_frame rest + left = frame (frame^-1 old_frame rest + frame^-1 left)
    const Matrix back = inverse(frame);
    for (std::size_t j = 0; j < n; ++j) {
      Ball rest = dot(back[j], left);
      for (std::size_t d = 0; d < n; ++d)
        rest = rest + dot(back[j], old_frame[d]) * directions[frame_begin + d];
      next.directions[frame_begin + j] = Ball::within(rest.size());
    }
    return next;
  }

 private:
  /// Nearly orthonormal columns with exact entries, by Gram and Schmidt from columns with exact
  /// entries: each has the direction of the longest remainder of those that are left.
  static Matrix orthonormal(Matrix columns) {
    const std::size_t n = columns.size();
    const auto square = [](const Row& column) { return dot(column, column).middle(); };
    const auto shorter = [&](const Row& a, const Row& b) { return square(a) < square(b); };
    // A column of which only rounding is left is replaced by a longer unit vector.
    const Ball longest = square(*std::max_element(columns.begin(), columns.end(), shorter));
    const Ball length =
        sqrt(longest) * Ball::power_of_two(-Ball::bits / 2) + Ball::power_of_two(-4 * Ball::bits);
    for (std::size_t i = 0; i < n; ++i) columns.emplace_back(n)[i] = length;
    for (auto column = columns.begin(); column != columns.end() - static_cast<long>(n); ++column) {
      std::swap(*column, *std::max_element(column, columns.end(), shorter));
      const Ball norm = sqrt(square(*column));
      for (Ball& x : *column) x = (x / norm).middle();
      for (auto other = column + 1; other != columns.end(); ++other) {
        const Ball along = dot(*column, *other);
        for (std::size_t i = 0; i < n; ++i)
          (*other)[i] = ((*other)[i] - along * (*column)[i]).middle();
      }
    }
    columns.resize(n);
    return columns;
  }

  /// Encloses the inverse.
  static Matrix inverse(Matrix a) {
    const std::size_t n = a.size();
    arb_mat_t matrix;
    arb_mat_init(matrix, static_cast<long>(n), static_cast<long>(n));
    const auto swap_entries = [&] {
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) arb_swap(arb_mat_entry(matrix, i, j), a[i][j].get());
    };
    swap_entries();
    const bool regular = arb_mat_inv(matrix, matrix, Ball::bits) != 0;
    swap_entries();
    arb_mat_clear(matrix);
    if (!regular) throw Undecided("whether a matrix is singular");
    return a;
  }
};

}  // namespace proof
