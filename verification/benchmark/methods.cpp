#include "verification/benchmark/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <numbers>

#include "model/integration/fehlberg.hpp"
#include "model/methods/event_method.ipp"
#include "model/methods/published_method.hpp"
#include "verification/benchmark/peers/peer.hpp"
#ifdef ROTOR_GSL
#include "verification/benchmark/peers/gsl_solver.hpp"
#endif

namespace rotor {
namespace {

namespace odeint = boost::numeric::odeint;

template <class S>
using Verner = Verner87<std::array<S, 6>, S>;
template <class S>
using Fehlberg = Fehlberg78<std::array<S, 6>, S>;
/// Watches for touch-downs and the peak force.
template <class S>
class Landmarks : public BasicObserver<S> {
 public:
  /// `touches`: whether the rim touches at the start, which is not a touch-down.
  Landmarks(const Parameters& p, bool touches) : ring_(p), touching_(touches) {}

  void on_instant(const BasicInstant<S>& at) override {
    const bool touches = at.contact != ContactState::free;
    if (touches && !touching_) touch_downs.push_back(static_cast<double>(at.time_s));
    touching_ = touches;
    if (touches) note_force(at);
  }
  S threshold(Extreme of, const S& from_s, const S& until_s) const override {
    return of == Extreme::normal_force ? S(peak_force)
                                       : BasicObserver<S>::threshold(of, from_s, until_s);
  }
  void on_maximum(const BasicMaximum<S>& maximum) override { note_force(maximum.at); }

  std::vector<double> touch_downs;
  double peak_force = 0;

 private:
  void note_force(const BasicInstant<S>& at) {
    peak_force = std::max(peak_force,
                          -static_cast<double>(ring_.normal_force(ring_.rim_point(at.motion()))));
  }

  Ring<S> ring_;
  bool touching_;
};

template <class S>
Outcome outcome_of(const State<S>& state, const Landmarks<S>& landmarks, const Counters& counters) {
  Outcome outcome{.touch_downs = landmarks.touch_downs,
                  .peak_force = landmarks.peak_force,
                  .counters = counters};
  std::ranges::transform(state, outcome.state.begin(),
                         [](const S& x) { return static_cast<double>(x); });
  return outcome;
}

/// Runs a method to the end of its problem.
template <class S, class Method>
Outcome finish(const Problem& problem, Method method) {
  Landmarks<S> landmarks(problem.scenario.parameters, problem.touches());
  method.advance(static_cast<S>(problem.scenario.until), landmarks);
  landmarks.on_instant(method.instant());
  return outcome_of(method.instant().state, landmarks, method.counters());
}

template <class S, class Stepper>
Outcome by_stepper(const Problem& problem, const S& tolerance) {
  return finish<S>(problem,
                   EventMethod<S, Stepper>(problem.scenario, tolerance, rounded<S>(problem.start)));
}

[[maybe_unused]] Outcome by_peer(const Problem& problem, PeerCoordinates coordinates,
                                 PeerSolver& solver) {
  Outcome outcome = finish<double>(
      problem, PeerMethod(problem.scenario, coordinates, solver, rounded<double>(problem.start)));
  outcome.peak_force = std::numeric_limits<double>::quiet_NaN();  // it is shown only events
  return outcome;
}

}  // namespace

Outcome by_reference(const Problem& problem) {
  return by_stepper<Extended, Fehlberg<Extended>>(problem, 1e-15L);
}
Outcome by_other_reference(const Problem& problem) {
  return by_stepper<Extended, Verner<Extended>>(problem, 1e-16L);
}
Outcome by_events(const Problem& problem, double tolerance) {
  return by_stepper<double, Verner<double>>(problem, tolerance);
}
Outcome by_events_fehlberg78(const Problem& problem, double tolerance) {
  return by_stepper<double, Fehlberg<double>>(problem, tolerance);
}
Outcome by_fixed_steps(const Problem& problem, double step) {
  Scenario scenario = problem.scenario;
  scenario.method = Method::rk4;
  scenario.step_run_up = scenario.step_rub = step;
  return finish<double>(problem, PublishedMethod(scenario, rounded<double>(problem.start)));
}

Outcome by_odeint_off_the_shelf(const Problem& problem, double tolerance) {
  constexpr long most_steps = 2'000'000;
  Counters counters;
  Landmarks<double> landmarks(problem.scenario.parameters, problem.touches());
  const Parameters& p = problem.scenario.parameters;
  const Supports<double> supports(p, problem.scenario.equations);
  const Ring<double> ring(p);
  Instant at = rounded<double>(problem.start);
  const double motor_off = 2 * std::numbers::pi * p.motor_off_Hz;
  const auto system = [&](const State<double>& q, State<double>& rates, double) {
    ++counters.right_hand_sides;
    const auto motion = RotatingFrame<double>::motion(at.body, q);
    auto loads = supports.loads(at.body, motion, at.motor_on && q[5] < motor_off);
    if (!ring.is_clear_of(motion)) {
      const auto k = ring.rim_point(motion);
      const double normal = ring.normal_force(k);
      loads += ring.loads(k, {normal, ring.sliding_friction(normal, k.slip_velocity > 0 ? 1 : -1)});
    }
    rates = RotatingFrame<double>::rates(motion, q, acceleration(at.body, motion, loads));
  };
  auto stepper = odeint::make_controlled<odeint::runge_kutta_dopri5<State<double>>>(
      tolerance * 1e-3, tolerance);  // absolute, relative: lengths are millimetres
  double step = 1e-6;
  while (at.time_s < problem.scenario.until) {
    step = std::min(step, problem.scenario.until - at.time_s);
    if (stepper.try_step(system, at.state, at.time_s, step) == odeint::fail) continue;
    if (++counters.steps > most_steps) throw std::runtime_error("too many steps");
    const auto motion = at.motion();
    at.contact = ring.is_clear_of(motion) ? ContactState::free : ContactState::sliding;
    landmarks.on_instant(at);
  }
  return outcome_of(at.state, landmarks, counters);
}

std::vector<Peer> peers() {
  std::vector<Peer> all;
#ifdef ROTOR_GSL
  for (const auto& [name, coordinates] :
       {std::pair("GSL rk8pd", PeerCoordinates::of_the_paper),
        {"GSL rk8pd in our coordinates", PeerCoordinates::of_the_phases}})
    all.push_back({name, [in = coordinates](const Problem& problem, double tolerance) {
                     GslSolver solver(tolerance);
                     return by_peer(problem, in, solver);
                   }});
#else
  fmt::print("Without GSL, which make deps-bench installs.\n");
#endif
  return all;
}

}  // namespace rotor
