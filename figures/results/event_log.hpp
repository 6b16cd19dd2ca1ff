/// Lists the events of a run.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "figures/record/columns.hpp"
#include "model/scenario/observer.hpp"

namespace rotor {

class EventLog : public Observer {
 public:
  /// Receives events: the name, and the values of columns().
  using Sink = std::function<void(std::string_view event, std::span<const double>)>;

  EventLog(const Scenario& scenario, Sink sink) : context_(scenario), sink_(std::move(sink)) {}

  void on_instant(const Instant& at) override;

  /// Time, state, normal force and slip.
  static std::vector<const Column*> columns();

 private:
  ColumnContext context_;
  Sink sink_;
};

}  // namespace rotor
