/// The results of a run, gathered from what an observer is shown.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <variant>

#include "model/mechanics/contact.hpp"
#include "model/results/outcome.hpp"
#include "model/scenario/observer.hpp"

namespace rotor {

/// What `summary_fields` lists. What has not happened is empty. Forces are magnitudes.
template <class S>
struct BasicSummary {
  Outcome outcome = Outcome::undecided;
  long touch_downs = 0, touch_downs_before_loss = 0;
  std::optional<S> first_contact_s;
  std::optional<S> rolling_onset_s, rolling_onset_speed_Hz, rolling_onset_force_N, rolling_until_s;
  std::optional<S> peak_normal_force_N, peak_time_s, peak_normal_force_before_loss_N;
  std::optional<S> max_displacement_m;
  S max_displacement_before_loss_m{0};
  S contact_time_s{0};
  S peak_bearing_force_N{0};
  std::optional<S> whirl_frequency_Hz, whirl_from_s, whirl_until_s;
  std::optional<S> motor_off_s;
  std::optional<S> speed_at_mass_loss_Hz, speed_ratio_at_mass_loss;
  S final_time_s{0}, final_speed_Hz{0}, final_kinetic_energy_J{0}, final_q1_m{0}, final_q2_m{0};
  S critical_speed_Hz{0};
  std::optional<S> damping_ratio;
  std::optional<S> lost_mass_kg, inertia_after_loss_kg_m2;
  bool mass_loss_reached = false, motor_off_reached = false;
};

/// Relative to what the error of a real result is judged.
enum class ErrorScale {
  own,         ///< its magnitude
  length,      ///< the same, or a length that is negligible beside the clearance, if that is more
  force,       ///< the same, or the supports' force at that length, if that is more
  of_another,  ///< its magnitude; it follows from another result, or from the inputs alone
  exact        ///< it has none: it is stated, not computed
};

/// One result. The table of all is the one place that says what there is: text, JSON and its
/// schema, the columns of sweeps and the digits of results follow from it.
template <class S>
struct SummaryField {
  using Of = BasicSummary<S>;

  std::string_view key;  ///< with its unit
  std::string_view meaning;
  std::variant<Outcome Of::*, long Of::*, bool Of::*, S Of::*, std::optional<S> Of::*> value;
  ErrorScale scale = ErrorScale::own;
  S (*made_of)(const Of&) = nullptr;  ///< of what it is a small part or difference: that is rounded
};

template <class S>
inline constexpr auto summary_fields = [] {
  using Of = BasicSummary<S>;
  constexpr auto rho = [](const Of& s) { return S(Vector<S>(s.final_q1_m, s.final_q2_m).norm()); };
  return std::to_array<SummaryField<S>>({
      {"outcome",
       "In one word how the run has ended: rolling (the onset has occurred, whatever followed), "
       "stalled (the motor drives and hardly raises the speed, which is below 1.5 times the "
       "critical one), sliding (the contact lasts), freed (there were contacts, and the free rotor "
       "reaches the ring no more at this speed), no_contact (there were none, and it does not "
       "reach the ring), bouncing (there were contacts, and there can be more), undecided (there "
       "were none, and there can be some); the first of these that holds at the end",
       &Of::outcome},
      {"first_contact_s", "First touch-down", &Of::first_contact_s},
      {"touch_downs", "Touch-downs", &Of::touch_downs},
      {"rolling_onset_s", "First instant without slip that friction can hold",
       &Of::rolling_onset_s},
      {"rolling_onset_speed_Hz", "Rotation speed then", &Of::rolling_onset_speed_Hz},
      {"rolling_onset_force_N", "Normal force then", &Of::rolling_onset_force_N},
      {"rolling_until_s", "End of the last time that the rotor rolled; null while it rolls",
       &Of::rolling_until_s},
      {"peak_normal_force_N", "Largest normal force, a located maximum", &Of::peak_normal_force_N},
      {"peak_time_s", "When it occurs", &Of::peak_time_s},
      {"max_displacement_m",
       "Largest distance of O from O_a after the mass loss, or in a run without one; a located "
       "maximum",
       &Of::max_displacement_m, ErrorScale::length},
      {"touch_downs_before_loss", "Of the touch-downs; all of them in a run without mass loss",
       &Of::touch_downs_before_loss},
      {"peak_normal_force_before_loss_N", "Largest normal force before the mass loss",
       &Of::peak_normal_force_before_loss_N},
      {"max_displacement_before_loss_m", "Largest distance of O from O_a before the mass loss",
       &Of::max_displacement_before_loss_m, ErrorScale::length},
      {"contact_time_s", "Time spent sliding and rolling", &Of::contact_time_s, ErrorScale::own,
       [](const Of& s) { return s.contact_time_s > 0 ? s.final_time_s : S(0); }},
      {"peak_bearing_force_N", "Largest |k r_O + d v_O| of the supports", &Of::peak_bearing_force_N,
       ErrorScale::force},
      {"whirl_frequency_Hz",
       "Of O about O_a, negative against the rotation: mean over the last time that the rotor "
       "rolls, from whirl_from_s to whirl_until_s",
       &Of::whirl_frequency_Hz, ErrorScale::own,
       [](const Of& s) {
         using std::abs;
         if (!s.whirl_frequency_Hz) return S(0);
         const S until = *s.whirl_until_s;
         return S(abs(*s.whirl_frequency_Hz) * until / (until - *s.whirl_from_s));
       }},
      {"whirl_from_s", "Beginning of the window of whirl_frequency_Hz", &Of::whirl_from_s},
      {"whirl_until_s", "End of the window of whirl_frequency_Hz", &Of::whirl_until_s},
      {"motor_off_s", "When the motor is switched off", &Of::motor_off_s},
      {"speed_at_mass_loss_Hz", "Rotation speed at the mass loss", &Of::speed_at_mass_loss_Hz},
      {"speed_ratio_at_mass_loss", "The same over the critical speed",
       &Of::speed_ratio_at_mass_loss, ErrorScale::of_another},
      {"final_time_s", "End of the run", &Of::final_time_s, ErrorScale::exact},
      {"final_speed_Hz", "Rotation speed at the end", &Of::final_speed_Hz},
      {"final_kinetic_energy_J", "T of the rotor at the end", &Of::final_kinetic_energy_J},
      {"final_q1_m", "O along x of the rotating axes at the end", &Of::final_q1_m,
       ErrorScale::length, rho},
      {"final_q2_m", "O along y of the rotating axes at the end", &Of::final_q2_m,
       ErrorScale::length, rho},
      {"critical_speed_Hz", "sqrt(k/m) / 2 pi before the mass loss", &Of::critical_speed_Hz,
       ErrorScale::of_another},
      {"damping_ratio", "d / (2 sqrt(k m)) before the mass loss; null if k = 0", &Of::damping_ratio,
       ErrorScale::of_another},
      {"lost_mass_kg", "m_u, Eq. (5); null without mass loss", &Of::lost_mass_kg,
       ErrorScale::of_another},
      {"inertia_after_loss_kg_m2", "I_C1; null without mass loss", &Of::inertia_after_loss_kg_m2,
       ErrorScale::of_another},
      {"mass_loss_reached", "Whether mass has been lost", &Of::mass_loss_reached},
      {"motor_off_reached", "Whether the motor has been switched off", &Of::motor_off_reached},
  });
}();

/// Definitions: summary.ipp.
template <class S>
class BasicSummaryObserver : public BasicObserver<S> {
 public:
  explicit BasicSummaryObserver(const Scenario& scenario);

  /// The same of a run on its way to what another scenario states, which has not differed so far:
  /// clear of the ring, before its mass loss, and before time_of_speed_s() unless that is the same.
  BasicSummaryObserver with(const Scenario& scenario) const;
  /// When the speed must be known that decides whether the rotor stalls, s.
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
  void note_parameters(const Parameters& p);
  void note_extremes(const BasicInstant<S>& at, const Motion<S>& motion);
  void note_contact(const BasicInstant<S>& at, const Motion<S>& motion);

  Ring<S> ring_;
  Supports<S> supports_;
  BasicOutcomeWatch<S> watch_;
  BasicInstant<S> last_;
  bool begun_ = false, rolls_ = false, loses_mass_ = true;
  std::optional<BasicProgress<S>> last_progress_;
  std::optional<BasicProgress<S>> whirl_;        ///< where its angle was last known
  std::optional<BasicProgress<S>> rolls_since_;  ///< with the angle as it would be there now
  BasicSummary<S> summary_;
};

using Summary = BasicSummary<double>;
using SummaryObserver = BasicSummaryObserver<double>;

}  // namespace rotor
