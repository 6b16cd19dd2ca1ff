/// What the digits of a number are good for, and how long the rub can be foretold. `precision
/// REFERENCE FOLDER` runs the rub scenes in single, double and extended precision over tolerances,
/// against the results in quadruple precision of REFERENCE (FOLDER/precision.csv), and follows a
/// small disturbance from contact to contact (FOLDER/growth.csv).
#include <fmt/format.h>

#include <numbers>

#include "figures/data/files.hpp"
#include "figures/input/scene.hpp"
#include "model/methods/event_method.ipp"
#include "verification/support/follow_with.hpp"
#include "verification/support/program.hpp"
#include "verification/support/reference_tables.hpp"

namespace rotor {
namespace {

using Extended = long double;

/// An event, or the end, as far as one run is compared with another.
struct Landmark {
  std::string kind;
  Extended time_s;
  State<Extended> state;
};

constexpr double origin_s = 29.1;  ///< of time in these runs: single precision has few digits

/// The landmarks of a run of high-precision.csv, from its mass loss on.
std::vector<Landmark> reference(const std::filesystem::path& table, const std::string& run) {
  std::vector<Landmark> landmarks;
  for (const ReferenceLandmark& landmark : reference_run(table, run))
    if (landmark.kind == "mass_loss" || !landmarks.empty())
      landmarks.push_back({landmark.kind, landmark.time_s - origin_s, landmark.state});
  return landmarks;
}

/// The same from a state just after the mass loss, with the digits of S.
template <class S>
std::vector<Landmark> landmarks(double friction, const State<Extended>& after_loss,
                                double tolerance) {
  struct : BasicObserver<S> {
    void on_instant(const BasicInstant<S>& at) override {
      if (at.event != Event::none) add(std::string(name_of(at.event)), at);
    }
    void add(const std::string& kind, const BasicInstant<S>& at) {
      Landmark landmark{.kind = kind, .time_s = static_cast<Extended>(at.time_s), .state = {}};
      for (std::size_t i = 0; i < 6; ++i) landmark.state[i] = static_cast<Extended>(at.state[i]);
      all.push_back(landmark);
    }
    std::vector<Landmark> all;
  } observer;
  const Scenario scenario{.parameters = {.friction = friction}};
  BasicInstant<S> at;
  for (std::size_t i = 0; i < 6; ++i) at.state[i] = static_cast<S>(after_loss[i]);
  at.state[2] = static_cast<S>(std::remainder(after_loss[2], 2 * std::numbers::pi_v<Extended>));
  at.body = MassLoss<S>(scenario.parameters).after;
  at.mass_lost = true;
  at.motor_on = false;
  observer.add("mass_loss", at);
  const auto end = follow_with<S>(scenario, static_cast<S>(tolerance), at,
                                  static_cast<S>(scenario.until - origin_s), observer);
  observer.add("end", end.last);
  return observer.all;
}

/// Of the position relative to the clearance.
double distance(const Landmark& a, const Landmark& b) {
  return static_cast<double>(std::hypot(a.state[0] - b.state[0], a.state[1] - b.state[1])) / 3e-3;
}

/// How many landmarks agree in kind from the start on.
std::size_t common(const std::vector<Landmark>& a, const std::vector<Landmark>& b) {
  const auto differ = std::ranges::mismatch(a, b, {}, &Landmark::kind, &Landmark::kind);
  return static_cast<std::size_t>(differ.in1 - a.begin());
}

template <class S>
std::string errors(const std::string& precision, double friction,
                   const std::vector<Landmark>& exact, int last_digits) {
  std::string csv;
  for (int digits = 3; digits <= last_digits; ++digits) {
    try {
      const auto run = landmarks<S>(friction, exact.front().state, std::pow(10, -digits));
      const std::size_t matched = common(run, exact);
      const bool all = matched == exact.size();
      csv += fmt::format("{},{},1e-{},{:.3e},{},{}\n", friction, precision, digits,
                         all ? distance(run.back(), exact.back()) : NAN, matched, exact.size());
      fmt::print("mu = {:<5} {:<9} 1e-{:<3} {}\n", friction, precision, digits,
                 all ? fmt::format("{:.1e}", distance(run.back(), exact.back()))
                     : fmt::format("other events after {} of {}", matched, exact.size()));
    } catch (const std::runtime_error& error) {
      fmt::print("mu = {:<5} {:<9} 1e-{:<3} {}\n", friction, precision, digits, error.what());
    }
  }
  return csv;
}

/// Follows a disturbance of the position, so small that it stays linear.
std::string growth(double friction, const State<Extended>& after_loss) {
  constexpr double disturbance = 1e-9, tolerance = 1e-16;  // relative to the clearance
  auto disturbed = after_loss;
  disturbed[0] += disturbance * 3e-3L;
  const auto a = landmarks<Extended>(friction, after_loss, tolerance);
  const auto b = landmarks<Extended>(friction, disturbed, tolerance);
  std::string csv;
  int contacts = 0;
  double largest = 1;
  for (std::size_t i = 0; i < common(a, b); ++i) {
    if (a[i].kind != "touch_down") continue;
    const double factor = distance(a[i], b[i]) / disturbance;
    const auto shift_s = static_cast<double>(std::abs(a[i].time_s - b[i].time_s));
    ++contacts;
    largest = std::max(largest, factor);
    csv += fmt::format("{},{},{:.9f},{:.3e},{:.3e}\n", friction, contacts,
                       static_cast<double>(a[i].time_s), factor, shift_s);
  }
  fmt::print(
      "mu = {}: {} contacts multiply a disturbance by {:.1e} at most; who knows the position worse "
      "than {:.1e} m at the mass loss cannot foretell the run\n",
      friction, contacts, largest, 3e-3 / largest);
  return csv;
}

int main(const Arguments& arguments) {
  if (arguments.size() != 2) throw std::runtime_error("needs: REFERENCE FOLDER");
  const std::filesystem::path reference_file = arguments[0], folder = arguments[1];
  std::string by_precision = "friction,precision,tolerance,error,matched_events,events\n";
  std::string by_contact = "friction,contact,time_s,factor,time_shift_s\n";
  for (const double friction : {0.3, 0.2, 0.08}) {
    const auto exact = reference(reference_file, fmt::format("fig03: mu = {}", friction));
    by_precision += errors<float>("single", friction, exact, 6);
    by_precision += errors<double>("double", friction, exact, 14);
    by_precision += errors<Extended>("extended", friction, exact, 17);
    by_contact += growth(friction, exact.front().state);
  }
  FileTransaction files;
  files.write(folder / "precision.csv", by_precision);
  files.write(folder / "growth.csv", by_contact);
  files.commit();
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("precision", rotor::main, argc, argv); }
