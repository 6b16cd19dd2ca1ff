/// The runs in the paper's text, for inputs as printed or within their rounding.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "figures/input/scenario_spec.hpp"
#include "figures/runs/run_ups.hpp"

namespace rotor {

/// Inputs from the paper's Nomenclature and text.
struct PaperInputs {
  PaperInputs() { spec.equations = Equations::published; }

  ScenarioSpec spec;  ///< of the rotor, of the equations, and of the method
  double mu_high = 0.3, mu_intermediate = 0.2, mu_low = 0.08;
  double t_operating = 29.1, t_100 = 19.1, t_75 = 14.15, t_50 = 9.4, t_critical = 2.2;
  // Results from which the text computes others, SI.
  double rolling_Hz = 770, rolling_rho = 3.5e-3, onset_Hz = 45, energy_left = 1050,
         energy_before = 4000, shortest_s = 1e-4, longest_s = 3e-4;

  /// Sets one of them by its name in printed-inputs.csv or printed-results.csv.
  void set(const std::string& input, double value);
};

/// A run with its events and measurements.
class PaperRun {
 public:
  PaperRun(const Scenario& scenario, RunUps& run_ups);

  const Scenario& scenario() const { return scenario_; }
  const Summary& summary() const { return summary_; }
  const Instant& before_loss() const { return before_loss_; }
  const Instant& after_loss() const { return after_loss_; }
  const Instant& last() const { return last_; }
  /// Where slip ends for the first time, and where the force is largest. Empty if the rim does not
  /// roll.
  const std::optional<Instant>& onset() const { return onset_; }
  std::optional<Instant> at_peak() const { return onset_ ? peak_ : std::nullopt; }

  /// The number of touch-downs before rolling; and one of them, counted backwards from the last one
  /// (0), empty if there are fewer.
  std::size_t touch_downs_before_rolling() const;
  std::optional<Instant> touch_down_before_rolling(std::size_t from_last) const;
  std::optional<Instant> last_touch_down() const {
    return touch_downs_.empty() ? std::nullopt : std::optional(touch_downs_.back());
  }
  const std::vector<Instant>& releases() const { return releases_; }
  /// The collisions that end with a release.
  struct Collision {
    double duration_s, speed_gain;  ///< the gain in rad/s
  };
  std::vector<Collision> collisions() const;
  /// Largest change of the speed between a release and the next touch-down, relative.
  double change_of_speed_in_flight() const;
  /// Largest normal force relative to m w^2 (r_a - r) at the loss, which is the same in a similar
  /// rotor. Empty without contact.
  std::optional<double> relative_peak() const;
  /// Largest normal force until a time, N.
  double peak_until(double time_s) const;

  /// Measured over the first 5 ms of rolling or the first turn of the whirl. Empty if rolling is
  /// shorter.
  struct Rolling {
    double whirl_Hz;  ///< of O, seen from the stator
    double q1_Hz;     ///< of O, seen from the rotating axes
    double ripple;    ///< of rho, from least to greatest, relative to its mean
    double off_sine;  ///< root mean square of q1 less the best sine, relative to that of q1
    double
        decrease_a_turn;  ///< of the mean of rho between the first turn and the last one, relative
  };
  std::optional<Rolling> first_5_ms() const { return measured(5e-3); }
  std::optional<Rolling> first_turn() const;

 private:
  friend class PaperWatch;
  struct Sample {
    double time_s, rho, turned;  ///< in the rotating axes
    double q3;
  };
  using Samples = std::vector<Sample>::const_iterator;
  std::optional<Rolling> measured(double duration_s) const;
  static double off_sine(Samples from, Samples until);

  Scenario scenario_;
  Summary summary_;
  Instant before_loss_, after_loss_, last_;
  std::optional<Instant> onset_, peak_;
  std::vector<Instant> touch_downs_, releases_;
  std::vector<std::pair<double, double>> forces_;  ///< time and largest force so far
  std::vector<Sample> samples_;
};

/// The runs of one set of inputs, computed when they are first needed, each once.
class PaperRuns {
 public:
  explicit PaperRuns(PaperInputs inputs) : inputs_(std::move(inputs)) {}

  const PaperInputs& inputs() const { return inputs_; }
  /// The rotor before its mass loss.
  Parameters parameters();

  const PaperRun& high() { return rub(inputs_.mu_high); }
  const PaperRun& intermediate() { return rub(inputs_.mu_intermediate); }
  const PaperRun& low() { return rub(inputs_.mu_low); }
  /// At high friction, by any method.
  const PaperRun& high_by(Method method);
  /// At the operating speed, a contact parameter multiplied.
  const PaperRun& changed(double friction, const char* quantity, double factor);
  /// At the operating speed, numbers stated instead of the inputs'.
  const PaperRun& with(double friction, const std::map<std::string, double>& numbers);
  /// From steady motion at a part of the operating speed, with supports whose critical speed is the
  /// same part.
  const PaperRun& from_steady(double part);
  /// What friction dissipates at high friction, J; only by the event method, and if the rotor
  /// rolls.
  struct FrictionWork {
    std::vector<double> until_touch_downs;  ///< one after the other
    double until_rolling;
  };
  const std::optional<FrictionWork>& friction_work();
  /// The same loss at high friction from another point of the rim, until its outcome: see
  /// place_of_loss.hpp.
  const Summary& lost_at(double angle);
  /// When the run-up passes the eigenfrequency of the supports, s.
  std::optional<double> time_at_critical_speed();
  const PaperRun& at_100_Hz() { return loss_at(inputs_.t_100, 0.25); }
  const PaperRun& at_75_Hz() { return loss_at(inputs_.t_75, 0.25); }
  const PaperRun& at_50_Hz() { return loss_at(inputs_.t_50, 3); }
  const PaperRun& near_critical() { return loss_at(inputs_.t_critical, 1.8); }

 private:
  ScenarioSpec spec_with(const std::map<std::string, double>& numbers) const;
  ScenarioSpec at_operating_speed(double friction) const;
  const PaperRun& rub(double friction);
  const PaperRun& loss_at(double time_s, double rub_s);
  const PaperRun& get(const ScenarioSpec& spec);

  PaperInputs inputs_;
  RunUps run_ups_;
  std::deque<PaperRun> runs_;  // references to them stay valid
  std::optional<std::optional<FrictionWork>> friction_work_;
  std::map<double, Summary> lost_at_;
};

}  // namespace rotor
