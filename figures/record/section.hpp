/// A motion at a constant speed, turn by turn.
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <string_view>
#include <vector>

#include "figures/record/recorder.hpp"

namespace rotor {

/// A multiple of the rotation's frequency.
struct Order {
  std::string_view name;
  double multiple;
};
inline constexpr auto orders = std::to_array<Order>(
    {{"1/3", 1 / 3.}, {"1/2", 1 / 2.}, {"2/3", 2 / 3.}, {"1", 1.}, {"3/2", 3 / 2.}, {"2", 2.}});

/// F(o) and F(-o), m: the mean of z exp(-i o phi) over some turns, where z = x_a + i y_a is the
/// position of O and phi the angle of e_x.
struct OrderMeans {
  std::complex<double> forward, backward;

  double peak_to_peak_x() const { return 2 * std::abs(forward + std::conj(backward)); }
  double peak_to_peak_y() const { return 2 * std::abs(forward - std::conj(backward)); }
};

/// What a section tells of the motion.
struct SectionSummary {
  long turns = 0;
  /// The least number of turns after which position and velocity of O come back, in all turns, to
  /// within a millionth of the clearance, and of the clearance times the speed. Empty if there is
  /// none up to `longest_period`, or to half of the turns.
  std::optional<long> repeats_after_turns;
  /// Of the means: the most of the last turns that are a multiple of six, of which each order has
  /// whole periods, and of that number. Without it, or if they are too few, of six.
  long orders_over_turns = 0;
  bool orders_over_whole_periods = false;
  /// Zero over no turns, and where they are below 1e-9 of the largest displacement in the section:
  /// less than the motion between steps is known to.
  std::array<OrderMeans, orders.size()> means{};

  static constexpr long longest_period = 64;
};

/// Throws ScenarioError if a run's turns are not of one length, or if nothing is known of the
/// motion between its steps.
void require_equal_turns(const Scenario& scenario);
/// The number of whole turns of a run; the last may end with it, up to rounding. Throws
/// ScenarioError without equal turns, and if there is none.
long whole_turns(const Scenario& scenario);

/// The last turns of a run, one row each, at the instant at which e_x points down: its points of
/// Poincare.
class Section : public Observer {
 public:
  static constexpr long usual_turns = 192, most_turns = 10000;

  /// Of at most so many turns. Throws as whole_turns().
  Section(const Scenario& scenario, long turns, RowSink sink);
  Section(const Section&) = delete;  // its sink refers to it
  Section& operator=(const Section&) = delete;

  /// Time, position, velocity and normal force.
  static std::vector<const Column*> columns();

  bool wants_dense_output(const double& from_s, const double& until_s) const override;
  void on_step(const DenseOutput& motion) override;

  SectionSummary summary() const;

 private:
  using Means = std::array<OrderMeans, orders.size()>;

  void integrate(const DenseOutput& motion, double from_s, double until_s, Means& into) const;
  std::optional<long> repeats_after_turns() const;
  double end_of_turn_s() const;  ///< of the present one

  /// At the end of a turn: the position of O, and its velocity divided by the speed, m.
  struct Place {
    Vector<double> position, velocity;
  };

  long last_turn_, turns_;
  double turn_s_, near_;
  std::vector<Place> places_;
  std::vector<Means> means_;  ///< of each turn up to the present one
  bool is_complete_ = false;  ///< whether they are those of all turns
  Sampler points_;
};

}  // namespace rotor
