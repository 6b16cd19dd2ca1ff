/// Lists what happens in a run.
#pragma once

#include <vector>

#include "figures/data/table.hpp"
#include "figures/scenes/columns.hpp"
#include "model/simulation/observer.hpp"

namespace rotor {

class EventLog : public Observer {
 public:
  explicit EventLog(const Scenario& scenario) : context_(scenario) {}

  void on_instant(const Instant& at) override;

  /// Time, state, normal force and slip.
  static std::vector<const Column*> columns();
  /// One table for each event, named after its kind.
  const std::vector<NamedTable>& tables() const { return tables_; }

 private:
  ColumnContext context_;
  std::vector<NamedTable> tables_;
};

}  // namespace rotor
