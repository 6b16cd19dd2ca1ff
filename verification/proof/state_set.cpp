#include "verification/proof/solver.hpp"

namespace proof {

StateSet::StateSet(const Row& state, const Row& centre, const Row& half) {
  for (const Ball& x : state) values.push_back({x});
  directions = {1};
  for (std::size_t p = 0; p < half.size(); ++p) {
    if (!(half[p] > 0)) continue;
    values.push_back(Row(directions.size()));
    values.back()[0] = centre[p];
    values.back().push_back(half[p]);
    directions.push_back(Ball::within(1));
  }
  directions.resize(directions.size() + state.size());
  for (Form& form : values) form.resize(directions.size());
}

Matrix StateSet::centre() const {
  Matrix rows;
  for (const Form& form : values) rows.push_back({form[0]});
  return rows;
}

Matrix StateSet::all() const {
  Matrix rows = values;
  for (Row& row : rows) row[0] = range(row);
  return rows;
}

// By the mean value theorem: the value at the centre, and slopes from anywhere in the set.
std::vector<Form> StateSet::map(const Tape& tape, const std::vector<Term>& terms) const {
  const Series at_centre(tape, centre(), 0), over_set(tape, all(), 0);
  std::vector<Form> forms;
  for (const Term term : terms) {
    forms.push_back({at_centre(term, 0)});
    for (std::size_t d = 1; d < directions.size(); ++d)
      forms.back().push_back(over_set(term, 0, d));
  }
  return forms;
}

StateSet StateSet::with(const std::vector<Form>& states, const Row& scale) const {
  const std::size_t n = states.size(), first = directions.size() - n;  // of the frame
  StateSet next = *this;
  Matrix old_frame(n, Row(n)), columns = old_frame, frame = old_frame;  // columns first
  Row left(n);  // what is not along the frame, when midpoints are kept
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t d = 0; d < first; ++d) {
      next.values[i][d] = states[i][d].middle();
      left[i] = left[i] + (states[i][d] - next.values[i][d]) * directions[d];
    }
    for (std::size_t j = 0; j < n; ++j) {
      old_frame[j][i] = states[i][first + j];
      columns[j][i] = (old_frame[j][i] * directions[first + j].size() / scale[i]).middle();
    }
  }
  columns = orthonormal(columns);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      next.values[i][first + j] = frame[i][j] = (columns[j][i] * scale[i]).middle();
  // old_frame rest + left = frame (frame^-1 old_frame rest + frame^-1 left)
  const Matrix back = inverse(frame);
  for (std::size_t j = 0; j < n; ++j) {
    Ball rest = dot(back[j], left);
    for (std::size_t d = 0; d < n; ++d)
      rest = rest + dot(back[j], old_frame[d]) * directions[first + d];
    next.directions[first + j] = Ball::within(rest.size());
  }
  return next;
}

}  // namespace proof
