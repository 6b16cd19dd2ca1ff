/// A few values of each figure's curves in quadruple precision.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "figures/scenes/scene.hpp"
#include "model/simulation/extended/quad.hpp"
#include "verification/support/observers.hpp"

namespace rotor {

using QuadInstant = BasicInstant<Quad>;

/// A time at which a figure's curves are looked at.
struct Probe {
  int figure;
  std::string run;
  std::vector<std::string> columns;
  bool from_rolling_onset;  ///< whether the time is counted from there, until it is known
  Quad time_s;
  QuadInstant at{};
  bool seen = false;
};

/// Whoever copies a run means the same probes.
using Probes = std::vector<std::shared_ptr<Probe>>;

/// At times spread over the window of a scene.
void add_probes(Probes& probes, int figure, const std::string& run, const Scene& scene);

/// Keeps what it is shown, and looks at the probes.
class ProbedRun : public BasicEventRecorder<Quad> {
 public:
  explicit ProbedRun(Probes probes) : probes_(std::move(probes)) {}
  void look_at(const Probes& probes) { probes_ = probes; }

  void on_instant(const QuadInstant& at) override;
  bool wants_dense_output(const Quad& from_s, const Quad& until_s) const override;
  void on_step(const BasicDenseOutput<Quad>& step) override;

 private:
  Probes probes_;
};

/// The rows of a run's probes: figure,run,time_s,column,value. Throws std::runtime_error if one has
/// not been seen.
std::string figure_values(const Probes& probes, const Scenario& scenario);

}  // namespace rotor
