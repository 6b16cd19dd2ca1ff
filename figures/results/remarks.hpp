/// Remarks: what a reader should know besides the numbers.
#pragma once

#include <optional>
#include <vector>

#include "model/scenario/scenario.hpp"

namespace rotor {

/// Of the circumstances of a run, or of a stated stop or mass loss that it did not reach.
struct Remark {
  Message message;
  enum class Of { circumstances, missed_stop, missed_loss } of = Of::circumstances;
};

/// What an engineer would question about a rotor, be it run or estimated: inputs that are probably
/// in other units.
std::vector<Remark> remarks_on_rotor(const Scenario& scenario, std::optional<double> loss_speed_Hz);

}  // namespace rotor
