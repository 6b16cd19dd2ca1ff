/// The landmarks of a run, gathered from what an observer is shown.
#pragma once

#include <optional>

#include "model/mechanics/contact.hpp"
#include "model/simulation/observer.hpp"
#include "model/simulation/outcome.hpp"

namespace rotor {

/// What has not happened is empty. Forces are magnitudes.
struct Summary {
  Outcome outcome = Outcome::undecided;
  std::optional<double> first_contact_s;
  long collisions = 0;  ///< touch-downs
  std::optional<double> rolling_onset_s;
  std::optional<double> rolling_onset_speed_Hz;
  std::optional<double> rolling_onset_force_N;
  std::optional<double> rolling_until_s;  ///< end of the last time that it rolled, if it ended
  std::optional<double> peak_normal_force_N;
  std::optional<double> peak_time_s;
  std::optional<double> max_displacement_m;  ///< of O from O_a, after the mass loss
  long collisions_before_loss = 0;           ///< of the touch-downs; all, without mass loss
  std::optional<double> peak_normal_force_before_loss_N;
  double max_displacement_before_loss_m = 0;
  double contact_time_s = 0;        ///< sliding or rolling
  double peak_bearing_force_N = 0;  ///< |k r_O + d v_O| of the supports
  /// Of O about O_a, negative against the rotation: its mean over the last time that the rotor
  /// rolls, which is this window.
  std::optional<double> whirl_frequency_Hz, whirl_from_s, whirl_until_s;
  std::optional<double> motor_off_s;
  std::optional<double> speed_at_separation_Hz;
  double final_speed_Hz = 0;
  double final_kinetic_energy_J = 0;
  double final_q1_m = 0;
  double final_q2_m = 0;
};

class SummaryObserver : public Observer {
 public:
  explicit SummaryObserver(const Scenario& scenario)
      : ring_(scenario.parameters),
        supports_(scenario.parameters, scenario.equations),
        watch_(scenario) {}

  /// The same of a run on its way to what another scenario states, which has not differed so far:
  /// clear of the ring, before its mass loss and time_of_speed_s().
  SummaryObserver with(const Scenario& scenario) const;
  /// When the speed is to be known that tells whether the rotor stalls, s.
  double time_of_speed_s() const { return watch_.time_of_speed_s(); }

  /// Takes the instants of a run in order, the first one at its start.
  void on_instant(const Instant& at) override;
  bool wants_dense_output(const double& from_s, const double& until_s) const override;
  void on_step(const DenseOutput& step) override;
  double threshold(Extreme of, const double& from_s, const double& until_s) const override;
  void on_maximum(const Maximum& maximum) override;
  bool goes_on(const Progress& now) override;
  const Summary& summary() const { return summary_; }

 private:
  void note_extremes(const Instant& at, const Motion<double>& motion);
  void note_contact(const Instant& at, const Motion<double>& motion);

  Ring<double> ring_;
  Supports<double> supports_;
  OutcomeWatch watch_;
  Instant last_;
  bool begun_ = false, rolls_ = false;
  std::optional<Progress> rolls_since_, last_progress_;
  Summary summary_;
};

}  // namespace rotor
