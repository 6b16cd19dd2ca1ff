/// Validated integration: sets of states that contain every solution which starts in a set, from
/// switch to switch. The method is Lohner's: Taylor series about the centre of the set, their
/// derivatives over all of it, and the remainder over a box that is proven to contain the step.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "verification/proof/state_set.hpp"

namespace proof {

/// A motion: rates, and guards that are positive as long as it lasts.
struct Flow {
  std::shared_ptr<Tape> tape = std::make_shared<Tape>();  // which the terms point at
  std::vector<Term> states, rates, guards;
};

/// How to integrate.
struct Settings {
  std::size_t order;  ///< of the series
  Ball tolerance;     ///< remainder of a step, relative to the state

  /// What suits the precision.
  Settings();
};

/// The solutions from a set over a step.
class Step {
 public:
  /// The length is that which is wished for, or shorter.
  Step(const Flow& flow, const Inputs& inputs, const StateSet& set, const Settings& settings,
       Ball length);

  const Ball& length() const { return length_; }
  /// A time derivative of a term at a time of the step, or at any of a ball.
  Form at(Term term, const Ball& time, std::size_t derivative = 0) const;
  Ball range(Term term, const Ball& time, std::size_t derivative = 0) const;
  /// The same for all times between two.
  Ball between(Term term, const Ball& from, const Ball& until, std::size_t derivative = 0) const;
  StateSet after(const Ball& time) const;

  /// Where a guard vanishes and ceases to be positive, for all solutions between two times, and at
  /// `about` for the one of the centre.
  struct Crossing {
    std::size_t guard;
    Ball about, from, until;
  };
  /// That of a guard which is positive until `positive_until`, if it can be proven.
  std::optional<Crossing> crossing(std::size_t guard, const Ball& positive_until) const;
  /// The set on the surface where the guard vanishes.
  StateSet section(const Crossing& crossing) const;

 private:
  bool enclose(const Row& start, const Ball& length);
  Ball excess() const;

  const Flow& flow_;
  const Inputs& inputs_;
  Row directions_, box_;
  Ball length_;
  Settings settings_;
  Series at_centre_, over_set_, over_box_;
};

/// Sees each step, of which it is sure that the motion lasts until `surely`, and not beyond
/// `at_most`.
using StepObserver = std::function<void(const Step&, const Ball& surely, const Ball& at_most)>;

/// Which guard vanishes first, for all solutions the same, and the set of the states there.
struct Passage {
  std::size_t guard;
  StateSet set;
};

/// Follows a flow until a guard vanishes. Guards that are known to vanish at the start, with so
/// many of their first derivatives less one, are named in `vanishing`. Throws Undecided.
Passage follow(const Flow& flow, const Inputs& inputs, StateSet set,
               std::vector<std::size_t> vanishing, const Settings& settings, Ball& step_length,
               const StepObserver& observer);

}  // namespace proof
