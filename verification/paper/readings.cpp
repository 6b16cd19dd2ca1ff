#include "verification/paper/readings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "model/mechanics/mass_loss.hpp"
#include "verification/paper/contact_laws.hpp"
#include "verification/support/refined.hpp"

namespace rotor {
namespace {

using Value = std::optional<double>;
using Formula = std::function<Value(PaperRuns&)>;

double energy(const Instant& at) { return kinetic_energy(at.body, at.motion()); }
double rho(const Instant& at) { return at.motion().displacement.norm(); }
double speed_Hz(const Instant& at) { return in_Hz(at.state[5]); }

MassLoss<double> loss(PaperRuns& r) { return MassLoss<double>(r.parameters()); }

/// Eq. (26), Hz.
double rolling_Hz(PaperRuns& r, const Instant& at) {
  return speed_Hz(at) * r.parameters().rotor_radius / rho(at);
}
/// v_O in rolling, m/s.
double rolling_velocity(PaperRuns& r, const Instant& at) {
  return two_pi * rolling_Hz(r, at) * rho(at);
}
/// Eq. (27), J and N.
double translation(PaperRuns& r, const Instant& at) {
  return loss(r).after.mass * std::pow(rolling_velocity(r, at), 2) / 2;
}
double inertia_force(PaperRuns& r, const Instant& at) {
  return loss(r).after.mass * std::pow(two_pi * rolling_Hz(r, at), 2) * rho(at);
}
double force(PaperRuns& r, const Instant& at) {
  const Ring<double> ring(r.parameters());
  return -ring.normal_force(ring.rim_point(at.motion()));
}

double indentation(PaperRuns& r, const Instant& at) {
  return Ring<double>(r.parameters()).rim_point(at.motion()).indentation;
}

double energy_before(PaperRuns& r) { return energy(r.high().before_loss()); }
double since_first_contact(PaperRuns& r, const Instant& at) {
  return at.time_s - r.high().summary().first_contact_s.value_or(at.time_s);
}

/// %; nothing if one of the results is missing.
Value difference(const Value& one, const Value& other) {
  return one && other ? Value(100 * std::abs(*one / *other - 1)) : std::nullopt;
}

/// Largest change of a result when a contact parameter is doubled and halved, %.
Formula change(double PaperInputs::*friction, const char* quantity,
               const std::function<Value(const PaperRun&)>& result) {
  return [=](PaperRuns& r) -> Value {
    const double mu = r.inputs().*friction;
    const Value as_it_is = result(r.changed(mu, quantity, 1));
    double largest = 0;
    for (const double factor : {0.5, 2.}) {
      const Value off = difference(result(r.changed(mu, quantity, factor)), as_it_is);
      if (!off) return std::nullopt;
      largest = std::max(largest, *off);
    }
    return largest;
  };
}
Value peak(const PaperRun& run) { return run.summary().peak_normal_force_N; }
Value peak_kN(const PaperRun& run) { return peak(run) ? Value(*peak(run) / 1e3) : std::nullopt; }
Value time_to_rolling(const PaperRun& run) {
  if (!run.onset()) return std::nullopt;
  return run.onset()->time_s - *run.summary().first_contact_s;
}

/// Change of a result in a ring of Hertz's exponent, %.
Formula change_by_law(double PaperInputs::*friction, SameIndentation same,
                      const std::function<Value(const PaperRun&)>& result) {
  return [=](PaperRuns& r) -> Value {
    const double mu = r.inputs().*friction;
    const auto numbers = numbers_of(1.5, same, r);
    if (!numbers) return std::nullopt;
    return difference(result(r.with(mu, *numbers)), result(r.with(mu, {})));
  };
}
Value rolls(const PaperRun& run) { return run.onset() ? 1. : 0.; }

/// What rotor and piece together gain in the mass loss.
struct Gain {
  double energy;            ///< J
  Vector<double> momentum;  ///< N s
  double angular_momentum;  ///< about where C is, N m s
};
Gain gain_by_mass_loss(PaperRuns& r) {
  const PaperRun& run = r.high();
  const MassLoss<double> split = loss(r);
  const auto before = run.before_loss().motion(), after = run.after_loss().motion();
  const Vector<double> from_O(-r.parameters().rotor_radius, 0), c = before.mass_centre();
  const Vector<double> piece = before.velocity + before.speed * quarter_turn(from_O);
  const Vector<double> momentum = split.after.mass * after.mass_centre_velocity();
  const Vector<double> arm = after.mass_centre() - c;
  const Vector<double> arm_of_piece = before.displacement + from_O - c;
  return {energy(run.after_loss()) + split.lost_mass * piece.squaredNorm() / 2 -
              energy(run.before_loss()),
          momentum + split.lost_mass * piece - split.before.mass * before.mass_centre_velocity(),
          split.after.inertia * after.speed + cross(arm, momentum) +
              split.lost_mass * cross(arm_of_piece, piece) - split.before.inertia * before.speed};
}

/// What friction dissipates until continuous contact begins, J.
Value friction_until(PaperRuns& r, const Instant&, std::size_t from_last) {
  const auto& work = r.friction_work();
  if (!work || work->until_touch_downs.size() <= from_last) return std::nullopt;
  return *(work->until_touch_downs.rbegin() + static_cast<long>(from_last));
}

/// Largest value of a result over all places on the rim from which the piece can leave.
Formula elsewhere(const std::function<double(const Summary& opposite, const Summary&)>& result) {
  return [=](PaperRuns& r) -> Value {
    return refined(
        [&](long places) {
          double largest = 0;
          for (long n = 0; n < places; ++n)
            largest =
                std::max(largest, result(r.lost_at(0), r.lost_at(two_pi * static_cast<double>(n) /
                                                                 static_cast<double>(places))));
          return largest;
        },
        360, 0.01);
  };
}

/// By the paper's method and steps, relative to the converged value, %.
Formula off_by_own_method(const std::function<Value(const PaperRun&)>& result) {
  return [=](PaperRuns& r) {
    return difference(result(r.high_by(Method::rk4)), result(r.high_by(Method::event)));
  };
}

/// Adds readings of related names.
class Table {
 public:
  std::map<std::string, Formula> all;

  void add(const std::string& name, Formula formula) { all[name] = std::move(formula); }
  /// Of an instant of the run at high friction.
  template <class F>
  void before_loss(const std::string& name, F f) {
    add(name, [f](PaperRuns& r) -> Value { return f(r, r.high().before_loss()); });
  }
  template <class F>
  void onset(const std::string& name, F f) {
    add(name, [f](PaperRuns& r) { return of_instant(r, r.high().onset(), f); });
  }
  template <class F>
  void peak(const std::string& name, F f) {
    add(name, [f](PaperRuns& r) { return of_instant(r, r.high().at_peak(), f); });
  }
  /// onset_name and peak_name.
  template <class F>
  void onset_and_peak(const std::string& name, F f) {
    onset("onset_" + name, f);
    peak("peak_" + name, f);
  }
  /// name_last and name_last_but_one: of the touch-down with which continuous contact begins, and
  /// how many come after it.
  template <class F>
  void touch_downs(const std::string& name, F f) {
    for (const std::size_t from_last : {0U, 1U})
      add(name + (from_last == 0 ? "_last" : "_last_but_one"), [f, from_last](PaperRuns& r) {
        return of_instant(
            r, r.high().touch_down_before_rolling(from_last),
            [&](PaperRuns&, const Instant& at) -> Value { return f(r, at, from_last); });
      });
  }
  /// name_5_ms and name_turn, of early rolling.
  void rolling(const std::string& name, double PaperRun::Rolling::*of, double factor = 1) {
    for (const bool first_turn : {false, true})
      add(name + (first_turn ? "_turn" : "_5_ms"), [=](PaperRuns& r) -> Value {
        const auto measured = first_turn ? r.high().first_turn() : r.high().first_5_ms();
        return measured ? Value(factor * ((*measured).*of)) : std::nullopt;
      });
  }

 private:
  template <class F>
  static Value of_instant(PaperRuns& r, const std::optional<Instant>& at, F f) {
    return at ? Value(f(r, *at)) : std::nullopt;
  }
};

std::array<const PaperRun*, 3> at_all_frictions(PaperRuns& r) {
  return {&r.high(), &r.intermediate(), &r.low()};
}

void add_run_up_and_loss(Table& table) {
  using Runs = PaperRuns&;
  using At = const Instant&;
  table.add("resonance_s", [](Runs r) { return r.time_at_critical_speed(); });
  table.add("motor_off_s", [](Runs r) { return r.high().summary().motor_off_s; });
  table.add("motor_is_off", [](Runs r) -> Value {
    const auto off_s = r.high().summary().motor_off_s;
    return off_s && *off_s < r.inputs().t_operating ? 1. : 0.;
  });
  table.before_loss("speed_at_loss", [](Runs, At at) { return speed_Hz(at); });
  table.before_loss("relative_velocity", [](Runs r, At at) {
    return 100 * std::hypot(at.state[3], at.state[4]) / (at.state[5] * r.parameters().eccentricity);
  });
  table.before_loss("c_distance",
                    [](Runs, At at) { return 1e6 * at.motion().mass_centre().norm(); });
  table.before_loss("c_share", [](Runs r, At at) {
    return 100 * at.motion().mass_centre().norm() / r.parameters().eccentricity;
  });
  table.before_loss("energy_before", [](Runs, At at) { return energy(at); });
  table.add("energy_gain",
            [](Runs r) -> Value { return 100 * gain_by_mass_loss(r).energy / energy_before(r); });
  table.before_loss("momentum_gain", [](Runs r, At at) {
    return 100 * gain_by_mass_loss(r).momentum.norm() /
           (loss(r).lost_mass * loss(r).piece_velocity(at.state[5]));
  });
  table.before_loss("angular_momentum_gain", [](Runs r, At at) {
    return 100 * gain_by_mass_loss(r).angular_momentum / (at.body.inertia * at.state[5]);
  });
  table.before_loss("speed_gain", [](Runs r, At at) {
    return 100 * (r.high().after_loss().state[5] / at.state[5] - 1);
  });
  table.add("loss_of_energy", [](Runs r) -> Value {
    return 100 * (1 - energy(r.high().after_loss()) / energy_before(r));
  });
  table.add("elsewhere_peak", elsewhere([](const Summary& opposite, const Summary& s) {
              const double ratio =
                  s.peak_normal_force_N.value_or(0) / opposite.peak_normal_force_N.value();
              return 100 * std::abs(ratio - 1);
            }));
  const Formula does_not_roll =
      elsewhere([](const Summary&, const Summary& s) { return s.rolling_onset_s ? 0. : 1.; });
  const Formula longer = elsewhere([](const Summary& opposite, const Summary& s) {
    const auto to_rolling = [](const Summary& of) {
      return *of.rolling_onset_s - *of.first_contact_s;
    };
    return 100 * std::abs(to_rolling(s) / to_rolling(opposite) - 1);
  });
  table.add("elsewhere_time",  // without limit beside places from which the rotor does not roll
            [=](Runs r) { return *does_not_roll(r) > 0 ? Value() : longer(r); });
  table.add("elsewhere_rolls", [does_not_roll](Runs r) -> Value { return 1 - *does_not_roll(r); });
}

void add_rolling(Table& table) {
  using Runs = PaperRuns&;
  using At = const Instant&;
  table.add("rolls", [](Runs r) -> Value { return r.high().onset() ? 1. : 0.; });
  table.onset("to_rolling", since_first_contact);
  table.peak("to_peak", since_first_contact);
  table.onset("hundredths_to_rolling",
              [](Runs r, At at) { return 100 * since_first_contact(r, at); });
  table.onset_and_peak("Hz", [](Runs, At at) { return speed_Hz(at); });
  table.onset("drop_at_onset",
              [](Runs r, At at) { return speed_Hz(r.high().before_loss()) / speed_Hz(at); });
  table.onset("onset_kN", [](Runs r, At at) { return force(r, at) / 1e3; });
  table.add("peak_kN", [](Runs r) { return peak_kN(r.high()); });
  table.onset("onset_to_peak",
              [](Runs r, At at) { return 100 * (1 - force(r, at) / *peak(r.high())); });
  table.peak("onset_to_peak_time", [](Runs r, At at) {
    return 100 * (1 - since_first_contact(r, *r.high().onset()) / since_first_contact(r, at));
  });
  table.onset_and_peak("mm", [](Runs, At at) { return 1e3 * rho(at); });
  table.onset_and_peak("rolling_Hz", rolling_Hz);
  table.onset_and_peak("velocity", rolling_velocity);
  table.onset_and_peak("translation", translation);
  table.onset_and_peak("inertia_kN", [](Runs r, At at) { return inertia_force(r, at) / 1e3; });
  table.onset_and_peak("inertia_off", [](Runs r, At at) {
    return 100 * std::abs(inertia_force(r, at) / force(r, at) - 1);
  });
  table.onset_and_peak("energy", [](Runs, At at) { return energy(at); });
  table.onset_and_peak("share_left",
                       [](Runs r, At at) { return 100 * energy(at) / energy_before(r); });
  table.onset_and_peak("share_lost",
                       [](Runs r, At at) { return 100 - 100 * energy(at) / energy_before(r); });
  table.add("friction_share", [](Runs r) -> Value {
    const auto& work = r.friction_work();
    return work ? Value(100 * work->until_rolling / energy_before(r)) : std::nullopt;
  });
  // Of C_1 relative to that of O.
  table.onset("velocity_off", [](Runs, At at) {
    return *difference(at.motion().mass_centre_velocity().norm(), at.motion().velocity.norm());
  });
  table.onset("force_rises", [](Runs r, At at) {
    const Instant from = *r.high().touch_down_before_rolling(0);
    return speed_Hz(at) < speed_Hz(from) && force(r, at) > r.high().peak_until(from.time_s) ? 1.
                                                                                            : 0.;
  });
  table.onset("translation_share",
              [](Runs r, At at) { return 100 * translation(r, at) / energy(at); });
  table.onset("bearing_share", [](Runs r, At at) {
    const Parameters p = r.parameters();
    const double load =
        std::hypot(p.support_stiffness * rho(at), p.support_damping * at.motion().velocity.norm());
    return 100 * load / *peak(r.high());
  });
  table.onset("elastic_N",
              [](Runs r, At at) { return rho(at) * r.parameters().support_stiffness / 2; });
  table.onset("damping_N", [](Runs r, At at) {
    return rolling_velocity(r, at) * r.parameters().support_damping / 2;
  });
  table.peak("indentation_of_radius",
             [](Runs r, At at) { return 100 * indentation(r, at) / r.parameters().rotor_radius; });
  table.peak("indentation_of_clearance", [](Runs r, At at) {
    return 100 * indentation(r, at) / (rho(at) - indentation(r, at));
  });
  table.rolling("whirl", &PaperRun::Rolling::whirl_Hz);
  table.rolling("q1", &PaperRun::Rolling::q1_Hz);
  table.rolling("ripple", &PaperRun::Rolling::ripple, 100);
  using Early = const PaperRun::Rolling&;
  const auto early = [&](const char* name, double (*of)(Runs, Early)) {
    table.add(name, [of](Runs r) -> Value {
      const auto measured = r.high().first_5_ms();
      return measured ? Value(of(r, *measured)) : std::nullopt;
    });
  };
  early("q1_off_whirl", [](Runs, Early m) { return 100 * std::abs(m.q1_Hz / m.whirl_Hz - 1); });
  early("q1_off_sine", [](Runs, Early m) { return 100 * m.off_sine; });
  early("decrease_a_turn", [](Runs, Early m) { return 100 * m.decrease_a_turn; });
  early("whirl_period", [](Runs, Early m) { return 1 / m.whirl_Hz; });
  early("whirl_ratio", [](Runs r, Early m) { return m.whirl_Hz / r.parameters().motor_off_Hz; });
  table.onset("whirl_sense", [](Runs, At at) {
    const auto m = at.motion();
    return cross(m.displacement, m.velocity) * m.speed > 0 ? 1. : -1.;
  });
  table.add("whirl_off", off_by_own_method([](const PaperRun& run) -> Value {
              return run.first_5_ms() ? Value(run.first_5_ms()->whirl_Hz) : std::nullopt;
            }));
  table.add("final_speed_off",
            off_by_own_method([](const PaperRun& run) { return Value(speed_Hz(run.last())); }));
}

void add_collisions(Table& table) {
  using Runs = PaperRuns&;
  using At = const Instant&;
  table.touch_downs("before_the", [](Runs r, At, std::size_t after) {
    return static_cast<double>(r.high().touch_downs_before_rolling() - 1 - after);
  });
  table.touch_downs("collisions_s",
                    [](Runs r, At at, std::size_t) { return since_first_contact(r, at); });
  table.touch_downs("collisions_J", [](Runs r, At at, std::size_t) {
    return energy(r.high().after_loss()) - energy(at);
  });
  table.touch_downs(
      "sliding_s", [](Runs r, At at, std::size_t) { return r.high().onset()->time_s - at.time_s; });
  table.touch_downs("sliding_J", [](Runs r, At at, std::size_t) {
    return energy(at) - energy(*r.high().onset());
  });
  table.touch_downs("collisions_friction", friction_until);
  table.touch_downs("sliding_friction", [](Runs r, At at, std::size_t after) -> Value {
    const Value until = friction_until(r, at, after);
    return until ? Value(r.friction_work()->until_rolling - *until) : std::nullopt;
  });
  table.touch_downs("force_ratio", [](Runs r, At at, std::size_t) {
    return *peak(r.high()) / r.high().peak_until(at.time_s);
  });
  for (const bool longest : {false, true})
    table.add(longest ? "longest_s" : "shortest_s", [longest](Runs r) -> Value {
      std::vector<double> all;
      for (const PaperRun* run : at_all_frictions(r))
        for (const auto& collision : run->collisions()) all.push_back(collision.duration_s);
      if (all.empty()) return std::nullopt;
      return longest ? std::ranges::max(all) : std::ranges::min(all);
    });
  table.add("ends_indented", [](Runs r) -> Value {
    const auto& all = r.high().releases();
    return std::ranges::any_of(all, [&](At at) { return indentation(r, at) > 0; }) ? 1. : 0.;
  });
  table.add("impacts_that_do_not_slow", [](Runs r) -> Value {
    double all = 0;
    for (const PaperRun* run : at_all_frictions(r))
      for (const auto& collision : run->collisions()) all += collision.speed_gain >= 0;
    return all;
  });
  table.add("speed_in_flight", [](Runs r) -> Value {
    double greatest = 0;
    for (const PaperRun* run : at_all_frictions(r))
      greatest = std::max(greatest, run->change_of_speed_in_flight());
    return 100 * greatest;
  });
  table.add("sooner_by_friction", [](Runs r) -> Value {
    const auto count = [](const PaperRun& run) { return run.summary().touch_downs; };
    const long middle = count(r.intermediate());
    return count(r.high()) < middle && middle < count(r.low()) ? 1. : 0.;
  });
  table.add("low_collisions_s", [](Runs r) -> Value {
    const auto at = r.low().last_touch_down();
    return at ? Value(at->time_s - *r.low().summary().first_contact_s) : std::nullopt;
  });
  table.add("low_force_left", [](Runs r) -> Value {
    const Instant& at = r.low().last();
    return at.touches() ? Value(100 * force(r, at) / *peak(r.low())) : std::nullopt;
  });
  table.add("low_lasts", [](Runs r) -> Value { return r.low().last().touches() ? 1. : 0.; });
  table.add("low_slows_a_turn", [](Runs r) -> Value {
    const Instant& end = r.low().last();
    const auto from = r.low().last_touch_down();
    if (!from || !end.touches()) return std::nullopt;
    const double turns = (end.state[2] - from->state[2]) / two_pi;
    return 100 * (1 - end.state[5] / from->state[5]) / turns;
  });
  table.add("low_rolls", [](Runs r) -> Value { return r.low().onset() ? 1. : 0.; });
}

void add_other_losses_and_contacts(Table& table) {
  using Runs = PaperRuns&;
  table.add("peak_kN_100", [](Runs r) { return peak_kN(r.at_100_Hz()); });
  table.add("peak_kN_75", [](Runs r) { return peak_kN(r.at_75_Hz()); });
  table.add("rolls_at_100", [](Runs r) -> Value { return r.at_100_Hz().onset() ? 1. : 0.; });
  table.add("rolls_at_75", [](Runs r) -> Value { return r.at_75_Hz().onset() ? 1. : 0.; });
  table.add("collisions_100", [](Runs r) -> Value {
    const auto count = r.at_100_Hz().touch_downs_before_rolling();
    return count > 0 ? Value(count) : std::nullopt;
  });
  table.add("rises_with_speed", [](Runs r) {
    const Value at_100 = peak(r.at_100_Hz());  // less than any, if there is none
    return peak(r.at_75_Hz()) < at_100 && at_100 < peak(r.high()) ? 1. : 0.;
  });
  table.add("Hz_100", [](Runs r) -> Value { return speed_Hz(r.at_100_Hz().before_loss()); });
  table.add("Hz_75", [](Runs r) -> Value { return speed_Hz(r.at_75_Hz().before_loss()); });
  table.add("Hz_50", [](Runs r) -> Value { return speed_Hz(r.at_50_Hz().before_loss()); });
  table.add("Hz_critical",
            [](Runs r) -> Value { return speed_Hz(r.near_critical().before_loss()); });
  table.add("collisions_50", [](Runs r) -> Value {
    return static_cast<double>(r.at_50_Hz().summary().touch_downs);
  });
  table.add("collisions_critical", [](Runs r) -> Value {
    return static_cast<double>(r.near_critical().summary().touch_downs);
  });
  table.add("settled_50", [](Runs r) -> Value {
    const Instant& at = r.at_50_Hz().last();
    return 100 * std::abs(rho(at) / at.body.eccentricity - 1);
  });
  table.add("force_by_ratio", [](Runs r) {
    return difference(r.from_steady(0.5).relative_peak(), r.from_steady(1).relative_peak());
  });
  // A tenth larger radii with the same clearance change the largest force by more than 1 %.
  table.add("by_dimensions", [](Runs r) -> Value {
    const Parameters p = r.parameters();
    const double wider = p.rotor_radius / 10;
    const Value off =
        difference(peak(r.with(r.inputs().mu_high, {{"rotor_radius", p.rotor_radius + wider},
                                                    {"stator_radius", p.stator_radius + wider}})),
                   peak(r.high()));
    return off ? Value(*off > 1) : std::nullopt;
  });
  table.add("k_t_peak", change(&PaperInputs::mu_high, "contact_stiffness", peak));
  table.add("k_t_time", change(&PaperInputs::mu_high, "contact_stiffness", time_to_rolling));
  table.add("d_t_peak", change(&PaperInputs::mu_high, "contact_damping", peak));
  table.add("d_t_time", change(&PaperInputs::mu_high, "contact_damping", time_to_rolling));
  table.add("d_t_peak_low", change(&PaperInputs::mu_low, "contact_damping", peak));
  for (const auto& [same, name] : {std::pair(SameIndentation::impact, "impact"),
                                   std::pair(SameIndentation::rolling, "rolling")}) {
    const auto add = [&, name = name, same = same](
                         const char* what, double PaperInputs::*friction,
                         const std::function<Value(const PaperRun&)>& of) {
      table.add(std::string("law_") + what + '_' + name, change_by_law(friction, same, of));
    };
    add("force", &PaperInputs::mu_high, peak);
    add("time", &PaperInputs::mu_high, time_to_rolling);
    add("rolls", &PaperInputs::mu_high, rolls);
    add("force_low", &PaperInputs::mu_low, peak);
  }
}

const std::map<std::string, Formula>& readings() {
  static const std::map<std::string, Formula> all = [] {
    Table table;
    add_run_up_and_loss(table);
    add_rolling(table);
    add_collisions(table);
    add_other_losses_and_contacts(table);
    return table.all;
  }();
  return all;
}

}  // namespace

std::optional<double> read_off(const std::string& reading, PaperRuns& runs) {
  const auto found = all_arithmetic().find(reading);
  if (found != all_arithmetic().end()) return found->second(runs.inputs(), runs.parameters());
  return readings().at(reading)(runs);
}

std::vector<std::string> all_readings() {
  std::vector<std::string> all;
  for (const auto& [name, reading] : all_arithmetic()) all.push_back(name);
  for (const auto& [name, reading] : readings()) all.push_back(name);
  return all;
}

}  // namespace rotor
