/// The largest values of the motion that a run shows, sampled densely, beside those that it
/// reports.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"

namespace rotor {

class DenseMaxima : public Observer {
 public:
  /// A parabola over a radian is missed by 1e-4 with 40 samples of an arc. Normal forces count
  /// from a time on once more.
  explicit DenseMaxima(const Scenario& scenario, long samples_of_arc = 40, double late_s = 0)
      : ring_(scenario.parameters),
        supports_(scenario.parameters),
        samples_of_arc_(samples_of_arc),
        late_s_(late_s) {}

  void on_instant(const Instant& at) override { note(at); }
  bool wants_dense_output(const double&, const double&) const override { return true; }
  void on_step(const DenseOutput& step) override {
    const long samples = samples_of_arc_ * step.arcs;
    for (long n = 0; n <= samples; ++n)
      note(step.at(step.from_s + (step.until_s - step.from_s) * static_cast<double>(n) /
                                     static_cast<double>(samples)));
    longest_arcs = std::max(longest_arcs, step.arcs);
  }

  double displacement = 0, bearing_force = 0, normal_force = 0;
  double force_rounding = 0;  ///< of the normal force, N: what a rounding of the state changes
  double late_normal_force = 0;
  long longest_arcs = 0;

 private:
  void note(const Instant& at) {
    const Motion<double> m = at.motion();
    displacement = std::max(displacement, m.displacement.norm());
    bearing_force = std::max(bearing_force, supports_.bearing_force(m).norm());
    if (!at.touches()) return;
    const RimPoint<double> k = ring_.rim_point(m);
    const double force = -ring_.elastic_force(k);
    if (force > normal_force) {
      normal_force = force;
      force_rounding = (ring_.law.tangent_stiffness(k.indentation) * k.displacement +
                        ring_.law.damping() * Vector<double>(at.state[3], at.state[4]).norm()) *
                       std::numeric_limits<double>::epsilon();
    }
    if (at.time_s >= late_s_) late_normal_force = std::max(late_normal_force, force);
  }

  Ring<double> ring_;
  Supports<double> supports_;
  long samples_of_arc_;
  double late_s_;
};

/// Which largest value of a run is exceeded by a sample of its motion, by more than rounding
/// and a thousandth of what a step may be wrong; empty if none is.
inline std::string exceeded_maximum(const Scenario& scenario) {
  DenseMaxima dense(scenario, 16);
  SummaryObserver observer(scenario);
  ObserverGroup observers{&dense, &observer};
  run(scenario, observers);
  const Summary& found = observer.summary();
  std::string all;
  const Parameters& p = scenario.parameters;
  const double offset_force = p.support_stiffness * std::hypot(p.ring_offset_x, p.ring_offset_y);
  // Where a quantity is constant but for errors of the steps, their curves have maxima of their
  // own.
  const double error = 1e-3 * scenario.tolerance * Ring<double>(p).clearance / 300;
  const auto compare = [&](const char* of, double reported, double sampled, double rounding) {
    if (sampled > reported * (1 + 1e-12) + rounding)
      all += fmt::format("the largest {} is {:.15g} at tolerance {}, a sample {:.15g}; ", of,
                         reported, scenario.tolerance, sampled);
  };
  compare("displacement",
          std::max(found.peak_displacement_before_loss_m, found.peak_displacement_m.value_or(0)),
          dense.displacement, error);
  compare("bearing force", found.peak_bearing_force_N, dense.bearing_force,
          1e-12 * offset_force +  // of which it is a difference
              p.support_stiffness * error);
  compare("normal force", found.peak_normal_force_N.value_or(0), dense.normal_force,
          4 * dense.force_rounding);
  return all;
}

}  // namespace rotor
