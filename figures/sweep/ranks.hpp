/// The processes that mpirun has started together, if it has: the first one deals out the points,
/// and writes; all work.
#pragma once

#include <vector>

#include "figures/sweep/block_scheduler.hpp"

namespace rotor {

/// Without MPI, or not under mpirun, there is one rank. One object a program.
class Ranks {
 public:
  Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  ~Ranks();

  int count() const { return count_; }
  bool is_first() const { return rank_ == 0; }

  /// What the first one says to all.
  bool broadcast(bool word) const;

  /// For the first one: takes rows from the others and deals to them what they ask for, as far as
  /// there is something to do now.
  void serve(BlockScheduler& scheduler);
  /// And until all others know that there is nothing more.
  void shut_down_workers(BlockScheduler& scheduler);

 private:
  void answer(BlockScheduler& scheduler, int rank);

  int rank_ = 0, count_ = 1;
  std::vector<int> waiting_;  ///< that have asked when nothing was due
  int shutdowns_ = 0;         ///< that the others still have to get
};

/// For ranks that are not the first: works on what the first one deals out, until there is no more.
/// Throws what the work throws, when the first one knows of it.
void work_for_first(const Work& work);

}  // namespace rotor
