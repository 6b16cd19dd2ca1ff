/// The loss of the same piece from any point of the rim: Sec. 2.2 with plane vectors.
/// model/mechanics/mass_loss.hpp is the case of a point opposite to the unbalance.
#pragma once

#include "model/scenario/instant.hpp"

namespace rotor {

/// m_u, kg: as stated, or that of which the loss moves the mass centre from e_x to k_u e_x.
double lost_mass_by_formula(const Parameters& parameters);

class PlaceOfLoss {
 public:
  /// A loss at an angle from the point opposite to the unbalance, rad: of the mass (kg) that at
  /// that point gives the stated eccentricity, or of another mass.
  PlaceOfLoss(const Parameters& parameters, double angle);
  PlaceOfLoss(const Parameters& parameters, double angle, double lost_mass);

  /// The piece is a point of the rim, and the rest of the rotor remains a rigid body.
  const Body<double>& after() const { return after_; }
  double lost_mass() const { return lost_mass_; }
  const Vector<double>& piece() const { return piece_; }                  ///< from O, m
  double unbalance() const { return after_.mass * after_.eccentricity; }  ///< kg m

  /// The instant after the loss. The axis x of O_a xy then points to the new mass centre.
  /// As printed, O gets the change of the mass centre's velocity once more.
  Instant lose_mass(Instant at, Equations equations) const;

 private:
  double lost_mass_;
  Vector<double> piece_, eccentricity_, shift_;  ///< OD, OC_1 and CC_1, in the axes before the loss
  Body<double> after_;
};

}  // namespace rotor
