/// The processes that mpirun has started together, if any: the first one distributes the points and
/// writes; all compute.
#pragma once

#include <vector>

#include "figures/sweep/point_scheduler.hpp"

namespace rotor {

/// Without MPI, or not under mpirun, there is one rank. One object per program.
class Ranks {
 public:
  Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  ~Ranks();

  int count() const { return count_; }
  bool is_first() const { return rank_ == 0; }

  /// Sends a value from the first rank to all.
  bool broadcast(bool word) const;

  /// For the first rank: receives rows from the others and sends them points, as far as is possible
  /// without waiting.
  void serve(PointScheduler& scheduler);
  /// Waits until all others know that nothing is left.
  void shut_down_workers() const;

 private:
  int rank_ = 0, count_ = 1;
  std::vector<int> out_;  ///< points that each rank has not answered yet
};

/// For all ranks but the first: works on points from the first one until none is left. Throws what
/// the work throws, after reporting it to the first one.
void work_for_first(const Work& work);

}  // namespace rotor
