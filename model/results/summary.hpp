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

/// The results in `summary_fields`. Empty: has not happened. Forces are magnitudes.
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

/// The reference of a result's relative error.
enum class ErrorScale {
  own,         ///< its magnitude
  length,      ///< the same, but at least a length that is negligible beside the clearance
  force,       ///< the same, but at least the supports' force at that length
  of_another,  ///< its magnitude; it follows from another result, or from the inputs
  exact        ///< no error: it is stated, not computed
};

/// One result. Text, JSON and its schema, the columns of sweeps and guaranteed digits all follow
/// from the table below.
template <class S>
struct SummaryField {
  using Of = BasicSummary<S>;

  std::string_view key;  ///< with its unit
  std::string_view meaning;
  std::variant<Outcome Of::*, long Of::*, bool Of::*, S Of::*, std::optional<S> Of::*> value;
  ErrorScale scale = ErrorScale::own;
  S (*made_of)(const Of&) = nullptr;  ///< the larger quantity of which it is a part or difference
};

template <class S>
inline constexpr auto summary_fields = [] {
  using Of = BasicSummary<S>;
  constexpr auto rho = [](const Of& s) { return S(Vector<S>(s.final_q1_m, s.final_q2_m).norm()); };
  return std::to_array<SummaryField<S>>({
      {"outcome",
       "How the run ended, in one word, the first that holds: rolling (rolling has set in, "
       "whatever followed), stalled (the motor hardly raises the speed, which is below 1.5 times "
       "the critical speed), sliding (the last contact lasts), freed (there were contacts, but the "
       "free rotor cannot reach the ring at this speed), no_contact (there was no contact, and the "
       "free rotor cannot reach the ring), bouncing (there were contacts, and more are possible), "
       "undecided (there was no contact, but one is possible)",
       &Of::outcome},
      {"first_contact_s", "Time of the first touch-down", &Of::first_contact_s},
      {"touch_downs", "Number of touch-downs", &Of::touch_downs},
      {"rolling_onset_s", "Onset of rolling: first time without slip that friction can hold",
       &Of::rolling_onset_s},
      {"rolling_onset_speed_Hz", "Rotation speed at the onset of rolling",
       &Of::rolling_onset_speed_Hz},
      {"rolling_onset_force_N", "Normal force at the onset of rolling", &Of::rolling_onset_force_N},
      {"rolling_until_s", "End of the last interval of rolling; null while the rotor rolls",
       &Of::rolling_until_s},
      {"peak_normal_force_N", "Largest normal force, at a located maximum",
       &Of::peak_normal_force_N},
      {"peak_time_s", "Time of the largest normal force", &Of::peak_time_s},
      {"max_displacement_m",
       "Largest distance of O from O_a after the mass loss, or in a run without one; at a located "
       "maximum",
       &Of::max_displacement_m, ErrorScale::length},
      {"touch_downs_before_loss",
       "Touch-downs before the mass loss; all of them in a run without one",
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
       "Whirl frequency of O about O_a, negative against the rotation: mean over the last interval "
       "of rolling, from whirl_from_s to whirl_until_s",
       &Of::whirl_frequency_Hz, ErrorScale::own,
       [](const Of& s) {
         using std::abs;
         if (!s.whirl_frequency_Hz) return S(0);
         const S until = *s.whirl_until_s;
         return S(abs(*s.whirl_frequency_Hz) * until / (until - *s.whirl_from_s));
       }},
      {"whirl_from_s", "Start of the interval of whirl_frequency_Hz", &Of::whirl_from_s},
      {"whirl_until_s", "End of the interval of whirl_frequency_Hz", &Of::whirl_until_s},
      {"motor_off_s", "Time at which the motor is switched off", &Of::motor_off_s},
      {"speed_at_mass_loss_Hz", "Rotation speed at the mass loss", &Of::speed_at_mass_loss_Hz},
      {"speed_ratio_at_mass_loss", "Rotation speed at the mass loss over the critical speed",
       &Of::speed_ratio_at_mass_loss, ErrorScale::of_another},
      {"final_time_s", "End of the run", &Of::final_time_s, ErrorScale::exact},
      {"final_speed_Hz", "Rotation speed at the end", &Of::final_speed_Hz},
      {"final_kinetic_energy_J", "Kinetic energy T of the rotor at the end",
       &Of::final_kinetic_energy_J},
      {"final_q1_m", "Coordinate of O along x of the rotating axes at the end", &Of::final_q1_m,
       ErrorScale::length, rho},
      {"final_q2_m", "Coordinate of O along y of the rotating axes at the end", &Of::final_q2_m,
       ErrorScale::length, rho},
      {"critical_speed_Hz", "Critical speed sqrt(k/m) / 2 pi before the mass loss",
       &Of::critical_speed_Hz, ErrorScale::of_another},
      {"damping_ratio", "Damping ratio d / (2 sqrt(k m)) before the mass loss; null if k = 0",
       &Of::damping_ratio, ErrorScale::of_another},
      {"lost_mass_kg", "Lost mass m_u, Eq. (5); null without mass loss", &Of::lost_mass_kg,
       ErrorScale::of_another},
      {"inertia_after_loss_kg_m2", "Moment of inertia I_C1; null without mass loss",
       &Of::inertia_after_loss_kg_m2, ErrorScale::of_another},
      {"mass_loss_reached", "Whether mass has been lost", &Of::mass_loss_reached},
      {"motor_off_reached", "Whether the motor has been switched off", &Of::motor_off_reached},
  });
}();

/// Definitions: summary.ipp.
template <class S>
class BasicSummaryObserver : public BasicObserver<S> {
 public:
  explicit BasicSummaryObserver(const Scenario& scenario);

  /// The same for a run that another scenario continues, which must not have differed so far: clear
  /// of the ring, before its mass loss, and before time_of_speed_s() unless that is the same.
  BasicSummaryObserver with(const Scenario& scenario) const;
  /// Time of the speed that decides whether the rotor stalls, s.
  const S& time_of_speed_s() const { return watch_.time_of_speed_s(); }

  /// To be called with the instants of a run in order, from the start on.
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
  std::optional<BasicProgress<S>> whirl_;        ///< where the angle was last known
  std::optional<BasicProgress<S>> rolls_since_;  ///< its angle counted like the present one
  BasicSummary<S> summary_;
};

using Summary = BasicSummary<double>;
using SummaryObserver = BasicSummaryObserver<double>;

}  // namespace rotor
