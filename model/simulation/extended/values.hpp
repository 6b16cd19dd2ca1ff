/// What is asked of a run when its digits are: the values, of what their digits are counted, and
/// what decides the course.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "model/mechanics/mass_loss.hpp"
#include "model/phases/flight.hpp"
#include "model/simulation/extended/computation.hpp"

namespace rotor {

template <class S>
struct NamedValue {
  std::string_view name;
  std::optional<S> value;
  S size{0};              ///< of which its digits are counted at least
  bool is_exact = false;  ///< stated, not computed
  S made_of{0};           ///< of what it is a small difference or component: that is rounded
};

/// All real numbers of a summary, by their names there.
template <class AnySummary, class Action>
void for_each_value(AnySummary& s, const Action& action) {
  action("first_contact_s", s.first_contact_s);
  action("rolling_onset_s", s.rolling_onset_s);
  action("rolling_onset_speed_Hz", s.rolling_onset_speed_Hz);
  action("rolling_onset_force_N", s.rolling_onset_force_N);
  action("rolling_until_s", s.rolling_until_s);
  action("peak_normal_force_N", s.peak_normal_force_N);
  action("peak_time_s", s.peak_time_s);
  action("max_displacement_m", s.max_displacement_m);
  action("peak_normal_force_before_loss_N", s.peak_normal_force_before_loss_N);
  action("max_displacement_before_loss_m", s.max_displacement_before_loss_m);
  action("contact_time_s", s.contact_time_s);
  action("peak_bearing_force_N", s.peak_bearing_force_N);
  action("whirl_frequency_Hz", s.whirl_frequency_Hz);
  action("whirl_from_s", s.whirl_from_s);
  action("whirl_until_s", s.whirl_until_s);
  action("motor_off_s", s.motor_off_s);
  action("speed_at_separation_Hz", s.speed_at_separation_Hz);
  action("final_speed_Hz", s.final_speed_Hz);
  action("final_kinetic_energy_J", s.final_kinetic_energy_J);
  action("final_q1_m", s.final_q1_m);
  action("final_q2_m", s.final_q2_m);
}

/// What is so many times less than the clearance, or than a radian, is as good as nothing: its own
/// digits are not asked for.
constexpr long negligible = 1'000'000;

/// Of a summary.
template <class S>
std::vector<NamedValue<S>> values_of(const BasicSummary<S>& summary, const Parameters& p) {
  const S length = Ring<S>(p).clearance / negligible, force = S(p.support_stiffness) * length;
  std::vector<NamedValue<S>> all;
  for_each_value(summary, [&](std::string_view name, const std::optional<S>& value) {
    const bool is_vibration = name == "peak_bearing_force_N";
    all.push_back({name, value, is_vibration ? force : name.ends_with("_m") ? length : S(0)});
  });
  return all;
}

/// The same, and what follows from them and from the parameters.
template <class S>
std::vector<NamedValue<S>> values_of(const Computation<S>& run, const Scenario& scenario) {
  using std::abs, std::sqrt;
  const Parameters& p = scenario.parameters;
  std::vector<NamedValue<S>> all = values_of(run.summary, p);
  const S critical_Hz = in_Hz(S(sqrt(S(p.support_stiffness) / S(p.mass))));
  const BasicSummary<S>& summary = run.summary;
  const auto made_of = [&](std::string_view name) -> S& {
    return std::find_if(all.begin(), all.end(), [&](const auto& v) { return v.name == name; })
        ->made_of;
  };
  made_of("final_q1_m") = made_of("final_q2_m") = run.end.motion().displacement.norm();
  if (summary.contact_time_s > 0) made_of("contact_time_s") = run.end.time_s;
  if (summary.whirl_frequency_Hz) {
    const S until = *summary.whirl_until_s;
    made_of("whirl_frequency_Hz") =
        abs(*summary.whirl_frequency_Hz) * until / (until - *summary.whirl_from_s);
  }
  const auto& at_loss_Hz = summary.speed_at_separation_Hz;
  all.push_back({"speed_ratio_at_separation",
                 at_loss_Hz ? std::optional(S(*at_loss_Hz / critical_Hz)) : std::nullopt});
  all.push_back({"final_time_s", run.end.time_s, S(0), true});
  all.push_back({"critical_speed_Hz", critical_Hz});
  if (p.separates) {
    const MassLoss<S> loss(p);
    all.push_back({"lost_mass_kg", loss.lost_mass});
    all.push_back({"inertia_after_loss_kg_m2", loss.after.inertia});
  }
  return all;
}

/// Time and state. What the components of a vector are worth is told by its length; for the rates
/// in the rotating axes, which nearly cancel in synchronous motion, by that of the velocity of O.
template <class S>
std::vector<NamedValue<S>> values_of(const BasicInstant<S>& at, const S& clearance) {
  using std::abs, std::max;
  const State<S>& q = at.state;
  const Motion<S> m = at.motion();
  const S least = clearance / negligible, angle = S(1) / negligible;
  const S length = max(least, S(m.displacement.norm()));
  const S velocity = max(S(least * abs(m.speed)), S(m.velocity.norm()));
  const bool is_stated = at.event == Event::mass_loss || at.event == Event::none;  // or the end
  return {{"time_s", at.time_s, S(0), is_stated},
          {"q1_m", q[0], length},
          {"q2_m", q[1], length},
          {"q3_rad", q[2], angle},
          {"q1_rate_m_per_s", q[3], velocity},
          {"q2_rate_m_per_s", q[4], velocity},
          {"q3_rate_rad_per_s", q[5]}};
}

/// How far the guards of a phase are from zero at a stated time: after that time an event that has
/// not come would come too late, and one that has, at that time, might not.
template <class S, class Phase>
void add_guards(std::vector<NamedValue<S>>& all, const Phase& phase,
                const typename Phase::Unknowns& x) {
  using std::abs;
  for (std::size_t n = 0; n < Phase::event_count; ++n)
    all.push_back({"reserve", abs(phase.guard(n, x))});
}

/// Those of the phase that a rotor is in.
template <class S>
void add_reserves(std::vector<NamedValue<S>>& all, const BasicInstant<S>& at,
                  const Scenario& scenario) {
  RotorSystem<S> rotor(scenario.parameters, scenario.equations);
  rotor.body = at.body;
  rotor.motor_on = at.motor_on;
  if (at.contact == ContactState::free) {
    const FlightChart<S> chart(rotor, at.state);
    return add_guards(all, FreeFlight<S>(rotor, chart), chart.unknowns(at.state));
  }
  const ContactChart<S> chart(rotor, at.state);
  const auto x = chart.unknowns(at.state);
  switch (at.contact) {
    case ContactState::indented:
      return add_guards(all, IndentedFlight<S>(rotor, chart), x);
    case ContactState::rolling:
      return add_guards(all, Rolling<S>(rotor, chart), x);
    default:  // in whichever sense: the slip is as far from zero
      return add_guards(all, Sliding<S>(rotor, chart, 1), x);
  }
}

/// What is positive as long as the course is what it is: the normal velocities of touch-downs, by
/// how much flights miss the ring, how far the next event is just before the mass loss, just after
/// it and in the end, and how far from the clearance that is what a rotor reaches that is free in
/// the end.
template <class S>
std::vector<NamedValue<S>> margins_of(const Computation<S>& run, const Scenario& scenario) {
  using std::abs;
  const Ring<S> ring(scenario.parameters);
  std::vector<NamedValue<S>> all;
  for (std::size_t i = 0; i <= run.events.size(); ++i) {
    const auto miss = run.misses.find(i);
    all.push_back({"miss", miss == run.misses.end() ? std::nullopt : std::optional(miss->second)});
    if (i < run.events.size() && run.events[i].event == Event::touch_down)
      all.push_back({"touch", ring.rim_point(run.events[i].motion()).normal_velocity});
    if (i < run.events.size() && run.events[i].event == Event::mass_loss)
      for (const BasicInstant<S>* at : {&run.before_loss, &run.events[i]})
        add_reserves(all, *at, scenario);
  }
  const BasicInstant<S>& end = run.end;
  add_reserves(all, end, scenario);
  if (end.contact == ContactState::free && end.body.eccentricity > 0) {
    const Supports<S> supports(scenario.parameters, scenario.equations);
    all.push_back({"reach", abs(ring.clearance - reach(end.body, supports, end.motion()))});
  }
  return all;
}

template <class S>
Instant in_double(const BasicInstant<S>& at) {
  const auto d = [](const S& x) { return static_cast<double>(x); };
  Instant result{.time_s = d(at.time_s),
                 .body = {d(at.body.mass), d(at.body.inertia), d(at.body.eccentricity)},
                 .motor_on = at.motor_on,
                 .separated = at.separated,
                 .contact = at.contact,
                 .direction = at.direction,
                 .event = at.event};
  std::transform(at.state.begin(), at.state.end(), result.state.begin(), d);
  return result;
}

template <class S>
Summary in_double(const BasicSummary<S>& summary) {
  Summary result;
  result.outcome = summary.outcome;
  result.collisions = summary.collisions;
  result.collisions_before_loss = summary.collisions_before_loss;
  std::vector<std::optional<double>> values;
  for_each_value(summary, [&](std::string_view /*name*/, const std::optional<S>& value) {
    values.push_back(value ? std::optional(static_cast<double>(*value)) : std::nullopt);
  });
  auto next = values.begin();
  for_each_value(result, [&](std::string_view /*name*/, auto& value) {
    if (*next) value = **next;
    ++next;
  });
  return result;
}

}  // namespace rotor
