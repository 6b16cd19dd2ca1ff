/// The landmarks of a run, gathered from what an observer is shown.
#pragma once

#include <optional>

#include "model/mechanics/contact.hpp"
#include "model/simulation/observer.hpp"
#include "model/simulation/scenario.hpp"

namespace rotor {

/// What has not happened is empty. Forces are magnitudes.
struct Summary {
  std::optional<double> first_contact_s;
  long collisions = 0;  ///< touch-downs
  std::optional<double> rolling_onset_s;
  std::optional<double> rolling_onset_speed_Hz;
  std::optional<double> rolling_onset_force_N;
  std::optional<double> peak_normal_force_N;
  std::optional<double> peak_time_s;
  std::optional<double> max_displacement_m;  ///< of O from O_a, after the mass loss
  std::optional<double> motor_off_s;
  std::optional<double> speed_at_separation_Hz;
  double final_speed_Hz = 0;
  double final_kinetic_energy_J = 0;
  double final_q1_m = 0;
  double final_q2_m = 0;
};

class SummaryObserver : public Observer {
 public:
  explicit SummaryObserver(const Scenario& scenario) : ring_(scenario.parameters) {}

  /// Takes the instants of a run in order, the first one at its start.
  void on_instant(const Instant& at) override;
  double threshold(Extreme of, const double& from_s, const double& until_s) const override;
  void on_maximum(const Maximum& maximum) override;
  const Summary& summary() const { return summary_; }

 private:
  void note_extremes(const Instant& at, const Motion<double>& motion);
  void note_contact(const Instant& at, const Motion<double>& motion);

  Ring<double> ring_;
  bool touching_ = false, separated_ = false;
  Summary summary_;
};

}  // namespace rotor
