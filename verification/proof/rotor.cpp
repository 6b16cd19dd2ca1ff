#include "verification/proof/rotor.hpp"

#include "verification/proof/greatest.hpp"

namespace proof {
namespace {

struct Plane {
  Term x, y;
};
Plane operator+(Plane a, Plane b) { return {a.x + b.x, a.y + b.y}; }
Plane operator-(Plane a, Plane b) { return {a.x - b.x, a.y - b.y}; }
Plane operator*(Term a, Plane b) { return {a * b.x, a * b.y}; }
Plane operator/(Plane a, Term b) { return {a.x / b, a.y / b}; }
Term dot(Plane a, Plane b) { return a.x * b.x + a.y * b.y; }
Term cross(Plane a, Plane b) { return a.x * b.y - a.y * b.x; }
Plane quarter_turn(Plane a) { return {-a.y, a.x}; }

/// In the order of printed_inputs(), behind which comes the end.
struct Quantities {
  Tape& tape;
  Term m = next(), I = next(), e = next(), k = next(), d = next(), g = next(), M = next(),
       f_max = next(), k_t = next(), d_t = next(), mu = next(), r = next(), c = next(),
       k_u = next(), f_0 = next(), t_1 = next(), t_end = next();
  Term two_pi = tape.constant(2 * Ball::pi());

  Term next() const { return tape.parameter(); }
};

/// Mass, moment of inertia about C, distance of C from O, and the mass that is lost.
struct Body {
  Term m, I, e, lost;
};
Body body(const Quantities& p, bool mass_lost) {
  const Term e_1 = p.k_u * p.e;
  const Term lost = p.m * (e_1 - p.e) / (p.r + e_1);  // Eq. (5)
  if (!mass_lost) return {p.m, p.I, p.e, lost};
  const Term m_1 = p.m - lost, arm = p.r + p.e, shift = e_1 - p.e;
  return {m_1, p.I - lost * arm * arm - m_1 * shift * shift, e_1, lost};  // Eq. (12)
}

/// C about O_a in the stator's axes, x downwards, the rotor's angle, their rates, and the time.
struct State {
  Tape& tape;
  Plane c{tape.state(), tape.state()};
  Term phi = tape.state();
  Plane v{tape.state(), tape.state()};
  Term w = tape.state(), t = tape.state();

  /// Along the rotor's x axis, from O to C.
  Plane unit() const {
    const SineAndCosine angle(phi);
    return {angle.cosine, angle.sine};
  }
  std::vector<Term> all() const { return {c.x, c.y, phi, v.x, v.y, w, t}; }
};

struct Phase {
  Contact contact = Contact::free;
  int direction = 0;  // sign of the slip, in sliding; 0: to be found
  bool motor = false, mass_lost = false;

  bool touches() const { return contact == Contact::sliding || contact == Contact::rolling; }
  Phase in(Contact next, int slip_direction = 0) const {
    return {next, slip_direction, motor, mass_lost};
  }
};

/// An event, what follows it, and how often the guards of that vanish where it begins.
struct Switch {
  std::string event;
  Phase next;
  std::vector<std::size_t> vanishing{};
};

struct Motion : Flow {
  std::vector<Switch> switches;  // of the guards
  Term displacement_squared, pressure, slip;

  void watch(Term guard, const Switch& at) {
    guards.push_back(guard);
    switches.push_back(at);
  }
};

Motion motion(const Case& of, const Phase& phase) {
  Motion motion;
  Tape& tape = *motion.tape;
  State z{tape};
  const Quantities p{tape};
  const Body b = body(p, phase.mass_lost);
  const Plane e = b.e * z.unit(), o = z.c - e, v = z.v - z.w * quarter_turn(e);
  const Term rho_squared = dot(o, o);

  // Eq. (4), but with the moments about C. Gravity has one though its force is left out; x is down.
  Plane force = -p.k * o - p.d * v;
  Term moment = -(b.m * p.g * (of.whole_gravity_moment ? z.c.y : e.y)) - cross(e, force);
  if (phase.motor) moment = moment + p.M;

  if (phase.contact != Contact::free) {
    const Term rho = sqrt(rho_squared);
    const Plane n = o / rho, t = quarter_turn(n);
    const Plane arm = p.r * n - e;  // from C to K
    const Term Delta = rho - p.c, Delta_rate = dot(n, v);
    const Term F_n = -(p.k_t * Delta + p.d_t * Delta_rate);  // Eq. (21)
    motion.pressure = -F_n;
    motion.slip = dot(t, v) + p.r * z.w;  // Eq. (19)
    if (phase.touches()) {
      force = force + F_n * n;
      moment = moment + F_n * cross(arm, n);
      motion.watch(-F_n, {"release", phase.in(Contact::indented), {0, 1}});
    } else {
      motion.watch(rho_squared - p.c * p.c, {"ring_clear", phase.in(Contact::free), {1}});
      motion.watch(F_n, {"renewed_contact", phase.in(Contact::sliding), {1}});
    }
    Term F_tau = phase.direction * (p.mu * F_n);  // in sliding, Eqs. (22)-(24)
    const Term lever = cross(arm, t);
    if (phase.contact == Contact::sliding)
      motion.watch(phase.direction * motion.slip, {"no_slip", phase.in(Contact::rolling)});
    if (phase.contact == Contact::rolling) {
      // What keeps the slip: its rate without friction + F_tau / m_tau = 0. t' = -n (t.v) / rho.
      const Term alpha = moment / b.I;
      const Term without = dot(t, force) / b.m - alpha * dot(t, quarter_turn(e)) +
                           z.w * z.w * dot(t, e) - dot(t, v) * Delta_rate / rho + p.r * alpha;
      F_tau = -(without / (1 / b.m + lever * lever / b.I));
      const Term limit = p.mu * motion.pressure;
      motion.watch(limit - F_tau, {"break_away", phase.in(Contact::sliding, -1), {0, 2}});
      motion.watch(limit + F_tau, {"break_away", phase.in(Contact::sliding, 1), {0, 2}});
    }
    if (phase.touches()) {
      force = force + F_tau * t;
      moment = moment + F_tau * lever;
    }
  } else {
    motion.watch(p.c * p.c - rho_squared, {"touch_down", phase.in(Contact::sliding)});
  }
  Phase without_motor = phase, mass_lost = phase;
  without_motor.motor = false;
  mass_lost.mass_lost = true;
  if (phase.motor) motion.watch(p.two_pi * p.f_max - z.w, {"motor_off", without_motor});
  if (!phase.mass_lost) motion.watch(p.t_1 - z.t, {"mass_loss", mass_lost});
  motion.watch(p.t_end - z.t, {"end", phase});

  const Plane a = force / b.m;
  motion.states = z.all();
  motion.rates = {z.v.x, z.v.y, z.w, a.x, a.y, moment / b.I, tape.constant(1)};
  motion.tape->set_rates(motion.rates);
  motion.displacement_squared = rho_squared;
  return motion;
}

/// At rest, or in steady response to the unbalance: m w^2 e = (k - m w^2 + i w d) o, in axes that
/// turn with the rotor, at a speed that is constant.
StateSet start(const Inputs& inputs) {
  Tape tape;
  State z{tape};
  const Quantities p{tape};
  const Term w = p.two_pi * p.f_0, spring = p.k - p.m * w * w, damper = p.d * w;
  const Term size = p.m * w * w * p.e / (spring * spring + damper * damper);
  z.c = size * Plane{spring, -damper} + p.e * z.unit();
  z.v = w * quarter_turn(z.c);
  z.w = w;
  return map(tape, z.all(), inputs, StateSet::at(Row(7), inputs));
}

/// O and the rotation go on as they are, and C is elsewhere. As printed, O is given Delta_vy across
/// the unbalance.
StateSet lose_mass(const Case& of, const Inputs& inputs, const StateSet& set) {
  Tape tape;
  State z{tape};
  const Quantities p{tape};
  const Body b = body(p, true);
  const Plane shift = (b.e - p.e) * z.unit();
  const Term jump = b.lost * z.w * (p.r + p.e) / b.m;  // Eq. (14)
  z.c = z.c + shift;
  z.v = z.v + z.w * quarter_turn(shift);  // Eq. (1)
  if (of.jump_twice) z.v = z.v + jump * quarter_turn(z.unit());
  return map(tape, z.all(), inputs, set);
}

class Run {
 public:
  explicit Run(const Case& of) : of_(of) {
    const Ball share(of.rounding);
    for (const PrintedInput& input : printed_inputs()) {
      const auto given = of.inputs.find(input.name);
      inputs_.centre.emplace_back(given == of.inputs.end() ? input.value : given->second);
      inputs_.half.push_back((share * Ball(input.rounding)).upper());
    }
    inputs_.centre.emplace_back(of.until);
    inputs_.half.emplace_back(0);
    inputs_.scale = Row(7, Ball(1));
  }

  Findings findings() {
    try {
      follow_all();
    } catch (const Undecided& e) {
      findings_.undecided = e.what();
    }
    findings_.greatest_force_N = force_.value();
    findings_.greatest_displacement_m = sqrt(displacement_.value());
    return std::move(findings_);
  }

 private:
  void follow_all() {
    set_ = start(inputs_);
    Phase phase;
    const bool from_rest = inputs_.centre[14].is_exactly_zero();
    phase.motor = (inputs_.centre[7] - inputs_.centre[14]).is_positive();
    phase.mass_lost = !from_rest;
    if (phase.mass_lost) set_ = lose_mass(of_, inputs_, set_);
    for (Switch now{"start", phase}; now.event != "end";) {
      const Motion motion = proof::motion(of_, now.next);
      const Passage passage = follow(motion, now);
      set_ = passage.set;
      const Phase before = now.next;
      now = motion.switches[passage.guard];
      decide(now, before);
      note(motion, now.event, before);
    }
  }

  Passage follow(const Motion& motion, const Switch& from) {
    const Phase& phase = from.next;
    const auto observer = [&](const Step& step, const Ball& surely, const Ball& at_most) {
      ++findings_.steps;
      findings_.reached_s = step.range(motion.states[6], surely);
      if (!phase.mass_lost) return;
      displacement_.see(step, motion.displacement_squared, surely, at_most);
      if (phase.touches()) force_.see(step, motion.pressure, surely, at_most);
    };
    // Errors that do about the same in flight, and in contact.
    inputs_.scale = phase.contact == Contact::free ? Row{1, 1, 100, 100, 100, 1e4, 1}
                                                   : Row{1, 1, 10, 1e4, 1e4, 1e5, 0.1};
    return proof::follow(motion, inputs_, set_, from.vanishing, settings_, step_length_, observer);
  }

  void note(const Motion& motion, const std::string& event, const Phase& phase) {
    const auto value = [&](Term term) { return range(*motion.tape, term, inputs_, set_); };
    findings_.happenings.push_back({event, value(motion.states[6]),
                                    value(motion.states[5]) / (2 * Ball::pi()),
                                    phase.touches() ? value(motion.pressure) : Ball(0)});
  }

  /// What depends on the state: which way the rim slides, and whether friction can hold it.
  void decide(Switch& now, const Phase& before) {
    if (now.event == "mass_loss") set_ = lose_mass(of_, inputs_, set_);
    if (now.event == "mass_loss" && before.contact != Contact::free)
      throw Undecided("a mass loss in contact, which is not provided for");
    if (now.next.contact == Contact::sliding && now.next.direction == 0) {
      const Motion sliding = motion(of_, now.next);
      const Ball slip = range(*sliding.tape, sliding.slip, inputs_, set_);
      if (!slip.is_positive() && !slip.is_negative()) throw Undecided("which way the rim slides");
      now.next.direction = slip.is_positive() ? 1 : -1;
    }
    if (now.event != "no_slip") return;
    const Motion rolling = motion(of_, now.next);
    const Ball grip = range(*rolling.tape, rolling.guards[1], inputs_, set_);
    const Ball grip_back = range(*rolling.tape, rolling.guards[2], inputs_, set_);
    if (grip.is_positive() && grip_back.is_positive())
      now.event = "rolling_onset";
    else if (grip.is_negative() || grip_back.is_negative())
      now = {"slip_reversal", before.in(Contact::sliding, -before.direction), {0, 1}};
    else
      throw Undecided("whether friction can hold the rim");
  }

  const Case& of_;
  Inputs inputs_;
  Settings settings_;
  StateSet set_;
  Ball step_length_ = 1e-5;
  Greatest force_, displacement_;
  Findings findings_;
};

}  // namespace

std::span<const PrintedInput> printed_inputs() {
  static const std::vector<PrintedInput> all = {
      {"mass", "5", "0.5"},
      {"inertia", "9e-3", "0.005e-3"},
      {"eccentricity", "0.15e-3", "0.005e-3"},
      {"support-stiffness", "20e3", "500"},
      {"support-damping", "25", "0.5"},
      {"gravity", "9.81", "0.005"},
      {"torque", "0.3", "0.05"},
      {"motor-off-hz", "150", "0"},
      {"contact-stiffness", "8e8", "0.5e8"},
      {"contact-damping", "1e4", "0.5e4"},
      {"friction", "0.3", "0.05"},
      {"rotor-radius", "0.06", "0.0005"},
      {"clearance", "0.003", "0.0005"},
      {"unbalance-factor", "3", "0.004"},
      {"start-speed-hz", "0", "0.5"},
      {"mass-loss-time", "29.1", "0.05"},
  };
  return all;
}

Findings prove(const Case& of) { return Run(of).findings(); }

}  // namespace proof
