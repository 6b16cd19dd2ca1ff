/// Maxima along solutions.
#pragma once

#include "verification/proof/solver.hpp"

namespace proof {

/// A ball of the greatest value of a term so far.
class Greatest {
 public:
  /// Over a step. What comes after `surely` may be, up to `at_most`.
  void see(const Step& step, Term term, const Ball& surely, const Ball& at_most) {
    see_part(step, term, 0, surely, 40);
    raise(upper_, step.between(term, surely, at_most).upper());
  }
  Ball value() const { return hull(lower_, upper_); }

 private:
  static void raise(Ball& greatest, const Ball& x) {
    if ((x - greatest).is_positive()) greatest = x;
  }
  void see_part(const Step& step, Term term, const Ball& from, const Ball& until, int depth) {
    const Ball range = step.between(term, from, until);
    if ((lower_ - range).is_positive()) return;
    const Ball middle = ((from + until) / 2).middle();
    const Ball rate = step.between(term, from, until, 1), there = step.range(term, middle);
    raise(lower_, there.lower());
    if (rate.is_positive() || rate.is_negative()) {
      const Ball first = step.range(term, from), last = step.range(term, until);
      raise(lower_, first.lower());
      raise(lower_, last.lower());
      return raise(upper_, hull(first, last).upper());
    }
    // Shorter parts would not be narrower.
    if (depth == 0 || (9 * there.radius() - 8 * range.radius()).is_positive())
      return raise(upper_, range.upper());
    see_part(step, term, from, middle, depth - 1);
    see_part(step, term, middle, until, depth - 1);
  }

  Ball lower_, upper_;
};

}  // namespace proof
