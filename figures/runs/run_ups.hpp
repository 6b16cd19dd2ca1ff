/// Runs that are watched for their summary alone, and share their run-ups.
#pragma once

#include <limits>
#include <list>
#include <vector>

#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"
#include "model/run/time_at_speed.hpp"

namespace rotor {

/// A run and its summary, as far as they have got.
struct RunUpCheckpoint {
  Simulation simulation;
  SummaryObserver summary;

  /// At the start.
  explicit RunUpCheckpoint(const Scenario& scenario);
};

/// Keeps the run-ups of the last runs at many places on their way. What they take does not depend
/// on how many runs there are.
class RunUps {
 public:
  /// A run on its way to its mass loss, clear of the ring, to the bit as it would get there by
  /// itself. If it is to lose no mass, at its start. Throws as `run` does. Where the monitor stops
  /// the way, the checkpoint is of no use. It goes no further than `latest_s`.
  RunUpCheckpoint checkpoint_before(const Scenario& scenario, Observer& monitor,
                                    double latest_s = std::numeric_limits<double>::infinity());

  /// As the function of that name has it.
  SpeedReached time_at_speed(const Scenario& scenario, double speed_Hz,
                             std::optional<double> until_s, Observer& monitor);

 private:
  /// The runs of one run-up part, in the order of their times.
  struct Family {
    Scenario run_up;
    std::vector<RunUpCheckpoint> checkpoints;
    /// Of those whose summary looks at the speed when the last one's did, from that time on.
    std::vector<RunUpCheckpoint> later{};
  };
  Family& family(const Scenario& scenario);
  RunUpCheckpoint follow(std::vector<RunUpCheckpoint>& checkpoints, double until_s,
                         Observer& monitor);

  std::list<Family> families_;   ///< the last one that was used is first
  std::size_t checkpoints_ = 0;  ///< of all
};

}  // namespace rotor
