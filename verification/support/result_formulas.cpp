#include "verification/support/result_formulas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"
#include "verification/support/column_formulas.hpp"
#include "verification/support/contact_formulas.hpp"
#include "verification/support/place_of_loss.hpp"

namespace rotor {
namespace {

/// A result, empty if it has not happened, and by how much it may be off besides 1e-12 of itself.
struct Value {
  std::optional<double> is;
  double error = 0;
};

constexpr double rounding = 1e-14;  ///< of a few dozen operations

/// The motion at one instant; m, N, N.
struct Sample {
  Instant at;
  double displacement, bearing_force, normal_force;
};

bool rolls(const Sample& s) { return s.at.contact == ContactState::rolling; }
bool is_clear(const Sample& s) { return s.at.contact == ContactState::free; }
bool before_loss(const Sample& s) { return !s.at.mass_lost; }

/// Keeps the motion of a run: all instants, eight samples of each arc, and what is largest in
/// between, if it exceeds most of what was before.
class Record : public Observer {
 public:
  explicit Record(const Scenario& its_scenario)
      : scenario(its_scenario), p(its_scenario.parameters) {}

  void on_instant(const Instant& at) override {
    if (at.event == Event::mass_loss) largest_ = {};
    add(sample(at));
  }
  bool wants_dense_output(const double&, const double&) const override { return true; }
  void on_step(const DenseOutput& step) override {
    const long last = samples_of_arc * step.arcs;
    const double length = (step.until_s - step.from_s) / static_cast<double>(last);
    const auto after = [&](double n) { return sample(step.at(step.from_s + n * length)); };
    std::vector<Sample> all;
    for (long n = 0; n <= last; ++n) all.push_back(after(static_cast<double>(n)));
    for (const auto of : quantities)
      for (long n = 0; n <= last; ++n) {
        const long left = std::max(n - 1, 0L), right = std::min(n + 1, last);
        const auto value = [&](long i) { return all[static_cast<std::size_t>(i)].*of; };
        if (value(n) < value(left) || value(n) < value(right) || value(n) <= 0.9 * largest_.*of)
          continue;
        const auto from = static_cast<double>(left), range = static_cast<double>(right - left);
        const auto below = [&](double further) { return -(after(from + further).*of); };
        constexpr int half_of_digits = std::numeric_limits<double>::digits / 2;
        const auto [top, least] =
            boost::math::tools::brent_find_minima(below, 0., range, half_of_digits);
        all.push_back(after(from + top));
      }
    std::stable_sort(all.begin(), all.end(),
                     [](const Sample& a, const Sample& b) { return a.at.time_s < b.at.time_s; });
    for (const Sample& s : all) add(s);
  }

  const Sample& last() const { return samples.back(); }
  double clearance() const { return p.stator_radius - p.rotor_radius; }

  double column(std::string_view name, const Sample& of) const {
    return column_by_formula(name, of.at, scenario);
  }
  Value column(std::string_view name, const Sample* of) const {
    return of ? Value{column(name, *of)} : Value{};
  }
  /// O is known as well as the mass centre, from which it has the distance e.
  Value distance(const Sample* of) const {
    return of ? Value{of->displacement, rounding * of->at.body.eccentricity} : Value{};
  }

  template <class Is>
  const Sample* first(const Is& is) const {
    const auto found = std::find_if(samples.begin(), samples.end(), is);
    return found == samples.end() ? nullptr : &*found;
  }

  /// The largest of those that count.
  template <class Counts>
  const Sample* largest(double Sample::*of, const Counts& counts) const {
    const Sample* found = nullptr;
    for (const Sample& s : samples)
      if (counts(s) && (!found || s.*of > found->*of)) found = &s;
    return found;
  }
  template <class Counts>
  const Sample* most_pressed(const Counts& counts) const {
    return largest(&Sample::normal_force,
                   [&](const Sample& s) { return s.at.touches() && counts(s); });
  }

  const Scenario& scenario;
  const Parameters& p;
  std::vector<Sample> samples;

 private:
  static constexpr long samples_of_arc = 8;
  static constexpr std::array quantities = {&Sample::displacement, &Sample::bearing_force,
                                            &Sample::normal_force};

  Sample sample(const Instant& at) const {
    const auto value = [&](const char* name) { return column_by_formula(name, at, scenario); };
    return {at, value("rho_m"), value("bearing_force_N"), -value("normal_force_N")};
  }
  void add(const Sample& s) {
    for (const auto of : quantities) largest_.*of = std::max(largest_.*of, s.*of);
    samples.push_back(s);
  }

  Sample largest_{};  ///< so far, or since the mass loss
};

/// Where the rim comes over the ring, or is first pressed after a start there.
std::vector<const Sample*> touch_downs(const Record& r) {
  std::vector<const Sample*> all;
  bool was_clear = false, is_awaited = true;
  for (const Sample& s : r.samples) {
    if (is_awaited && !is_clear(s) && (was_clear || s.at.touches())) {
      all.push_back(&s);
      is_awaited = false;
    }
    was_clear = is_clear(s);
    is_awaited = is_awaited || was_clear;
  }
  return all;
}
template <class Counts>
Value number_of_touch_downs(const Record& r, const Counts& counts) {
  const std::vector<const Sample*> all = touch_downs(r);
  return {static_cast<double>(
      std::count_if(all.begin(), all.end(), [&](const Sample* s) { return counts(*s); }))};
}

/// The last rolling that lasts: its first and its last sample.
struct Interval {
  const Sample *first = nullptr, *last = nullptr;
};
Interval last_rolling(const Record& r) {
  Interval found, now;
  for (const Sample& s : r.samples) {
    now = !rolls(s) ? Interval{} : Interval{now.first ? now.first : &s, &s};
    if (now.first && s.at.time_s > now.first->at.time_s) found = now;
  }
  return found;
}

/// The direction of O is followed from sample to sample; its rate shows how many turns it makes.
Value whirl_frequency(const Record& r) {
  const auto [first, last] = last_rolling(r);
  if (!first) return {};
  double turned = 0;
  for (const Sample* s = first; s != last; ++s) {
    const auto at = [&](int i, const char* name) { return r.column(name, s[i]); };
    const double turns = (at(0, "whirl_frequency_Hz") + at(1, "whirl_frequency_Hz")) / 2 *
                         (s[1].at.time_s - s[0].at.time_s),
                 angle = at(1, "contact_angle_rad") - at(0, "contact_angle_rad");
    turned += two_pi * turns + std::remainder(angle - two_pi * turns, two_pi);
  }
  const double duration = last->at.time_s - first->at.time_s,
               frequency = turned / two_pi / duration;
  const double angle = std::numbers::pi + std::abs(last->at.state[2]);  // is rounded, as time is
  return {frequency,
          rounding * (angle / two_pi + std::abs(frequency) * last->at.time_s) / duration};
}

/// What is lost in rounding of a velocity that is a difference of larger ones, m/s.
double velocity_rounding(const Sample& s) {
  const State<double>& q = s.at.state;
  return rounding *
         (std::hypot(q[3], q[4]) + std::abs(q[5]) * (s.displacement + s.at.body.eccentricity));
}

/// What the rounding of O's distance and velocity changes in the force, N.
double force_rounding(const Record& r, const Sample& s) {
  const double depth = std::max(s.displacement - r.clearance(), 0.),
               deeper = depth + rounding * s.displacement;
  return spring_force_by_formula(r.p, deeper) - spring_force_by_formula(r.p, depth) +
         r.p.contact_damping * velocity_rounding(s);
}
Value force(const Record& r, const Sample* s) {
  return s ? Value{s->normal_force, force_rounding(r, *s)} : Value{};
}

/// Known as well as rounding allows: it changes the force where it is largest as the distance in
/// time squared does, which is a millionth where the samples end that are counted here.
Value time_of_largest_force(const Record& r) {
  const Sample* s = r.most_pressed([](const Sample&) { return true; });
  if (!s) return {};
  constexpr double less = 1e-6;
  const auto is_near = [&](const Sample* near) {
    return near->normal_force > (1 - less) * s->normal_force;
  };
  const Sample *left = s, *right = s;
  while (left != &r.samples[0] && is_near(left)) --left;
  while (right != &r.last() && is_near(right)) ++right;
  const double share = std::sqrt(force_rounding(r, *s) / s->normal_force / less);
  return {s->at.time_s, (share + 1e-6) * (right->at.time_s - left->at.time_s)};
}

/// Up to where the force falls after it has risen in rolling.
Value largest_force_to_rolling(const Record& r) {
  const Sample* until = r.first(rolls);
  for (bool rises = false; until && until != &r.last(); ++until) {
    const bool goes_on = (until[0].at.touches() && until[1].at.touches()) ||
                         r.scenario.method == Method::rk4;  // which shows no release
    const double change = until[1].normal_force - until[0].normal_force,
                 least = force_rounding(r, until[0]);
    if (rises && change < -least && goes_on) break;
    rises = change > least || (rises && goes_on);
  }
  return force(r, r.most_pressed([&](const Sample& s) { return !until || &s <= until; }));
}

/// Of the ring's centre, along x_a and y_a, m.
std::complex<double> offset(const Parameters& p) { return {p.ring_offset_x, p.ring_offset_y}; }

double critical_speed(const Parameters& p) { return std::sqrt(p.support_stiffness / p.mass); }

/// The position of rest, the steady response to the unbalance about it, m w^2 e / (k - m w^2 + i w
/// d), and the vibration about both, which can only decay, m.
double reach_by_formula(const Record& r) {
  using namespace std::complex_literals;
  const auto& [mass, inertia, e] = r.last().at.body;
  const State<double>& q = r.last().at.state;
  const double w = q[5], k = r.p.support_stiffness, force = mass * w * w * e;
  const std::complex<double> steady =
      force == 0 ? 0 : force / (k - mass * w * w + 1i * w * r.p.support_damping);
  const std::complex<double> rest = -offset(r.p) * std::polar(1., -q[2]),
                             at = std::complex(q[0], q[1]), off = at - rest - steady,
                             drift = std::complex(q[3], q[4]) + 1i * w * (at - steady);
  const double by_drift = drift == 0. ? 0 : std::abs(drift) * std::sqrt(mass / k);
  return std::abs(rest) + std::abs(steady) + std::hypot(std::abs(off), by_drift);
}

/// The speed of ten natural periods ago lies between two samples.
bool is_stalled(const Record& r) {
  const Instant& end = r.last().at;
  const double w = end.state[5], over_s = 10 * two_pi / critical_speed(r.p),
               from_s = end.time_s - over_s;
  if (!end.motor_on || r.p.torque == 0 || !(from_s >= 0)) return false;
  if (std::abs(w) >= 1.5 * std::sqrt(r.p.support_stiffness / end.body.mass)) return false;
  if (end.touches() && r.column("whirl_frequency_Hz", r.last()) * w < 0) return false;
  const Sample* next = r.first([&](const Sample& s) { return s.at.time_s > from_s; });
  const Instant &a = next[-1].at, &b = next[0].at;
  const double early =
      std::lerp(a.state[5], b.state[5], (from_s - a.time_s) / (b.time_s - a.time_s));
  return w - early < 0.1 * r.p.torque / end.body.inertia * over_s;
}

Outcome outcome(const Record& r) {
  if (r.first(rolls)) return Outcome::rolling;
  if (is_stalled(r)) return Outcome::stalled;
  const Instant& end = r.last().at;
  const Sample* since = &r.last();
  while (since != r.samples.data() && since[-1].at.touches()) --since;
  const double depth = r.clearance() / 100,
               stiffness = r.p.contact_exponent * spring_force_by_formula(r.p, depth) / depth,
               period_s = two_pi * std::sqrt(end.body.mass / stiffness);
  if (end.touches() && end.time_s - since->at.time_s > period_s) return Outcome::sliding;
  const bool touched = !touch_downs(r).empty();
  if (is_clear(r.last()) && reach_by_formula(r) < r.clearance())
    return touched ? Outcome::freed : Outcome::no_contact;
  return touched ? Outcome::bouncing : Outcome::undecided;
}

const Sample* last_before_loss(const Record& r) {
  const Sample* after = r.first([](const Sample& s) { return s.at.mass_lost; });
  return after ? after - 1 : nullptr;
}

/// Known as well as the speed is rounded.
Value motor_off(const Record& r) {
  const double off = two_pi * r.p.motor_off_Hz;
  if (r.p.drive == Drive::constant_speed) return {};
  const Sample* s = r.first([&](const Sample& o) { return o.at.state[5] >= (1 - rounding) * off; });
  if (!s || s == r.samples.data()) return r.column("time_s", s);
  const double gained = s[0].at.state[5] - s[-1].at.state[5],
               over_s = s[0].at.time_s - s[-1].at.time_s;
  return {s->at.time_s, gained > 0 ? 2 * rounding * off / gained * over_s : 0};
}

struct ResultFormula {
  std::string_view key;
  Value (*value)(const Record& r);
};

constexpr auto result_formulas = std::to_array<ResultFormula>({
    {"outcome", [](const Record& r) { return Value{static_cast<double>(outcome(r))}; }},
    {"first_contact_s",
     [](const Record& r) {
       const std::vector<const Sample*> all = touch_downs(r);
       return r.column("time_s", all.empty() ? nullptr : all[0]);
     }},
    {"touch_downs_to_rolling",
     [](const Record& r) {
       const Sample* onset = r.first(rolls);
       return number_of_touch_downs(r, [&](const Sample& s) { return !onset || &s <= onset; });
     }},
    {"touch_downs",
     [](const Record& r) { return number_of_touch_downs(r, [](const Sample&) { return true; }); }},
    {"rolling_onset_s", [](const Record& r) { return r.column("time_s", r.first(rolls)); }},
    {"rolling_onset_speed_Hz",
     [](const Record& r) { return r.column("speed_Hz", r.first(rolls)); }},
    {"rolling_onset_force_N", [](const Record& r) { return force(r, r.first(rolls)); }},
    {"rolling_until_s",
     [](const Record& r) {
       const auto end = std::find_if(r.samples.rbegin(), r.samples.rend(), rolls);
       const bool has_ended = end != r.samples.rend() && end != r.samples.rbegin();
       return r.column("time_s", has_ended ? &end[-1] : nullptr);
     }},
    {"peak_force_to_rolling_N", largest_force_to_rolling},
    {"peak_normal_force_N",
     [](const Record& r) { return force(r, r.most_pressed([](const Sample&) { return true; })); }},
    {"peak_time_s", time_of_largest_force},
    {"peak_displacement_m",
     [](const Record& r) {
       return r.distance(r.largest(&Sample::displacement, [&](const Sample& s) {
         return s.at.mass_lost || !r.p.loses_mass;
       }));
     }},
    {"touch_downs_before_loss",
     [](const Record& r) { return number_of_touch_downs(r, before_loss); }},
    {"peak_normal_force_before_loss_N",
     [](const Record& r) { return force(r, r.most_pressed(before_loss)); }},
    {"peak_displacement_before_loss_m",
     [](const Record& r) { return r.distance(r.largest(&Sample::displacement, before_loss)); }},
    {"contact_time_s",
     [](const Record& r) {
       double sum = 0;
       for (const Sample* s = &r.samples[0]; s != &r.last(); ++s)
         if (s->at.touches()) sum += s[1].at.time_s - s[0].at.time_s;
       return Value{sum, rounding * r.last().at.time_s};
     }},
    {"peak_bearing_force_N",
     [](const Record& r) {
       Value force = r.column("bearing_force_N", r.largest(&Sample::bearing_force,
                                                           [](const Sample&) { return true; }));
       // A difference, of places that are turned by an angle which is known to its rounding.
       force.error =
           rounding * std::max(1., std::abs(r.last().at.state[2])) *
           (r.p.support_stiffness + r.p.support_damping * std::abs(r.last().at.state[5])) *
           std::abs(offset(r.p));
       return force;
     }},
    {"whirl_frequency_Hz", whirl_frequency},
    {"whirl_from_s", [](const Record& r) { return r.column("time_s", last_rolling(r).first); }},
    {"whirl_until_s", [](const Record& r) { return r.column("time_s", last_rolling(r).last); }},
    {"motor_off_s", motor_off},
    {"speed_at_mass_loss_Hz",
     [](const Record& r) { return r.column("speed_Hz", last_before_loss(r)); }},
    {"speed_ratio_at_mass_loss",
     [](const Record& r) {
       const Sample* s = last_before_loss(r);
       return s && r.p.support_stiffness > 0 ? Value{s->at.state[5] / critical_speed(r.p)}
                                             : Value{};
     }},
    {"final_time_s", [](const Record& r) { return Value{r.scenario.until}; }},
    {"final_speed_Hz", [](const Record& r) { return r.column("speed_Hz", &r.last()); }},
    {"final_kinetic_energy_J",
     [](const Record& r) {
       const double energy = r.column("kinetic_energy_J", r.last());
       return Value{energy,
                    std::sqrt(2 * energy * r.last().at.body.mass) * velocity_rounding(r.last())};
     }},
    {"final_q1_m", [](const Record& r) { return r.column("q1_m", &r.last()); }},
    {"final_q2_m", [](const Record& r) { return r.column("q2_m", &r.last()); }},
    {"critical_speed_Hz", [](const Record& r) { return Value{critical_speed(r.p) / two_pi}; }},
    {"damping_ratio",
     [](const Record& r) {
       const double critical = 2 * std::sqrt(r.p.support_stiffness * r.p.mass);
       return critical > 0 ? Value{r.p.support_damping / critical} : Value{};
     }},
    {"lost_mass_kg",
     [](const Record& r) { return r.p.loses_mass ? Value{lost_mass_by_formula(r.p)} : Value{}; }},
    {"inertia_after_loss_kg_m2",
     [](const Record& r) {
       if (!r.p.loses_mass || r.p.drive == Drive::constant_speed) return Value{};
       return Value{PlaceOfLoss(r.p, 0).after().inertia};
     }},
    {"mass_loss_reached",
     [](const Record& r) {
       const bool is_reached = r.p.loses_mass && r.p.mass_loss_time <= r.scenario.until;
       return Value{is_reached && lost_mass_by_formula(r.p) > 0 ? 1. : 0.};
     }},
});
static_assert(std::equal(result_formulas.begin(), result_formulas.end(),
                         summary_fields<double>.begin(), summary_fields<double>.end(),
                         [](const auto& a, const auto& b) { return a.key == b.key; }),
              "each result needs its formula, in the order of summary_fields");

template <class Result>
std::optional<double> number(const Result& result) {
  return static_cast<double>(result);
}
std::optional<double> number(const std::optional<double>& result) { return result; }

}  // namespace

std::string wrong_results(const Scenario& scenario) {
  Record record(scenario);
  SummaryObserver observer(scenario);
  ObserverGroup both{&record, &observer};
  run(scenario, both);
  std::string all;
  for (std::size_t i = 0; i < result_formulas.size(); ++i) {
    const auto [key, formula] = result_formulas[i];
    const std::optional<double> reported =
        std::visit([&](auto member) { return number(observer.summary().*member); },
                   summary_fields<double>[i].value);
    const Value expected = formula(record);
    constexpr double absent = std::numeric_limits<double>::quiet_NaN();
    const double x = reported.value_or(absent), y = expected.is.value_or(absent);
    if (reported == expected.is ||
        std::abs(x - y) <= 1e-12 * std::max(std::abs(x), std::abs(y)) + expected.error)
      continue;
    all += fmt::format("{} is {:.15g}, by its formula {:.15g}; ", key, x, y);
  }
  return all;
}

}  // namespace rotor
