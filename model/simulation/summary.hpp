/// The landmarks of a run, gathered from what an observer is shown.
#pragma once

#include <optional>

#include "model/mechanics/contact.hpp"
#include "model/simulation/observer.hpp"
#include "model/simulation/outcome.hpp"

namespace rotor {

/// What has not happened is empty. Forces are magnitudes.
template <class S>
struct BasicSummary {
  Outcome outcome = Outcome::undecided;
  std::optional<S> first_contact_s;
  long collisions = 0;  ///< touch-downs
  std::optional<S> rolling_onset_s;
  std::optional<S> rolling_onset_speed_Hz;
  std::optional<S> rolling_onset_force_N;
  std::optional<S> rolling_until_s;  ///< end of the last time that it rolled, if it ended
  std::optional<S> peak_normal_force_N;
  std::optional<S> peak_time_s;
  std::optional<S> max_displacement_m;  ///< of O from O_a, after the mass loss
  long collisions_before_loss = 0;      ///< of the touch-downs; all, without mass loss
  std::optional<S> peak_normal_force_before_loss_N;
  S max_displacement_before_loss_m{0};
  S contact_time_s{0};        ///< sliding or rolling
  S peak_bearing_force_N{0};  ///< |k r_O + d v_O| of the supports
  /// Of O about O_a, negative against the rotation: its mean over the last time that the rotor
  /// rolls, which is this window.
  std::optional<S> whirl_frequency_Hz, whirl_from_s, whirl_until_s;
  std::optional<S> motor_off_s;
  std::optional<S> speed_at_separation_Hz;
  S final_speed_Hz{0};
  S final_kinetic_energy_J{0};
  S final_q1_m{0};
  S final_q2_m{0};
};

/// Definitions: summary.ipp.
template <class S>
class BasicSummaryObserver : public BasicObserver<S> {
 public:
  explicit BasicSummaryObserver(const Scenario& scenario)
      : ring_(scenario.parameters),
        supports_(scenario.parameters, scenario.equations),
        watch_(scenario) {}

  /// The same of a run on its way to what another scenario states, which has not differed so far:
  /// clear of the ring, before its mass loss and time_of_speed_s().
  BasicSummaryObserver with(const Scenario& scenario) const;
  /// When the speed is to be known that tells whether the rotor stalls, s.
  const S& time_of_speed_s() const { return watch_.time_of_speed_s(); }

  /// Takes the instants of a run in order, the first one at its start.
  void on_instant(const BasicInstant<S>& at) override;
  bool wants_dense_output(const S& from_s, const S& until_s) const override;
  void on_step(const BasicDenseOutput<S>& step) override;
  S threshold(Extreme of, const S& from_s, const S& until_s) const override;
  void on_maximum(const BasicMaximum<S>& maximum) override;
  bool goes_on(const BasicProgress<S>& now) override;
  const BasicSummary<S>& summary() const { return summary_; }

 private:
  void note_extremes(const BasicInstant<S>& at, const Motion<S>& motion);
  void note_contact(const BasicInstant<S>& at, const Motion<S>& motion);

  Ring<S> ring_;
  Supports<S> supports_;
  BasicOutcomeWatch<S> watch_;
  BasicInstant<S> last_;
  bool begun_ = false, rolls_ = false;
  std::optional<BasicProgress<S>> last_progress_;
  std::optional<BasicProgress<S>> whirl_;        ///< where its angle was last known
  std::optional<BasicProgress<S>> rolls_since_;  ///< with the angle as it would be there now
  BasicSummary<S> summary_;
};

using Summary = BasicSummary<double>;
using SummaryObserver = BasicSummaryObserver<double>;

}  // namespace rotor
