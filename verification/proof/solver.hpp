/// Validated integration: sets of states that contain every solution that starts in a set, from
/// switch to switch. The method is Lohner's: Taylor series about the centre of the set, their
/// derivatives over all of it, and the remainder over a box that is proven to contain the step.
#pragma once

#include <functional>
#include <optional>

#include "verification/proof/series.hpp"

namespace proof {

/// Values over a set: each is form[0] + sum of form[d] x_d, where x_d is within the set's
/// directions[d]. directions[0] is 1, so that dot(form, directions) contains all of the values.
using Form = Row;

/// States, followed by parameters. The first directions are those of the parameters, one each, and
/// do not change; the others are a frame of the states, chosen again after each step.
struct StateSet {
  std::vector<Form> values;
  Row directions;

  /// One state, and parameters within `half` of `centre`, where that is not zero.
  StateSet(const Row& state, const Row& centre, const Row& half);

  Ball range(const Form& form) const { return dot(form, directions); }
  /// The values of terms that do not depend on time, such as a reset.
  std::vector<Form> map(const Tape& tape, const std::vector<Term>& terms) const;
  Ball range(const Tape& tape, Term term) const { return range(map(tape, {term})[0]); }
  /// The set of new states. `scale` weights their errors.
  StateSet with(const std::vector<Form>& states, const Row& scale) const;

  /// Inputs of a series: the centre, or all values and their slopes.
  Matrix centre() const;
  Matrix all() const;
};

/// A motion: states with rates on the tape, and guards that are positive as long as it lasts.
struct Flow {
  Tape tape;
  std::vector<Term> states, guards;
  Row scale;  ///< of the states' errors

  Flow() = default;
  Flow(const Flow&) = delete;  // the terms point at the tape
  Flow& operator=(const Flow&) = delete;
};

/// Order of the series, and the allowed remainder of a step, relative to the state.
struct Settings {
  std::size_t order = static_cast<std::size_t>(3 * Ball::bits / 10);
  Ball tolerance = Ball::power_of_two(-Ball::bits);
};

/// The solutions from a set over a step.
class Step {
 public:
  /// The length is the requested one, or shorter.
  Step(const Flow& flow, const StateSet& set, const Ball& length, const Settings& settings = {});

  const Ball& length() const { return length_; }
  /// A time derivative of a term at a time of the step.
  Form at(Term term, const Ball& time, std::size_t derivative = 0) const;
  Ball range(Term term, const Ball& time, std::size_t derivative = 0) const {
    return set_.range(at(term, time, derivative));
  }
  /// The same for all times between two.
  Ball between(Term term, const Ball& from, const Ball& until, std::size_t derivative = 0) const;
  StateSet after(const Ball& time) const;

  /// Time until which a term is proven positive, if the term and its first `vanishing` - 1
  /// derivatives are zero at the start.
  Ball positive_until(Term term, std::size_t vanishing) const;
  /// A ball of the times at which a term, positive until `clear`, vanishes: exactly once for every
  /// solution. None if that cannot be proven.
  std::optional<Ball> crossing(Term term, const Ball& clear) const;
  /// The set on the surface where the term vanishes.
  StateSet section(Term term, const Ball& crossing) const;

 private:
  bool enclose();
  bool is_accurate();
  Ball first_doubt(Term term, const Ball& from, const Ball& until, int depth) const;

  const Flow& flow_;
  const StateSet& set_;
  Settings settings_;
  Ball length_;
  Matrix box_;
  Series at_centre_, over_set_, over_box_;
};

/// Sees each step; the motion is certain to last until `surely`, and not beyond `at_most`.
using StepObserver = std::function<void(const Step&, const Ball& surely, const Ball& at_most)>;

/// Follows a flow until a guard vanishes, the same one for all solutions; maps the set to there and
/// returns the guard. `vanishing` has the guards that are zero at the start, and the order of the
/// zero. Throws Undecided.
std::size_t follow(const Flow& flow, StateSet& set, std::vector<std::size_t> vanishing,
                   Ball& step_length, const StepObserver& observer);

/// A ball of the greatest value of a term along solutions.
class Greatest {
 public:
  void see(const Step& step, Term term, const Ball& surely, const Ball& at_most);
  Ball value() const { return hull(lower_, upper_); }

 private:
  void see_part(const Step& step, Term term, const Ball& from, const Ball& until, int depth);

  Ball lower_, upper_;
};

}  // namespace proof
