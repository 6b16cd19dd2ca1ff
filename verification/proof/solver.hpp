/// Validated integration: sets of states that contain every solution that starts in a set, from
/// switch to switch. The method is Lohner's: Taylor series about the centre of the set, their
/// derivatives over all of it, and the remainder over a box that is proven to contain the step.
#pragma once

#include <functional>
#include <optional>

#include "verification/proof/state_set.hpp"

namespace proof {

/// A motion: states with rates on the tape, and guards that are positive as long as it lasts.
struct Flow {
  Tape tape;
  std::vector<Term> guards;
  Row scale;  ///< of the states' errors
};

/// The solutions from a set over a step.
class Step {
 public:
  /// The length is the requested one, or shorter: the remainder of each state is within the
  /// tolerance, relative to the state.
  Step(const Flow& flow, const StateSet& set, const Ball& length,
       std::size_t order = static_cast<std::size_t>(3 * Ball::bits / 10),
       const Ball& tolerance = Ball::power_of_two(-Ball::bits))
      : flow_(flow),
        set_(set),
        length_(length),
        at_centre_(flow.tape, set.values, order, 1),
        over_set_(flow.tape, set.all(), order, set.directions.size()),
        over_box_(at_centre_) {
    for (int tries = 0; !enclose(tolerance); ++tries) {
      if (tries == 100) throw Undecided("whether any step is short enough");
      length_ = (length_ * 0.8).middle();
    }
  }

  const Ball& length() const { return length_; }

  /// A time derivative of a term at a time of the step: the series at the centre with the
  /// remainder, and the slopes all over the set.
  Form at(Term term, const Ball& time, std::size_t derivative = 0) const {
    const std::size_t order = at_centre_.order();
    Form form(set_.directions.size());
    for (std::size_t k = order + 2; k-- > derivative;) {
      Ball factor = 1;  // k (k - 1) ... of the derivative
      for (std::size_t j = 0; j < derivative; ++j) factor = factor * (k - j);
      form[0] = form[0] * time + (k > order ? over_box_ : at_centre_)(term, k) * factor;
      for (std::size_t d = 1; d < form.size() && k <= order; ++d)
        form[d] = form[d] * time + over_set_(term, k, d) * factor;
    }
    return form;
  }
  Ball range(Term term, const Ball& time, std::size_t derivative = 0) const {
    return set_.range(at(term, time, derivative));
  }
  /// The same for all times between two.
  Ball between(Term term, const Ball& from, const Ball& until, std::size_t derivative = 0) const {
    const Ball times = hull(from, until), middle = times.middle();
    return range(term, middle, derivative) +
           range(term, times, derivative + 1) * Ball::within(times.radius());
  }
  StateSet after(const Ball& time) const {
    std::vector<Form> forms;
    for (const Term z : flow_.tape.states()) forms.push_back(at(z, time));
    return set_.with(forms, flow_.scale);
  }

  /// Time until which a term is proven positive, if the term and its first `vanishing` - 1
  /// derivatives are zero at the start.
  Ball positive_until(Term term, std::size_t vanishing) const {
    Ball since = vanishing > 0 ? length_ : Ball(0);
    // As long as the first derivative that is not zero is positive, so are the others.
    for (int tries = 1; vanishing > 0 && !(between(term, 0, since, vanishing) > 0); ++tries) {
      if (tries == 30) return 0;
      since = (since / 2).middle();
    }
    return first_doubt(term, since, length_, 12);
  }

  /// A ball of the times at which a term, positive until `clear`, vanishes: exactly once for every
  /// solution. None if that cannot be proven.
  std::optional<Ball> crossing(Term term, const Ball& clear) const {
    const Ball rounding = length_ * Ball::power_of_two(8 - Ball::bits);
    Ball about = clear, move = length_;  // Newton, at the centre
    for (int tries = 0; tries < 100 && !(move.size() < rounding); ++tries) {
      move = (at(term, about)[0] / at(term, about, 1)[0]).middle();
      about = (about - move).middle();
      if (!move.is_finite() || about < -length_ || about > length_) return std::nullopt;
    }
    const Ball value = range(term, about), rate = range(term, about, 1);
    const Ball until = (about + 2 * (value / rate).size() + 16 * rounding).upper();
    // Interval Newton: between `clear`, where the term is positive, and `until` each solution has
    // one zero, since the slope is negative and no zero that it allows is as late as `until`.
    const Ball slope = between(term, clear, until, 1), zeros = about - value / slope;
    if (about < clear || !(until < length_) || !(range(term, clear) > 0) || !(slope < 0) ||
        !(zeros < until))
      return std::nullopt;
    return zeros.lower() < clear ? hull(clear, zeros.upper()) : zeros;
  }

  /// The set on the surface where the term vanishes: at its crossing, t + tau, a solution is at
  /// z + z' tau = z - (z' / g') g, with z and g at t and the rates at times in between.
  StateSet section(Term term, const Ball& crossing) const {
    const Ball time = crossing.middle();
    const Form g = at(term, time);
    const auto rate = [&](Term z) { return between(z, crossing.lower(), crossing.upper(), 1); };
    const Ball slope = rate(term);
    std::vector<Form> forms;
    for (const Term z : flow_.tape.states()) {
      const Ball ratio = rate(z) / slope;
      forms.push_back(at(z, time));
      for (std::size_t d = 0; d < g.size(); ++d) forms.back()[d] = forms.back()[d] - ratio * g[d];
    }
    return set_.with(forms, flow_.scale);
  }

 private:
  /// Finds a box that contains all solutions over the length: if start + [0, h] f(box) is inside
  /// it, they cannot leave it (Picard). Returns whether the remainders over the box are small.
  bool enclose(const Ball& tolerance) {
    const std::size_t last = at_centre_.order() + 1;
    const Ball times = hull(0, length_);
    const Matrix start = set_.all();
    Matrix box = start;
    for (int tries = 0; tries < 12; ++tries) {
      const Series at(flow_.tape, box, 1, 1);
      bool inside = true;
      for (const Term z : flow_.tape.states()) {
        Ball& x = box[z.index][0];
        const Ball reach = start[z.index][0] + times * at(z, 1);
        if (!reach.is_finite()) return false;
        inside = inside && x.contains(reach);
        x = reach;
      }
      if (inside) {
        over_box_ = Series(flow_.tape, box, last, 1);
        return std::ranges::all_of(flow_.tape.states(), [&](Term z) {
          const Ball remainder = over_box_(z, last) * pow(length_, last);
          return Ball::within(over_box_(z, 0).size() * tolerance).contains(remainder);
        });
      }
      for (const Term z : flow_.tape.states()) {
        Ball& x = box[z.index][0];
        x = x + Ball::within(x.radius() / 5 + x.size() * Ball::power_of_two(-Ball::bits));
      }
    }
    return false;
  }

  /// Where, between two times, a term is first not proven positive; the end, if nowhere.
  Ball first_doubt(Term term, const Ball& from, const Ball& until, int depth) const {
    if (!(from < until) || between(term, from, until) > 0) return until;
    if (depth == 0) return from;
    const Ball middle = ((from + until) / 2).middle();
    const Ball doubt = first_doubt(term, from, middle, depth - 1);
    return doubt < middle ? doubt : first_doubt(term, middle, until, depth - 1);
  }

  const Flow& flow_;
  const StateSet& set_;
  Ball length_;
  Series at_centre_, over_set_, over_box_;
};

/// Follows a flow until a guard vanishes, the same one for all solutions; maps the set to there and
/// returns the guard. `vanishing` has the order of each guard's zero at the start. The observer
/// sees each step: the motion lasts until `surely`, at most until `at_most`. Throws Undecided.
inline std::size_t follow(
    const Flow& flow, StateSet& set, Ball& step_length, std::vector<std::size_t> vanishing = {},
    const std::function<void(const Step&, const Ball& surely, const Ball& at_most)>& observer =
        [](auto&...) {}) {
  vanishing.resize(flow.guards.size());
  const Ball shortest = step_length * Ball::power_of_two(-40);
  for (;;) {
    const Step step(flow, set, step_length);
    Row positive_until;
    for (std::size_t g = 0; g < vanishing.size(); ++g)
      positive_until.push_back(step.positive_until(flow.guards[g], vanishing[g]));
    const auto first = std::ranges::min_element(positive_until, std::less<>());
    const Ball clear = *first;
    if (clear < step.length()) {
      const auto g = static_cast<std::size_t>(first - positive_until.begin());
      const std::optional<Ball> crossing = step.crossing(flow.guards[g], clear);
      *first = step.length();
      if (crossing && std::ranges::all_of(positive_until, [&](auto& t) { return t > *crossing; })) {
        observer(step, clear, crossing->upper());
        set = step.section(flow.guards[g], *crossing);
        return g;
      }
    }
    // Up to where no guard vanishes, if possible.
    if (clear * 1024 > step.length()) {
      observer(step, clear, clear);
      step_length = (step.length() * 1.3).middle();
      set = step.after(clear);
      vanishing.assign(vanishing.size(), 0);
    } else {
      step_length = (step.length() / 8).middle();
      if (step_length < shortest) throw Undecided("whether a guard vanishes");
    }
  }
}

/// A ball of the greatest value of a term along solutions, or of 0 if that is greater.
class Greatest {
 public:
  /// The motion may continue after `surely`, up to `at_most`.
  void see(const Step& step, Term term, const Ball& surely, const Ball& at_most) {
    see_part(step, term, 0, surely, 40);
    upper_ = max(upper_, step.between(term, surely, at_most).upper());
  }
  Ball value() const { return hull(lower_, upper_); }

 private:
  void see_part(const Step& step, Term term, const Ball& from, const Ball& until, int depth) {
    Ball range = step.between(term, from, until);
    if (range < lower_) return;
    const Ball middle = ((from + until) / 2).middle(), there = step.range(term, middle);
    lower_ = max(lower_, there.lower());
    const Ball rate = step.between(term, from, until, 1);
    if (rate > 0 || rate < 0) {  // then the greatest value is at an end
      const Ball first = step.range(term, from), last = step.range(term, until);
      lower_ = max(lower_, max(first.lower(), last.lower()));
      range = hull(first, last);
    } else if (depth > 0 && 9 * there.radius() < 8 * range.radius()) {  // or halving were of no use
      see_part(step, term, from, middle, depth - 1);
      return see_part(step, term, middle, until, depth - 1);
    }
    upper_ = max(upper_, range.upper());
  }

  Ball lower_, upper_;
};

}  // namespace proof
