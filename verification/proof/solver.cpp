#include "verification/proof/solver.hpp"

#include <algorithm>

namespace proof {

Step::Step(const Flow& flow, const StateSet& set, const Ball& length, const Settings& settings)
    : flow_(flow),
      set_(set),
      settings_(settings),
      length_(length),
      at_centre_(flow.tape, set.centre(), settings.order),
      over_set_(flow.tape, set.all(), settings.order),
      over_box_(at_centre_) {
  for (int tries = 0; tries < 100; ++tries) {
    if (enclose() && is_accurate()) return;
    length_ = (length_ * 0.8).middle();
  }
  throw Undecided("no step is short enough");
}

/// Finds a box that contains all solutions over the length: if start + [0, h] f(box) is inside the
/// box, they cannot leave it (Picard).
bool Step::enclose() {
  const Ball step = hull(0, length_);
  const Matrix start = set_.all();
  box_.clear();
  for (const Row& row : start) box_.push_back({row[0]});
  for (int tries = 0; tries < 12; ++tries) {
    const Series at(flow_.tape, box_, 1);
    bool inside = true;
    for (const Term z : flow_.states) {
      Ball& x = box_[z.index][0];
      const Ball reach = start[z.index][0] + step * at(z, 1);
      if (!reach.is_finite()) return false;
      inside = inside && x.contains(reach);
      x = reach;
    }
    if (inside) return true;
    for (const Term z : flow_.states) {
      Ball& x = box_[z.index][0];
      x = x + Ball::within(x.radius() / 5 + x.size() * Ball::power_of_two(-Ball::bits));
    }
  }
  return false;
}

/// Whether the remainders are as small as they should be.
bool Step::is_accurate() {
  const std::size_t last = settings_.order + 1;
  over_box_ = Series(flow_.tape, box_, last);
  return std::ranges::all_of(flow_.states, [&](Term z) {
    const Ball remainder = (over_box_(z, last) * pow(length_, last)).size();
    return !(remainder > 0) || remainder < box_[z.index][0].size() * settings_.tolerance;
  });
}

// The series at the centre with the remainder, and the slopes all over the set.
Form Step::at(Term term, const Ball& time, std::size_t derivative) const {
  Form form(set_.directions.size());
  for (std::size_t k = settings_.order + 2; k-- > derivative;) {
    long factor = 1;  // k (k - 1) ... of the derivative
    for (std::size_t j = 0; j < derivative; ++j) factor *= static_cast<long>(k - j);
    const bool is_remainder = k == settings_.order + 1;
    form[0] = form[0] * time + (is_remainder ? over_box_ : at_centre_)(term, k) * factor;
    for (std::size_t d = 1; d < form.size() && !is_remainder; ++d)
      form[d] = form[d] * time + over_set_(term, k, d) * factor;
  }
  return form;
}

Ball Step::between(Term term, const Ball& from, const Ball& until, std::size_t derivative) const {
  const Ball times = hull(from, until), middle = times.middle();
  return range(term, middle, derivative) +
         range(term, times, derivative + 1) * Ball::within(times.radius());
}

StateSet Step::after(const Ball& time) const {
  std::vector<Form> forms;
  for (const Term z : flow_.states) forms.push_back(at(z, time));
  return set_.with(forms, flow_.scale);
}

Ball Step::positive_until(Term term, std::size_t vanishing) const {
  if (vanishing == 0) return first_doubt(term, 0, length_, 12);
  // As long as the first derivative that is not zero is positive, so are the others.
  Ball since = length_;
  for (int halvings = 0; halvings < 30; ++halvings) {
    if (between(term, 0, since, vanishing) > 0) return first_doubt(term, since, length_, 12);
    since = (since / 2).middle();
  }
  return 0;
}

/// Where, between two times, a term is first not proven positive; the end, if nowhere.
Ball Step::first_doubt(Term term, const Ball& from, const Ball& until, int depth) const {
  if (!(from < until) || between(term, from, until) > 0) return until;
  if (depth == 0) return from;
  const Ball middle = ((from + until) / 2).middle();
  const Ball doubt = first_doubt(term, from, middle, depth - 1);
  return doubt < middle ? doubt : first_doubt(term, middle, until, depth - 1);
}

std::optional<Ball> Step::crossing(Term term, const Ball& clear) const {
  const Ball rounding = length_ * Ball::power_of_two(8 - Ball::bits);
  Ball about = clear, move = length_;
  for (int tries = 0; tries < 100 && !(move.size() < rounding); ++tries) {  // Newton, at the centre
    move = (at(term, about)[0] / at(term, about, 1)[0]).middle();
    about = (about - move).middle();
    if (!move.is_finite() || about < -length_ || about > length_) return std::nullopt;
  }
  const Ball value = range(term, about), rate = range(term, about, 1);
  const Ball until = (about + 2 * (value / rate).size() + 16 * rounding).upper();
  if (about < clear || !(until < length_)) return std::nullopt;
  // Interval Newton: between `clear`, where the term is positive, and `until` each solution has one
  // zero, since the slope is negative and no zero that it allows is as late as `until`.
  const Ball slope = between(term, clear, until, 1);
  if (!(range(term, clear) > 0) || !(slope < 0)) return std::nullopt;
  const Ball zeros = about - value / slope;
  if (!(zeros < until)) return std::nullopt;
  return zeros.lower() < clear ? hull(clear, zeros.upper()) : zeros;
}

// At its crossing, t + tau, a solution is at z + z' tau = z - (z' / g') g, with z and g at t and
// the rates at times in between.
StateSet Step::section(Term term, const Ball& crossing) const {
  const Ball time = crossing.middle();
  const Form g = at(term, time);
  const auto rate = [&](Term z) { return between(z, crossing.lower(), crossing.upper(), 1); };
  const Ball slope = rate(term);
  std::vector<Form> forms;
  for (const Term z : flow_.states) {
    const Ball ratio = rate(z) / slope;
    forms.push_back(at(z, time));
    for (std::size_t d = 0; d < g.size(); ++d) forms.back()[d] = forms.back()[d] - ratio * g[d];
  }
  return set_.with(forms, flow_.scale);
}

std::size_t follow(const Flow& flow, StateSet& set, std::vector<std::size_t> vanishing,
                   Ball& step_length, const StepObserver& observer) {
  const std::size_t guards = flow.guards.size();
  vanishing.resize(guards);
  const Ball shortest = step_length * Ball::power_of_two(-40);
  for (;;) {
    const Step step(flow, set, step_length);
    Row positive_until;
    for (std::size_t g = 0; g < guards; ++g)
      positive_until.push_back(step.positive_until(flow.guards[g], vanishing[g]));
    const auto first = std::min_element(positive_until.begin(), positive_until.end());
    const Ball clear = *first;
    if (clear < step.length()) {
      const auto g = static_cast<std::size_t>(first - positive_until.begin());
      const std::optional<Ball> crossing = step.crossing(flow.guards[g], clear);
      *first = step.length();
      if (crossing && std::all_of(positive_until.begin(), positive_until.end(),
                                  [&](const Ball& t) { return t > *crossing; })) {
        observer(step, crossing->lower(), crossing->upper());
        set = step.section(flow.guards[g], *crossing);
        return g;
      }
    }
    // Up to where no guard vanishes, if possible.
    if (clear * 1024 > step.length()) {
      observer(step, clear, clear);
      step_length = (step.length() * 1.3).middle();
      set = step.after(clear);
      std::fill(vanishing.begin(), vanishing.end(), 0);
    } else {
      step_length = (step.length() / 8).middle();
      if (step_length < shortest) throw Undecided("whether a guard vanishes");
    }
  }
}

namespace {

void raise(Ball& greatest, const Ball& x) {
  if (x > greatest) greatest = x;
}

}  // namespace

// The motion may continue after `surely`, up to `at_most`.
void Greatest::see(const Step& step, Term term, const Ball& surely, const Ball& at_most) {
  see_part(step, term, 0, surely, 40);
  raise(upper_, step.between(term, surely, at_most).upper());
}

void Greatest::see_part(const Step& step, Term term, const Ball& from, const Ball& until,
                        int depth) {
  Ball range = step.between(term, from, until);
  if (range < lower_) return;
  const Ball middle = ((from + until) / 2).middle(), there = step.range(term, middle);
  raise(lower_, there.lower());
  const Ball rate = step.between(term, from, until, 1);
  if (rate > 0 || rate < 0) {  // then the greatest value is at an end
    const Ball first = step.range(term, from), last = step.range(term, until);
    raise(lower_, first.lower());
    raise(lower_, last.lower());
    range = hull(first, last);
  } else if (depth > 0 && 9 * there.radius() < 8 * range.radius()) {  // or halving were of no use
    see_part(step, term, from, middle, depth - 1);
    return see_part(step, term, middle, until, depth - 1);
  }
  raise(upper_, range.upper());
}

}  // namespace proof
