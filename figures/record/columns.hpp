/// The columns of traces and scenes, by their names in the header of a CSV file.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "model/phases/phase.hpp"
#include "model/scenario/instant.hpp"
#include "model/scenario/scenario.hpp"

namespace rotor {

/// What columns need besides the instant.
struct ColumnContext {
  explicit ColumnContext(const Scenario& scenario)
      : ring(scenario.parameters),
        supports(scenario.parameters, scenario.equations),
        rolls(scenario.method == Method::event) {}

  Ring<double> ring;
  Supports<double> supports;
  bool rolls;  ///< whether the method has a state of rolling, in which friction is a constraint
};

/// One instant, as columns see it. What several columns need is computed once, and only on demand.
class View {
 public:
  View(const Instant& at, const ColumnContext& context) : at_(at), context_(context) {}

  const Instant& at() const { return at_; }
  const Motion<double>& motion();
  const RimPoint<double>& rim_point();
  bool in_contact() const;
  double normal_force();           ///< F_n, N
  double friction();               ///< F_tau, N
  Vector<double> bearing_force();  ///< on the foundation, N
  Vector<double> displacement_in_stator_frame();
  const Ring<double>& ring() const { return context_.ring; }
  const Supports<double>& supports() const { return context_.supports; }

 private:
  const Instant& at_;
  const ColumnContext& context_;
  std::optional<Motion<double>> motion_;
  std::optional<RimPoint<double>> rim_point_;
};

struct Column {
  std::string_view name;  ///< with its unit
  std::string_view meaning;
  double (*value)(View&);
  std::optional<Extreme> extreme{};  ///< whose largest magnitude a table should contain
};

/// All columns, in the order in which a trace has them.
std::span<const Column> all_columns();
std::vector<const Column*> every_column();  ///< the same, as scenes list them

/// The column of that name, or null.
const Column* find_column(std::string_view name);

}  // namespace rotor
