/// Runs that an interruption ends.
#pragma once

#include "figures/data/interruption.hpp"
#include "model/scenario/observer.hpp"

namespace rotor {

/// Ends a run at an interruption.
class Interruptible : public Observer {
 public:
  bool goes_on(const Progress& /*now*/) override { return !is_interrupted(); }
};

}  // namespace rotor
