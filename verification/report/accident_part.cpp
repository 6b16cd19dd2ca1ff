/// Six moments of the accident as stills, for print, the README and browsers without scripts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "figures/input/words.hpp"
#include "model/mechanics/contact.hpp"
#include "verification/report/document.hpp"
#include "verification/report/engine/explorer.hpp"

namespace rotor {
namespace {

// In the picture the ring's radius is 100.
constexpr double enlarged = 5;  ///< the clearance
constexpr double arrow_per_N = 60 / 455e3;

struct Frame {
  double time_s, y_a_m, x_a_m, q3_rad, normal_N, friction_N, speed_Hz;
  int state;
};

std::vector<Frame> frames_of(const Picture& picture) {
  std::map<std::string, std::size_t> column;
  for (const auto& name : picture.metadata["motion"]) column.emplace(name, column.size());
  std::vector<Frame> frames;
  for (std::size_t n = 0; n < picture.motion.rows(); ++n) {
    const auto at = [&](const char* name) { return picture.motion.row(n)[column.at(name)]; };
    frames.push_back({at("time_s"), at("y_a_m"), at("x_a_m"), at("q3_rad"), at("normal_force_N"),
                      at("friction_force_N"), at("speed_Hz"),
                      static_cast<int>(at("contact_state"))});
  }
  return frames;
}

/// Coordinates in the picture: y_a to the right, x_a down. The rotor turns from x_a to y_a.
Json drawn(const Frame& frame, const Parameters& p) {
  const double per_m = 100 / p.stator_radius;
  const double radius = 100 - enlarged * Ring<double>(p).clearance * per_m;
  const double x = enlarged * frame.y_a_m * per_m, y = enlarged * frame.x_a_m * per_m;
  const double distance = std::max(std::hypot(x, y), 1e-9), nx = x / distance, ny = y / distance;
  const double kx = x + radius * nx, ky = y + radius * ny;
  // On the rotor: F_n is negative along n; F_tau is positive in the sense of q3, (ny, -nx) here.
  const double fx = (frame.normal_N * nx + frame.friction_N * ny) * arrow_per_N,
               fy = (frame.normal_N * ny - frame.friction_N * nx) * arrow_per_N;
  const auto place = [](double value) { return fmt::format("{:.2f}", value); };
  return {{"x", place(x)},
          {"y", place(y)},
          {"radius", place(radius)},
          {"lost_x", place(x - 0.92 * radius * std::sin(frame.q3_rad))},  // opposite to C
          {"lost_y", place(y - 0.92 * radius * std::cos(frame.q3_rad))},
          {"k_x", place(kx)},
          {"k_y", place(ky)},
          {"force_x", place(kx + fx)},
          {"force_y", place(ky + fy)},
          {"touches", frame.normal_N < 0}};
}

/// The moments shown as stills, from a trace that contains them: each event, each maximum.
std::vector<std::pair<const char*, Frame>> moments(const std::vector<Frame>& frames,
                                                   double loss_s) {
  const auto touches = [](const Frame& frame) { return frame.normal_N < 0; };
  const auto strongest = [](auto from, auto until) {
    return *std::min_element(
        from, until, [](const Frame& a, const Frame& b) { return a.normal_N < b.normal_N; });
  };
  const auto begin = frames.begin(), end = frames.end();
  const auto loss = std::find_if(begin, end, [&](const Frame& f) { return f.time_s >= loss_s; });
  const auto first = std::find_if(loss, end, touches), free = std::find_if_not(first, end, touches);
  const auto rolling = std::find_if(first, end, [](const Frame& f) { return f.state == 2; });
  if (rolling == end) throw std::runtime_error("the accident does not end in rolling");
  const auto sliding =
      std::find_if_not(std::make_reverse_iterator(rolling), frames.rend(), touches).base();
  return {{"Before the loss", *begin},
          {"A piece leaves", *loss},
          {"First impact", strongest(first, free)},
          {"Sliding along the ring", *(sliding + (rolling - sliding) * 3 / 4)},
          {"Slip ends", *rolling},
          {"Largest force", strongest(rolling, end)}};
}

}  // namespace

Json accident_json() {
  const Parameters p;
  const auto frames =
      frames_of(Explorer().run({{"equations", "published"}, {"until", "29.14"}}, 1e-6));
  Json all = Json::array();
  for (const auto& [title, frame] : moments(frames, p.mass_loss_time)) {
    Json still = drawn(frame, p);
    still["title"] = title;
    still["has_piece"] = frame.time_s < p.mass_loss_time;
    still["leaves"] = frame.time_s == p.mass_loss_time;
    still["left"] = 244 * all.size();                                                 // in a row
    const double after_us = std::round(1e6 * (frame.time_s - p.mass_loss_time)) + 0;  // no -0
    still["after_loss"] = fmt::format("{:.2f}", after_us / 1e3);
    still["force_kN"] = fmt::format("{:.0f}", -frame.normal_N / 1e3);
    still["speed_Hz"] = fmt::format("{:.1f}", frame.speed_Hz);
    all.push_back(still);
  }
  return {{"stills", all},
          {"tint", sets_in_words[0].light},
          {"words", std::string(sets_in_words[0].words)},
          {"enlarged", fmt::format("{:g}", enlarged)}};
}

}  // namespace rotor
