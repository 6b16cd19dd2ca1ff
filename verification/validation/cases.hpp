/// What is compared with others' results: accidents that an independent code computes, too, and
/// measured rebounds.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/scenario/instant.hpp"

namespace rotor {

/// A rotor from just after its mass loss on, without torque.
struct ComparedAccident {
  std::string name;
  Scenario scenario;
  Instant from;
  Scenario given;  ///< to the other code: the same, or with a mistake that must show
  Instant given_from;
  double until_s = 0.2;         ///< after the mass loss
  double force_allowed = 1e-3;  ///< relative difference of the largest force
  bool mistaken = false;
};

/// Gravity's moment is balanced in all: the whole of it has no force.
std::vector<ComparedAccident> accidents();

/// Those of reference-data/problems that the other code can state, which has no torque, and whose
/// samples would pass over a graze.
std::vector<ComparedAccident> problems();

/// A result, and its allowed differences: of times (s) and counts absolute, otherwise relative.
struct Finding {
  std::string quantity;
  double value, allowed, lever_allowed = 0;  ///< lever_allowed: from with_lever(), if not 0

  double difference(double other) const;
};
double find(const std::vector<Finding>& all, const std::string& quantity);  ///< NaN if not there

/// Gathers results from samples of the motion, about a microsecond apart.
struct Course {
  struct Sample {
    double time_s, gap, normal_force_N, friction_N, speed_Hz, q1_m = 0, q2_m = 0;
  };
  void add(const Sample& now, double friction_coefficient);
  std::vector<Finding> findings(const ComparedAccident& of) const;
  /// As reference-data/problems names them.
  std::map<std::string, double> values(const Parameters& p) const;

  std::vector<double> touch_downs_s;
  std::optional<double> onset_s, onset_Hz, onset_N;
  double peak_N = 0, peak_s = 0, contact_s = 0, least_gap = std::numeric_limits<double>::infinity();
  Sample last{};
};

Course by_engine(const ComparedAccident& accident);

/// The engine's equations, but with friction at r - Delta/2 from O, by fixed steps, and with
/// regularised friction: both as in the other code.
Course with_lever(const ComparedAccident& accident);

/// Of the other code: its longer step, 4e-8 s for the paper's rotor; by how much the other is
/// shorter; the viscosity of its friction, as large as a step allows, N s/m.
double coarse_step_s(const Parameters& p);
inline constexpr int finer = 3;
double viscosity(const Parameters& p, double step_s);
/// In Hertz's contact the other code's viscosity grows with the root of the indentation, m, up to
/// this one.
double deepest_for_viscosity(const Parameters& p);

/// At which an undamped ring presses the rim with that force, m.
double indentation(const Parameters& p, double force_N);

/// Of the sphere of reference-data/measured-rebounds.csv at an angle from the wall's normal.
struct Rebound {
  double tangential_restitution;
  bool slides;  ///< throughout
};
Rebound rebound(double angle_deg);

}  // namespace rotor
