/// The columns of traces and scenes, by their names in the header of a CSV file.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "model/scenario/instant.hpp"

namespace rotor {

/// What columns need besides the instant.
struct ColumnContext {
  explicit ColumnContext(const Scenario& scenario)
      : ring(scenario.parameters),
        acting(scenario.parameters, scenario.equations),
        rolls(scenario.method == Method::event) {}

  Ring<double> ring;
  ActingLoads<double> acting;
  bool rolls;  ///< whether the method has a state of rolling, in which friction is a constraint
};

/// One instant, as columns see it. What several columns need is computed once, and only on demand.
class InstantView {
 public:
  InstantView(const Instant& at, const ColumnContext& context) : at_(at), context_(context) {}

  const Instant& at() const { return at_; }
  const Motion<double>& motion() {
    if (!motion_) motion_ = at_.motion();
    return *motion_;
  }
  const RimPoint<double>& rim_point() {
    if (!rim_point_) rim_point_ = ring().rim_point(motion());
    return *rim_point_;
  }
  /// F_n, N.
  double normal_force() { return at_.touches() ? ring().touching_force(rim_point()) : 0; }
  double friction();  ///< F_tau, N
  Vector<double> displacement_in_stator_frame() {
    return in_stator_frame({at_.state[0], at_.state[1]}, at_.state[2]);
  }
  Vector<double> velocity_in_stator_frame() {
    return in_stator_frame(motion().velocity, at_.state[2]);
  }
  const Ring<double>& ring() const { return context_.ring; }
  const ActingLoads<double>& acting() const { return context_.acting; }

 private:
  const Instant& at_;
  const ColumnContext& context_;
  std::optional<Motion<double>> motion_;
  std::optional<RimPoint<double>> rim_point_;
};

struct Column {
  std::string_view name;  ///< with its unit
  std::string_view meaning;
  double (*value)(InstantView&);
  std::optional<Extreme> extreme{};  ///< whose largest magnitude a table should contain
};

/// All columns, in the order in which a trace has them.
std::vector<const Column*> all_columns();

const Column* find_column(std::string_view name);

}  // namespace rotor
