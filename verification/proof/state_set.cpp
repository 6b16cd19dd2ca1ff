#include "verification/proof/solver.hpp"

namespace proof {

StateSet::StateSet(const Row& state, const Row& centre, const Row& half) {
  const std::size_t n = state.size(), wide = half.size();
  directions = Row(1 + wide + n);
  values = std::vector<Form>(n + wide, Form(directions.size()));
  directions[0] = 1;
  for (std::size_t i = 0; i < n; ++i) values[i][0] = state[i];
  for (std::size_t p = 0; p < wide; ++p) {
    directions[1 + p] = Ball::within(1);
    values[n + p][0] = centre[p];
    values[n + p][1 + p] = half[p];
  }
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
  const Row rest(directions.end() - static_cast<long>(n), directions.end());
  StateSet next = *this;
  Matrix slopes(n, Row(n)), columns = slopes, frame = slopes;
  Row left(n);  // of what is not along the frame, when exact midpoints are kept
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t d = 0; d < first; ++d) {
      next.values[i][d] = states[i][d].middle();
      left[i] = left[i] + (states[i][d] - next.values[i][d]) * directions[d];
    }
    for (std::size_t j = 0; j < n; ++j) {
      slopes[i][j] = states[i][first + j];
      columns[j][i] = slopes[i][j] * rest[j].size() / scale[i];
    }
  }
  columns = orthonormal(columns);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      next.values[i][first + j] = frame[i][j] = (columns[j][i] * scale[i]).middle();
  // slopes rest + left = frame (frame^-1 slopes rest + frame^-1 left)
  const Matrix back = inverse(frame), turned = back * slopes;
  for (std::size_t j = 0; j < n; ++j)
    next.directions[first + j] = Ball::within((dot(turned[j], rest) + dot(back[j], left)).size());
  return next;
}

}  // namespace proof
