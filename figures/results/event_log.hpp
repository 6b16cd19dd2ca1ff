/// Lists the events of a run.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "figures/runs/scene.hpp"

namespace rotor {

class EventLog : public Observer {
 public:
  /// Receives events: the name, and the values of columns().
  using Sink = std::function<void(std::string_view event, std::span<const double>)>;

  EventLog(const Scenario& scenario, Sink sink) : context_(scenario), sink_(std::move(sink)) {}

  void on_instant(const Instant& at) override {
    if (at.event == Event::none) return;
    InstantView view(at, context_);
    std::vector<double> row;
    for (const Column* column : columns()) row.push_back(column->value(view));
    sink_(name_of(at.event), row);
  }

  /// Time, state, normal force and slip.
  static std::vector<const Column*> columns() {
    return parse_columns({"time_s", "q1_m", "q2_m", "q3_rad", "q1_rate_m_per_s", "q2_rate_m_per_s",
                          "q3_rate_rad_per_s", "contact_state", "normal_force_N",
                          "slip_velocity_m_per_s"});
  }

 private:
  ColumnContext context_;
  Sink sink_;
};

}  // namespace rotor
