/// A whole run: run-up, mass loss, rub. The run-up knows nothing of friction, contact and mass loss
/// as long as the rotor stays clear of the ring, so that runs which differ only in those can share
/// it.
#pragma once

#include "model/instant.hpp"
#include "model/scenario.hpp"

namespace rotor {

/// What a run has cost.
struct Work {
  long steps = 0;
  long right_hand_sides = 0;
  long contact_evaluations = 0;  ///< of Eqs. (15)-(25), inside right-hand sides and outside
};

/// The rotor at t = 0, which is where every run starts.
Instant start(const Scenario& scenario);

/// Goes on from `from`, clear of the ring, up to the time `until_s`, or less far if the rotor would
/// touch the ring before: then up to where it is still clear. The observer sees every instant after
/// `from`; `work` is added to. Throws std::runtime_error if the run diverges.
Instant run_up(const Scenario& scenario, const Instant& from, double until_s,
               const Observer& observer, Work& work);

/// Goes on from `from` to the end of the scenario, through the mass loss if it is still to come and
/// through all contacts. Otherwise as run_up.
Instant run(const Scenario& scenario, const Instant& from, const Observer& observer, Work& work);

/// The part of a scenario on which its run-up depends. Scenarios whose parts are equal share it.
Scenario run_up_part(const Scenario& scenario);

/// Where the run-up of a scenario ends if the rotor does not touch the ring before, s.
double run_up_end(const Scenario& scenario);

}  // namespace rotor
