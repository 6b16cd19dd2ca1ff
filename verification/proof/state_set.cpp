#include "verification/proof/state_set.hpp"

#include <algorithm>
#include <functional>

namespace proof {

std::vector<Dual> values(const Row& states, const Row& inputs) {
  std::vector<Dual> all;
  for (const Row* row : {&states, &inputs})
    for (const Ball& x : *row) all.push_back({x});
  return all;
}

std::vector<Dual> anywhere(const Row& states, const Inputs& inputs) {
  Row balls = inputs.centre;
  for (std::size_t i = 0; i < balls.size(); ++i) balls[i] += Ball::within(inputs.half[i]);
  return values(states, balls);
}

std::vector<Dual> over(const StateSet& set, const Inputs& inputs) {
  std::vector<Dual> all = anywhere(set.hull(), inputs);
  const std::size_t n = set.centre.size();
  std::size_t direction = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i < n) {
      all[i].slopes = set.by_input[i];
      all[i].slopes.insert(all[i].slopes.end(), set.frame[i].begin(), set.frame[i].end());
    } else {
      all[i].slopes = Row(set.by_input[0].size() + n);
      const Ball& half = inputs.half[i - n];
      if (!half.is_exactly_zero()) all[i].slopes[direction++] = half;
    }
  }
  return all;
}

std::vector<Form> forms_of(const Series& centre, const Series& all, const std::vector<Term>& terms,
                           std::size_t k) {
  std::vector<Form> forms;
  for (const Term term : terms) {
    forms.push_back({centre(term, k), Row(all.directions())});
    for (std::size_t d = 0; d < all.directions(); ++d)
      forms.back().slopes[d] = all.slope(term, k, d);
  }
  return forms;
}

std::size_t Inputs::wide() const {
  return static_cast<std::size_t>(
      std::count_if(half.begin(), half.end(), [](const Ball& x) { return !x.is_exactly_zero(); }));
}

Row StateSet::directions() const {
  Row all(by_input[0].size(), Ball::within(1));
  all.insert(all.end(), rest.begin(), rest.end());
  return all;
}

Row StateSet::hull() const {
  Row all = centre;
  const Row p(by_input[0].size(), Ball::within(1));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] += dot(by_input[i], p) + dot(frame[i], rest);
  return all;
}

StateSet StateSet::at(const Row& state, const Inputs& inputs) {
  std::vector<Form> forms;
  const Row directions(inputs.wide(), Ball::within(1));
  for (const Ball& x : state) forms.push_back({x, Row(directions.size())});
  return of(forms, directions, inputs);
}

StateSet StateSet::of(const std::vector<Form>& forms, const Row& directions, const Inputs& inputs) {
  const std::size_t n = forms.size(), wide = inputs.wide();
  StateSet set{Row(n), Matrix(n, Row(wide)), Matrix(n, Row(n)), Row(n)};
  Row left(n);  // what is not in the new centre, nor in the new slopes by inputs
  for (std::size_t i = 0; i < n; ++i) {
    set.centre[i] = forms[i].centre.middle();
    left[i] = forms[i].centre - set.centre[i];
    for (std::size_t d = 0; d < wide; ++d) {
      set.by_input[i][d] = forms[i].slopes[d].middle();
      left[i] += (forms[i].slopes[d] - set.by_input[i][d]) * directions[d];
    }
  }
  // The rest in a new frame: frame^-1 (old slopes old rest + left).
  const Row rest(directions.begin() + static_cast<long>(wide), directions.end());
  const bool had_rest = !std::all_of(rest.begin(), rest.end(), std::mem_fn(&Ball::is_exactly_zero));
  Matrix slopes(n, Row(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t d = 0; d < rest.size(); ++d) slopes[i][d] = forms[i].slopes[wide + d];
    if (!had_rest) slopes[i][i] = 1;
  }
  Row sizes(n, Ball(1));
  for (std::size_t d = 0; d < rest.size(); ++d) sizes[d] = rest[d].size();
  set.frame = orthonormal(slopes, sizes, inputs.scale);
  const Matrix back = inverse(set.frame);
  for (std::size_t i = 0; i < n; ++i) {
    set.rest[i] = dot(back[i], left);
    for (std::size_t d = 0; d < rest.size(); ++d) {
      Ball along;
      for (std::size_t j = 0; j < n; ++j) along += back[i][j] * slopes[j][d];
      set.rest[i] += along * rest[d];
    }
    set.rest[i] = Ball::within(set.rest[i].size());
  }
  return set;
}

StateSet map(const Tape& tape, const std::vector<Term>& terms, const Inputs& inputs,
             const StateSet& set) {
  const Row directions = set.directions();
  const Series centre(tape, values(set.centre, inputs.centre), 0, 0);
  const Series all(tape, over(set, inputs), 0, directions.size());
  return StateSet::of(forms_of(centre, all, terms, 0), directions, inputs);
}

Ball range(const Tape& tape, Term term, const Inputs& inputs, const StateSet& set) {
  const Row directions = set.directions();
  const Series centre(tape, values(set.centre, inputs.centre), 0, 0);
  const Series all(tape, over(set, inputs), 0, directions.size());
  const Form form = forms_of(centre, all, {term}, 0)[0];
  return common(form.centre + dot(form.slopes, directions), all(term, 0));
}

}  // namespace proof
