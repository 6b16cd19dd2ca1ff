/// Where a run's energy goes, by cause: quadrature of the powers along the motion. The run itself
/// does not need it.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "model/scenario/observer.hpp"

namespace rotor {

/// Works by cause, J, or powers, W; negative where the rotor loses energy.
struct EnergyByCause {
  static constexpr auto& loads_by_name = ActingLoads<double>::names;
  std::array<double, loads_by_name.size()> loads{};  ///< in that order
  double drive = 0;                                  ///< that holds the speed
  double contact_damping = 0;
  double friction = 0;

  void add(const EnergyByCause& other, double weight = 1);
  double sum() const;
  /// Of a load. Throws std::out_of_range if there is none of that name.
  double of(std::string_view load) const;
};

/// All in J.
struct EnergyBalance {
  double initial = 0;    ///< of the rotor, its supports and the ring
  EnergyByCause work{};  ///< since the start of the balance
  double mass_loss = 0;  ///< what left with the piece, less what the velocity jump adds as printed
  // Stored now:
  double kinetic = 0;
  double support_springs = 0;
  double contact_spring = 0;

  double content() const { return kinetic + support_springs + contact_spring; }
  /// The error of run and quadrature.
  double residual() const { return content() - initial - work.sum() - mass_loss; }
};

/// The balance from just before the mass loss on, or in a run without one from its start on.
class EnergyObserver : public Observer {
 public:
  explicit EnergyObserver(const Scenario& scenario)
      : acting_(scenario.parameters, scenario.equations),
        ring_(scenario.parameters),
        loses_mass_(scenario.loses_mass()) {}

  void on_instant(const Instant& at) override;
  bool wants_dense_output(const double& /*from_s*/, const double& /*until_s*/) const override {
    return begun_;
  }
  void on_step(const DenseOutput& motion) override;

  bool has_begun() const { return begun_; }  ///< whether the balance has started
  const EnergyBalance& balance() const { return balance_; }
  const std::optional<EnergyBalance>& until_rolling() const { return until_rolling_; }

 private:
  ActingLoads<double> acting_;
  Ring<double> ring_;
  bool loses_mass_, begun_ = false;
  EnergyBalance balance_;
  std::optional<EnergyBalance> until_rolling_;
};

}  // namespace rotor
