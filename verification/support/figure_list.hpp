/// The paper's figures as its text states them, and what each shows: written out anew, so that a
/// scene file that states something else is noticed.
#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "model/simulation/scenario.hpp"

namespace rotor {

struct Figure {
  int number;
  double from_s, until_s;  ///< the window; of Fig. 10 its length, from the onset of rolling on
  std::vector<std::string> columns;
  std::vector<std::pair<std::string, Scenario>> runs;  ///< by their names
};

inline void PrintTo(const Figure& figure, std::ostream* out) { *out << "Fig. " << figure.number; }

/// Figs. 2-17.
inline std::vector<Figure> paper_figures() {
  const auto run = [](double until_s, double friction = 0.3, Method method = Method::event) {
    return Scenario{.parameters = {.friction = friction}, .method = method, .until = until_s};
  };
  const auto loss_at = [](double separation_s, double until_s) {
    return Scenario{.parameters = {.separation_time = separation_s}, .until = until_s};
  };
  const auto stiffness = [](double newton_per_m) {
    return Scenario{.parameters = {.contact_stiffness = newton_per_m}, .until = 29.16};
  };
  const std::string t = "time_s", f_n = "normal_force_N", f = "speed_Hz", rho = "rho_m",
                    x = "x_a_m", y = "y_a_m", state = "contact_state";
  const std::vector<std::pair<std::string, Scenario>> frictions = {
      {"mu = 0.3", run(29.35)},
      {"mu = 0.2", run(29.35, 0.2)},
      {"mu = 0.08", run(29.35, 0.08)},
      {"mu = 0.3 by rk4", run(29.35, 0.3, Method::rk4)},
      {"mu = 0.2 by rk4", run(29.35, 0.2, Method::rk4)},
      {"mu = 0.08 by rk4", run(29.35, 0.08, Method::rk4)}};
  Scenario no_loss = run(4);
  no_loss.parameters.separates = false;
  return {
      {2, 0, 6.5, {t, "q1_m", "q2_m", rho}, {{"run", run(6.5)}}},
      {3, 29.1, 29.35, {t, f_n}, frictions},
      {4, 29.1, 29.35, {t, f}, frictions},
      {5, 29.1, 29.14, {t, f_n, state}, {{"run", run(29.14)}}},
      {6, 29.1, 29.14, {t, "kinetic_energy_J", state}, {{"run", run(29.14)}}},
      {7, 29.12, 29.15, {t, "q1_m", rho, state}, {{"run", run(29.15)}}},
      {8, 29, 29.13, {t, x, y}, {{"run", run(29.13)}}},
      {9,
       29,
       29.35,
       {t, x, y},
       {{"event", run(29.35, 0.08)}, {"rk4", run(29.35, 0.08, Method::rk4)}}},
      {10, 0, 1.3e-3, {t, x, y, rho, f, "slip_velocity_m_per_s"}, {{"run", run(29.135)}}},
      {11,
       29.1,
       29.16,
       {t, f_n},
       {{"k_t", stiffness(8e8)}, {"2 k_t", stiffness(16e8)}, {"0.5 k_t", stiffness(4e8)}}},
      {12, 19.1, 19.2, {t, f_n, f}, {{"run", loss_at(19.1, 19.2)}}},
      {13, 14.15, 14.3, {t, f_n, f}, {{"run", loss_at(14.15, 14.3)}}},
      {14, 9, 11, {t, rho, f}, {{"run", loss_at(9.4, 11)}}},
      {15, 9.3, 9.8, {t, rho, f}, {{"run", loss_at(9.4, 9.8)}}},
      {16, 9.3, 9.8, {t, x, y}, {{"run", loss_at(9.4, 9.8)}}},
      {17, 1, 4, {t, rho, f}, {{"a", loss_at(2.2, 4)}, {"b", no_loss}}},
  };
}

}  // namespace rotor
