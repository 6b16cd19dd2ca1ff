#include "verification/proof/solver.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace proof {
namespace {

/// All numbers from zero to x.
Ball from_zero_to(const Ball& x) { return hull(Ball(0), x); }

}  // namespace

Settings::Settings()
    : order(static_cast<std::size_t>(3 * Ball::bits / 10)), tolerance(power_of_two(-Ball::bits)) {}

Step::Step(const Flow& flow, const Inputs& inputs, const StateSet& set, const Settings& settings,
           Ball length)
    : flow_(flow),
      inputs_(inputs),
      directions_(set.directions()),
      settings_(settings),
      at_centre_(*flow.tape, values(set.centre, inputs.centre), settings.order, 0),
      over_set_(*flow.tape, over(set, inputs), settings.order, directions_.size()),
      over_box_(at_centre_) {
  const Row start = set.hull();
  for (int tries = 0; tries < 100; ++tries) {
    if (enclose(start, length)) {
      over_box_ = Series(*flow.tape, anywhere(box_, inputs), settings.order + 1, 0);
      const Ball too_much = excess();
      if ((1 - too_much).is_positive()) return;
      const double shorter =
          std::pow(too_much.to_double(), -1 / static_cast<double>(settings.order + 1));
      if (shorter > 0.1)
        length *= 0.9 * shorter;  // which is not so if it is not finite
      else
        length /= 2;
    } else {
      length /= 2;
    }
    length = length.middle();
  }
  throw Undecided("no step is short enough");
}

/// Finds a box that contains all solutions over the length: if f maps it so that start + [0, h] f
/// is inside of it, then they cannot leave it (Picard).
bool Step::enclose(const Row& start, const Ball& length) {
  box_ = start;
  length_ = length;
  for (int tries = 0; tries < 12; ++tries) {
    const Series at(*flow_.tape, anywhere(box_, inputs_), 0, 0);
    bool inside = true;
    for (std::size_t i = 0; i < start.size(); ++i) {
      const Ball reach = start[i] + from_zero_to(length * at(flow_.rates[i], 0));
      if (!reach.is_finite()) return false;
      inside = inside && box_[i].contains(reach);
      box_[i] = reach;
    }
    if (inside) return true;
    for (Ball& x : box_) x += Ball::within(x.radius() * 0.2 + x.size() * power_of_two(-Ball::bits));
  }
  return false;
}

/// The greatest remainder, as a share of what is tolerated.
Ball Step::excess() const {
  Ball greatest, power(1);
  for (std::size_t k = 0; k <= settings_.order; ++k) power *= length_;
  for (std::size_t i = 0; i < box_.size(); ++i) {
    const Ball remainder = (over_box_(flow_.states[i], settings_.order + 1) * power).size();
    if (remainder.is_exactly_zero()) continue;
    const Ball share = (remainder / (box_[i].size() * settings_.tolerance)).upper();
    if (!share.is_finite() || (share - greatest).is_positive()) greatest = share;
  }
  return greatest;
}

Form Step::at(Term term, const Ball& time, std::size_t derivative) const {
  const std::size_t last = settings_.order + 1;
  Form form{over_box_(term, last), Row(directions_.size())};  // the remainder
  const auto factor = [&](std::size_t k) {                    // k (k - 1) ... of the derivative
    long product = 1;
    for (std::size_t j = 0; j < derivative; ++j) product *= static_cast<long>(k - j);
    return product;
  };
  form.centre *= factor(last);
  for (std::size_t k = last; k-- > derivative;) {
    form.centre = form.centre * time + at_centre_(term, k) * factor(k);
    for (std::size_t d = 0; d < directions_.size(); ++d)
      form.slopes[d] = form.slopes[d] * time + over_set_.slope(term, k, d) * factor(k);
  }
  return form;
}

Ball Step::range(Term term, const Ball& time, std::size_t derivative) const {
  const Form form = at(term, time, derivative);
  return form.centre + dot(form.slopes, directions_);
}

Ball Step::between(Term term, const Ball& from, const Ball& until, std::size_t derivative) const {
  const Ball middle = ((from + until) / 2).middle();
  const Ball half = hull(from - middle, until - middle).size();
  return range(term, middle, derivative) +
         range(term, middle + Ball::within(half), derivative + 1) * Ball::within(half);
}

StateSet Step::after(const Ball& time) const {
  std::vector<Form> forms;
  for (const Term term : flow_.states) forms.push_back(at(term, time));
  return StateSet::of(forms, directions_, inputs_);
}

std::optional<Step::Crossing> Step::crossing(std::size_t guard, const Ball& positive_until) const {
  const Term g = flow_.guards[guard];
  const Ball rounding = length_ * power_of_two(8 - Ball::bits);
  Ball about = positive_until;
  for (int tries = 0; tries < 100; ++tries) {  // Newton, for the centre
    const Ball move = (at(g, about).centre.middle() / at(g, about, 1).centre.middle()).middle();
    about = (about - move).middle();
    if (!move.is_finite() || !(length_ - about).is_positive() || (about + length_).is_negative())
      return std::nullopt;
    if ((rounding - move.size()).is_positive()) break;
  }
  const Ball value = range(g, about), rate = range(g, about, 1);
  if (!rate.is_negative() || (positive_until - about).is_positive()) return std::nullopt;
  const Ball until = (about + 2 * (value / rate).size() + 16 * rounding).upper();
  if (!(length_ - until).is_positive()) return std::nullopt;
  // Each solution has its zero between the two, and one only if the slope keeps its sign.
  const Ball slope = between(g, positive_until, until, 1);
  if (!slope.is_negative() || !range(g, positive_until).is_positive() ||
      !range(g, until).is_negative())
    return std::nullopt;
  const Ball when = about - value / slope;  // Newton, for all solutions
  const Ball from = when.lower(), to = when.upper();
  return Crossing{guard, about, (from - positive_until).is_positive() ? from : positive_until,
                  (until - to).is_positive() ? to : until};
}

/// From the set at one time, close to it, along f by tau = -g / g' and the second order.
StateSet Step::section(const Crossing& crossing) const {
  const StateSet near = after(crossing.about);
  const Row directions = near.directions();
  const std::size_t count = directions.size();
  const Ball tau = hull(crossing.from, crossing.until) - crossing.about;
  Row box;
  for (const Term term : flow_.states)
    box.push_back(range(term, hull(crossing.about, hull(crossing.from, crossing.until))));
  const Series centre(*flow_.tape, values(near.centre, inputs_.centre), 1, 0);
  const Series all(*flow_.tape, over(near, inputs_), 1, count);
  const Series second(*flow_.tape, anywhere(box, inputs_), 2, 0);

  const Term g = flow_.guards[crossing.guard];
  Form time{-centre(g, 0) / centre(g, 1), Row(count)};
  for (std::size_t d = 0; d < count; ++d)
    time.slopes[d] = (all(g, 0) * all.slope(g, 1, d) / all(g, 1) - all.slope(g, 0, d)) / all(g, 1);
  const Ball first_order = time.centre + dot(time.slopes, directions);
  const Ball left = -(tau * tau) * second(g, 2) / all(g, 1);
  std::vector<Form> forms = forms_of(centre, all, flow_.states, 0);
  for (std::size_t i = 0; i < forms.size(); ++i) {
    const Term z = flow_.states[i];
    forms[i].centre += centre(z, 1) * time.centre + all(z, 1) * left + tau * tau * second(z, 2);
    for (std::size_t d = 0; d < count; ++d)
      forms[i].slopes[d] += all.slope(z, 1, d) * first_order + all(z, 1) * time.slopes[d];
  }
  return StateSet::of(forms, directions, inputs_);
}

namespace {

/// Where, of what comes after `from`, a term is first not proven positive.
std::optional<Ball> first_doubt(const Step& step, Term term, const Ball& from, const Ball& until,
                                int depth = 12) {
  if (step.between(term, from, until).is_positive()) return std::nullopt;
  if (depth == 0) return from;
  const Ball middle = ((from + until) / 2).middle();
  if (auto doubt = first_doubt(step, term, from, middle, depth - 1)) return doubt;
  return first_doubt(step, term, middle, until, depth - 1);
}

/// Since when a term is positive which vanishes at the start with its first derivatives: until then
/// the next derivative is positive. None if that is not proven.
std::optional<Ball> positive_since(const Step& step, Term term, std::size_t vanishing) {
  if (vanishing == 0) return Ball(0);
  Ball since = step.length();
  for (int halvings = 0; halvings < 30; ++halvings) {
    if (step.between(term, 0, since, vanishing).is_positive()) return since;
    since = (since / 2).middle();
  }
  return std::nullopt;
}

}  // namespace

Passage follow(const Flow& flow, const Inputs& inputs, StateSet set,
               std::vector<std::size_t> vanishing, const Settings& settings, Ball& step_length,
               const StepObserver& observer) {
  vanishing.resize(flow.guards.size());
  const Ball shortest = step_length * power_of_two(-40);
  for (;;) {
    const Step step(flow, inputs, set, settings, step_length);
    const Ball length = step.length();
    std::vector<std::optional<Ball>> since, doubts;
    Ball clear = length;
    for (std::size_t g = 0; g < flow.guards.size(); ++g) {
      since.push_back(positive_since(step, flow.guards[g], vanishing[g]));
      doubts.push_back(since[g] ? first_doubt(step, flow.guards[g], *since[g], length) : Ball(0));
      if (doubts[g] && (clear - *doubts[g]).is_positive()) clear = *doubts[g];
    }
    for (std::size_t g = 0; g < flow.guards.size(); ++g) {
      const auto crossing = doubts[g] && since[g] ? step.crossing(g, *doubts[g]) : std::nullopt;
      if (!crossing) continue;
      bool is_first = true;
      for (std::size_t other = 0; other < flow.guards.size(); ++other)
        is_first = is_first &&
                   (other == g || (since[other] && !first_doubt(step, flow.guards[other],
                                                                *since[other], crossing->until)));
      if (!is_first) continue;
      observer(step, crossing->from, crossing->until);
      return {g, step.section(*crossing)};
    }
    // As far as nothing happens, if that is anywhere.
    if ((clear * 1024 - length).is_positive()) {
      observer(step, clear, clear);
      set = step.after(clear);
      std::fill(vanishing.begin(), vanishing.end(), 0);
      step_length = (length * 1.3).middle();
    } else {
      step_length = (length / 8).middle();
      if ((shortest - step_length).is_positive()) throw Undecided("whether a guard vanishes");
    }
  }
}

}  // namespace proof
