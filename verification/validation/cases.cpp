#include "verification/validation/cases.hpp"

#include <fmt/format.h>

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <cmath>
#include <random>
#include <utility>

#include "figures/runs/scene.hpp"
#include "model/results/summary.hpp"
#include "verification/support/bare.hpp"

namespace rotor {
namespace {

/// Ends a little after the onset of rolling, at the sixth touch-down, or after half a period of
/// the paper's supports.
ComparedAccident accident(const std::string& name, Scenario scenario) {
  scenario.until = scenario.parameters.mass_loss_time;
  const EventRecorder recorder = recorded(scenario);
  Instant from = recorder.first(Event::mass_loss);
  from.motor_on = false;
  ComparedAccident all{name, scenario, from, scenario, from};
  const Course course = by_engine(all);
  const auto& touches = course.touch_downs_s;
  all.until_s = course.onset_s ? 1.05 * *course.onset_s : touches.size() > 5 ? touches[5] : 0.05;
  return all;
}

/// The first draw of seed 58 that touches the ring, everything beyond the paper's ranges.
ComparedAccident random_rotor() {
  std::mt19937_64 random(58);
  const auto between = [&](double least, double greatest) {
    return std::uniform_real_distribution<double>(least, greatest)(random);
  };
  for (;;) {
    Scenario scenario{.equations = Equations::corrected};
    Parameters& p = scenario.parameters;
    for (double* value : {&p.mass, &p.support_stiffness, &p.support_damping, &p.contact_stiffness,
                          &p.contact_damping, &p.eccentricity, &p.rotor_radius}) {
      const double factor = between(2, 3);
      *value *= between(0, 1) < 0.5 ? factor : 1 / factor;
    }
    p.inertia = between(0.42, 0.65) * p.mass * p.rotor_radius * p.rotor_radius;
    p.stator_radius = p.rotor_radius + 3e-3 * between(0.3, 0.5);
    p.friction = between(0.35, 0.5);
    p.unbalance_factor = between(4, 6);
    p.motor_off_Hz = scenario.start_speed_Hz = between(200, 300);
    p.mass_loss_time = 1e-3;
    ComparedAccident drawn = accident("drawn at random", scenario);
    drawn.force_allowed = 1e-2;  // its ring is indented by twice the share of r
    if (!by_engine(drawn).touch_downs_s.empty()) return drawn;
  }
}

}  // namespace

std::vector<ComparedAccident> accidents() {
  using Loss = std::pair<double, double>;  // time and friction
  std::vector<ComparedAccident> all;
  for (const VelocityJump jump : {VelocityJump::once, VelocityJump::twice})
    for (const auto& [loss_s, mu] :
         {Loss{29.1, 0.3}, {29.1, 0.2}, {29.1, 0.08}, {19.1, 0.3}, {14.15, 0.3}}) {
      Scenario scenario{.equations = {jump, GravityMoment::balanced}};
      scenario.parameters.mass_loss_time = loss_s;
      scenario.parameters.friction = mu;
      const char* name = jump == VelocityJump::once ? "once" : "twice";
      all.push_back(
          accident(fmt::format("loss at {} s with mu {} and jump {}", loss_s, mu, name), scenario));
    }
  all.push_back(random_rotor());
  Scenario hertz{.equations = Equations::corrected};
  hertz.parameters.contact_exponent = 1.5;
  hertz.parameters.reference_indentation = 1e-4;
  hertz.parameters.contact_damping = 0;  // the other code's grows with the root of the indentation
  all.push_back(accident("Hertz's contact without dashpot", hertz));

  const ComparedAccident once = all[0], twice = all[5];
  const auto mistake = [&](const char* name, ComparedAccident of) -> ComparedAccident& {
    of.name = name;
    of.mistaken = true;
    return all.emplace_back(of);
  };
  mistake("friction 5 % too large", once).given.parameters.friction *= 1.05;
  mistake("friction 5 % too small", once).given.parameters.friction *= 0.95;
  mistake("friction of the wrong sign", once).given.parameters.friction *= -1;
  mistake("inertia 5 % too large", once).given_from.body.inertia *= 1.05;
  mistake("no dashpot", once).given.parameters.contact_damping = 0;
  mistake("jump counted once instead of twice", twice).given_from = once.from;
  return all;
}

std::vector<ComparedAccident> problems() {
  std::vector<ComparedAccident> all;
  for (const char* name : {"accident", "low-friction", "hertz", "sliding-to-rolling", "limit-cycle",
                           "partial-rub", "chaos"}) {
    Scenario scenario =
        read_scene(fmt::format(ROTOR_REFERENCE_DATA "/problems/{}.toml", name)).runs.at(0).scenario;
    const double until_s = std::exchange(scenario.until, 0);
    Instant from = start_of(scenario);
    if (scenario.loses_mass()) from = recorded(scenario).first(Event::mass_loss);
    // A constant speed asks for no inertia, and any will do.
    const Parameters& p = scenario.parameters;
    if (p.drive == Drive::constant_speed)
      from.body.inertia = from.body.mass * p.rotor_radius * p.rotor_radius / 2;
    all.push_back({name, scenario, from, scenario, from, until_s});
  }
  return all;
}

double indentation(const Parameters& p, double force_N) {
  if (p.contact_exponent == 1) return force_N / p.contact_stiffness;
  const double share = force_N / p.contact_stiffness / p.reference_indentation;
  return p.reference_indentation * std::pow(share, 1 / p.contact_exponent);
}

double find(const std::vector<Finding>& all, const std::string& quantity) {
  for (const Finding& finding : all)
    if (finding.quantity == quantity) return finding.value;
  return std::nan("");
}

double Finding::difference(double other) const {
  return quantity.starts_with("touch_down") ? other - value : other / value - 1;
}

void Course::add(const Sample& now, double friction_coefficient) {
  if (last.gap > 0 && now.gap <= 0)
    touch_downs_s.push_back(last.time_s +
                            (now.time_s - last.time_s) * last.gap / (last.gap - now.gap));
  if (now.normal_force_N > peak_N) {
    peak_N = now.normal_force_N;
    peak_s = now.time_s;
  }
  const bool ends = last.normal_force_N > 0 && now.gap > 0;
  if (now.normal_force_N > 0 || ends) {
    const double inside = (now.gap > 0) == (last.gap > 0)
                              ? 1
                              : std::min(last.gap, now.gap) / -std::abs(last.gap - now.gap);
    contact_s += inside * (now.time_s - last.time_s);
  }
  least_gap = std::min(least_gap, now.gap);
  const double limit = std::abs(friction_coefficient) * now.normal_force_N;
  if (!onset_s && std::abs(now.friction_N) < 0.5 * limit) {
    onset_s = now.time_s;
    onset_Hz = now.speed_Hz;
    onset_N = now.normal_force_N;
  }
  last = now;
}

std::map<std::string, double> Course::values(const Parameters& p) const {
  const double clearance = p.stator_radius - p.rotor_radius;
  std::map<std::string, double> all = {{"touch_downs", static_cast<double>(touch_downs_s.size())},
                                       {"peak_normal_force_N", peak_N},
                                       {"peak_time_s", peak_s},
                                       {"peak_displacement_m", clearance - least_gap},
                                       {"contact_time_s", contact_s},
                                       {"final_speed_Hz", last.speed_Hz},
                                       {"final_q1_m", last.q1_m},
                                       {"final_q2_m", last.q2_m},
                                       {"final_displacement_m", clearance - last.gap}};
  for (std::size_t n = 0; n < touch_downs_s.size(); ++n)
    all[fmt::format("touch_down_{}_s", n + 1)] = touch_downs_s[n];
  if (onset_s)
    all.insert({{"rolling_onset_s", *onset_s},
                {"rolling_onset_speed_Hz", *onset_Hz},
                {"rolling_onset_force_N", *onset_N}});
  return all;
}

std::vector<Finding> Course::findings(const ComparedAccident& of) const {
  const Parameters& p = of.scenario.parameters;
  std::vector<Finding> all;
  // Contacts multiply the error of the steps; at low friction they are more, and slower.
  const bool bounces = p.friction < 0.1;
  for (std::size_t i = 0; i < std::min<std::size_t>(touch_downs_s.size(), bounces ? 5 : 99); ++i)
    all.push_back({fmt::format("touch_down_{}_s", i + 1), touch_downs_s[i], bounces ? 1e-5 : 1e-6});
  if (bounces) return all;
  all.push_back({"touch_downs", static_cast<double>(touch_downs_s.size()), 0});
  // The speed in rolling, w_0/(1 + m a^2/I), has less than twice the relative change of the lever
  // a, Delta/(2 r); without contact only the steps matter.
  const double change = touch_downs_s.empty() ? 1e-8 : indentation(p, peak_N) / p.rotor_radius;
  if (onset_s) {
    all.push_back({"peak_normal_force_N", peak_N, of.force_allowed, 2e-4});
    all.push_back({"rolling_onset_speed_Hz", *onset_Hz, change, 1e-3});
  }
  all.push_back({"final_speed_Hz", last.speed_Hz, change, onset_s ? 2e-4 : 0});
  return all;
}

Course by_engine(const ComparedAccident& accident) {
  const Instant& from = accident.from;
  EventRecorder events;
  SummaryObserver observer(accident.scenario);
  ObserverGroup both{&events, &observer};
  follow(accident.scenario, from, from.time_s + accident.until_s, both);
  const Summary& summary = observer.summary();
  Course course;
  for (const Instant& at : events.events(Event::touch_down))
    course.touch_downs_s.push_back(at.time_s - from.time_s);
  course.peak_N = summary.peak_normal_force_N.value_or(0);
  course.last.speed_Hz = summary.final_speed_Hz;
  course.onset_Hz = summary.rolling_onset_speed_Hz;
  if (summary.rolling_onset_s) course.onset_s = *summary.rolling_onset_s - from.time_s;
  return course;
}

double coarse_step_s(const Parameters& p) { return 5e-4 * std::sqrt(p.mass / p.contact_stiffness); }

double viscosity(const Parameters& p, double step_s) { return 0.008 * p.mass / step_s; }
double deepest_for_viscosity(const Parameters& p) { return (p.stator_radius - p.rotor_radius) / 5; }

Course with_lever(const ComparedAccident& accident) {
  const Parameters& p = accident.scenario.parameters;
  const Body<double>& body = accident.from.body;
  const ActingLoads<double> acting(p, accident.scenario.equations);
  const double step_s = 2 * coarse_step_s(p), braking = viscosity(p, step_s / 2 / finer),
               deepest = deepest_for_viscosity(p);
  Course::Sample sample{};
  const auto rates = [&](const State<double>& q, State<double>& rate, double time_s) {
    const Motion<double> motion = RotatingFrame<double>::motion(body, q);
    Ring<double> ring(p);
    ring.rotor_radius -= std::max(0.0, ring.rim_point(motion).indentation) / 2;
    const RimPoint<double> k = ring.rim_point(motion);
    const double normal = ring.normal_force(k), limit = -ring.friction * normal,
                 of_root = std::sqrt(std::max(0.0, k.indentation) / deepest),
                 share = p.contact_exponent == 1 ? 1 : of_root,
                 friction = std::clamp(-braking * share * k.slip_velocity, -limit, limit);
    Loads<double> loads = acting.loads(body, motion, false);
    loads += ring.loads(k, {normal, friction});
    rate = RotatingFrame<double>::rates(motion, q, acceleration<double>(body, motion, loads));
    sample = {time_s, -k.indentation, -normal, friction, in_Hz(q[5])};
  };
  Course course;
  boost::numeric::odeint::runge_kutta4<State<double>> stepper;
  State<double> q = accident.from.state, rate;
  for (double time_s = 0; time_s < accident.until_s; time_s += step_s) {
    rates(q, rate, time_s);
    course.add(sample, p.friction);
    stepper.do_step(rates, q, rate, time_s, step_s);
  }
  return course;
}

Rebound rebound(double angle_deg) {
  constexpr double restitution = 0.98, velocity = 3.9, density = 4000, gap = 1e-6;
  double zeta = 0;  // exp(-2 zeta arccos(zeta) / sqrt(1 - zeta^2)) = restitution
  for (int i = 0; i < 20; ++i)
    zeta = -std::log(restitution) * std::sqrt(1 - zeta * zeta) / (2 * std::acos(zeta));
  Scenario scenario = bare();
  Parameters& p = scenario.parameters;
  p.rotor_radius = 2.5e-3;
  p.stator_radius = 10 + p.rotor_radius;  // nearly plane
  p.mass = density * 2 * two_pi / 3 * std::pow(p.rotor_radius, 3);
  p.inertia = 0.4 * p.mass * p.rotor_radius * p.rotor_radius;
  p.friction = 0.092;
  p.contact_stiffness = 1e8;  // the normal turns by 2e-6 during the impact
  p.contact_damping = 2 * zeta * std::sqrt(p.contact_stiffness * p.mass);
  const double angle = angle_deg * two_pi / 360, normal = velocity * std::cos(angle),
               tangential = velocity * std::sin(angle);
  const EventRecorder run =
      follow_from_state(scenario, {10 - gap, 0, 0, normal, tangential, 0}, gap / normal + 1e-4);
  const Motion<double> after = run.first(Event::release).motion();
  const RimPoint<double> k = Ring<double>(p).rim_point(after);
  return {k.tangent.dot(after.velocity) / tangential, run.count(Event::rolling_onset) == 0};
}

}  // namespace rotor
