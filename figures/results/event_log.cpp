#include "figures/results/event_log.hpp"

#include "figures/input/scene.hpp"

namespace rotor {

void EventLog::on_instant(const Instant& at) {
  if (at.event == Event::none) return;
  View view(at, context_);
  std::vector<double> row;
  for (const Column* column : columns()) row.push_back(column->value(view));
  sink_(name_of(at.event), row);
}

std::vector<const Column*> EventLog::columns() {
  return parse_columns({"time_s", "q1_m", "q2_m", "q3_rad", "q1_rate_m_per_s", "q2_rate_m_per_s",
                        "q3_rate_rad_per_s", "contact_state", "normal_force_N",
                        "slip_velocity_m_per_s"});
}

}  // namespace rotor
