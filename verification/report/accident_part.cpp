/// The accident in slow motion: frames for the animation, stills for paper and for readers who ask
/// for rest.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures/data/csv.hpp"
#include "figures/input/scene.hpp"
#include "verification/report/document.hpp"

namespace rotor {
namespace {

// On the page the ring's radius is 100.
constexpr double enlarged = 5;  ///< the clearance
constexpr double slower = 500;  ///< than in time
constexpr double arrow_per_N = 60 / 455e3;

struct Frame {
  double time_s, y_a_m, x_a_m, q3_rad, normal_N, friction_N, speed_Hz;
  int state;
};

std::vector<Frame> read_frames(const std::filesystem::path& trace) {
  std::vector<Frame> frames;
  for (const CsvRow& row : read_csv(trace)) {
    const auto number = [&](const char* column) { return static_cast<double>(row.number(column)); };
    frames.push_back({number("time_s"), number("y_a_m"), number("x_a_m"), number("q3_rad"),
                      number("normal_force_N"), number("friction_force_N"), number("speed_Hz"),
                      static_cast<int>(number("contact_state"))});
  }
  return frames;
}

double rounded(double value, int digits) {
  const double scale = std::pow(10, digits);
  return std::round(value * scale) / scale + 0;  // no -0
}

/// Where things stand on the page: y_a to the right, x_a down. The rotor turns from x_a to y_a.
Json drawn(const Frame& frame, const Parameters& p) {
  const double per_m = 100 / p.stator_radius;
  const double clearance_m = p.stator_radius - p.rotor_radius;
  const double radius = 100 - enlarged * clearance_m * per_m;
  const double x = enlarged * frame.y_a_m * per_m, y = enlarged * frame.x_a_m * per_m;
  const double distance = std::max(std::hypot(x, y), 1e-9), nx = x / distance, ny = y / distance;
  const double mark_x = std::sin(frame.q3_rad), mark_y = std::cos(frame.q3_rad);
  const double kx = x + radius * nx, ky = y + radius * ny;
  // On the rotor: F_n is negative along n; F_tau is positive in the sense of q3, (ny, -nx) here.
  const double fx = (frame.normal_N * nx + frame.friction_N * ny) * arrow_per_N,
               fy = (frame.normal_N * ny - frame.friction_N * nx) * arrow_per_N;
  const auto place = [](double value) { return fmt::format("{:.2f}", value); };
  return {{"x", place(x)},
          {"y", place(y)},
          {"radius", place(radius)},
          {"mark_x", place(x + 0.86 * radius * mark_x)},
          {"mark_y", place(y + 0.86 * radius * mark_y)},
          {"k_x", place(kx)},
          {"k_y", place(ky)},
          {"force_x", place(kx + fx)},
          {"force_y", place(ky + fy)},
          {"touches", frame.normal_N < 0}};
}

/// The moments that are shown as stills, from a trace that has them: each event, each maximum.
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
  return {{"Quiet running", *begin},
          {"The piece has left", *loss},
          {"First impact", strongest(first, free)},
          {"Sliding along the ring", *(sliding + (rolling - sliding) * 3 / 4)},
          {"Slip ends", *rolling},
          {"Greatest force", strongest(rolling, end)}};
}

Json stills_json(const std::vector<Frame>& frames, const Parameters& p) {
  Json all = Json::array();
  for (const auto& [title, frame] : moments(frames, p.mass_loss_time)) {
    Json still = drawn(frame, p);
    still["title"] = title;
    still["left"] = 244 * all.size();  // in a row
    still["after_loss_ms"] = rounded(1e3 * (frame.time_s - p.mass_loss_time), 3);
    still["force_kN"] = fmt::format("{:.0f}", -frame.normal_N / 1e3);
    still["speed_Hz"] = fmt::format("{:.1f}", frame.speed_Hz);
    all.push_back(still);
  }
  return all;
}

}  // namespace

Json accident_json(const Sources& sources) {
  const Scenario scenario =
      read_scene(sources.texts.parent_path() / "accident.toml").runs[0].scenario;
  const Parameters& p = scenario.parameters;
  const std::vector<Frame> frames = read_frames(sources.report / "accident.csv");
  Json data = Json::array();
  for (const Frame& f : frames)
    data.push_back({rounded(1e3 * (f.time_s - p.mass_loss_time), 3), rounded(1e3 * f.y_a_m, 4),
                    rounded(1e3 * f.x_a_m, 4), rounded(f.q3_rad - frames.front().q3_rad, 3),
                    rounded(f.normal_N / 1e3, 1), rounded(f.friction_N / 1e3, 1), f.state,
                    rounded(f.speed_Hz, 2)});
  const double duration_s = frames.back().time_s - frames.front().time_s;
  return {{"slower", static_cast<long>(slower)},
          {"enlarged", static_cast<long>(enlarged)},
          {"arrow_per_kN", 1e3 * arrow_per_N},
          {"lasts_s", fmt::format("{:.1f}", duration_s * slower)},
          {"first_angle_rad", rounded(frames.front().q3_rad, 6)},
          {"ring_mm", 1e3 * p.stator_radius},
          {"rotor_mm", 1e3 * p.rotor_radius},
          {"stills", stills_json(read_frames(sources.report / "accident-moments.csv"), p)},
          {"last", static_cast<long>(frames.size()) - 1},
          {"frames", data},
          {"frames_text", data.dump()}};
}

}  // namespace rotor
