#include "verification/proof/rotor.hpp"

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

/// The inputs, and the end of the run: those with a width are parameters, others constants.
struct Inputs {
  Row values, widths;

  explicit Inputs(const Case& of) {
    for (const auto& [name, value, rounding] : printed_inputs) {
      const auto given = of.inputs.find(name);
      values.emplace_back(given == of.inputs.end() ? value : given->second);
      widths.push_back((Ball(of.rounding) * Ball(rounding)).upper());
    }
    values.emplace_back(of.until);
    widths.emplace_back(0);
  }
};

/// Their terms, in the same order.
struct Quantities {
  Tape& tape;
  const Inputs& inputs;
  std::size_t count = 0;
  Term m = next(), I = next(), e = next(), k = next(), d = next(), g = next(), M = next(),
       f_max = next(), k_t = next(), d_t = next(), mu = next(), r = next(), c = next(),
       k_u = next(), f_0 = next(), t_1 = next(), t_end = next();
  Term two_pi = tape.constant(2 * Ball::pi());

  Term next() {
    const std::size_t i = count++;
    return inputs.widths[i] > 0 ? tape.parameter() : tape.constant(inputs.values[i]);
  }
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
    const auto [sine, cosine] = tape.sine_and_cosine(phi, w);
    return {cosine, sine};
  }
  std::vector<Term> all() const { return {c.x, c.y, phi, v.x, v.y, w, t}; }
};

/// After a release the ring may stay indented for a while.
enum class Contact { free, sliding, rolling, indented };

struct Phase {
  Contact contact = Contact::free;
  int direction = 0;  // sign of the slip, in sliding; 0: to be found
  bool motor = false, mass_lost = false;

  bool touches() const { return contact == Contact::sliding || contact == Contact::rolling; }
  Phase in(Contact next, int slip_direction = 0) const {
    return {next, slip_direction, motor, mass_lost};
  }
};

/// An event, the phase after it, and the order of the zeros of its guards at the start.
struct Switch {
  std::string event;
  Phase next;
  std::vector<std::size_t> vanishing{};
};

struct Motion : Flow {
  std::vector<Switch> switches;  // of the guards
  Term time, speed, displacement_squared, pressure, slip;

  Motion(const Case& of, const Inputs& inputs, const Phase& phase);
  void watch(Term guard, const Switch& at) {
    guards.push_back(guard);
    switches.push_back(at);
  }
};

Motion::Motion(const Case& of, const Inputs& inputs, const Phase& phase) {
  State z{tape};
  const Quantities p{tape, inputs};
  const Body b = body(p, phase.mass_lost);
  const Plane e = b.e * z.unit(), o = z.c - e, v = z.v - z.w * quarter_turn(e);
  states = z.all();
  time = z.t;
  speed = z.w;
  displacement_squared = dot(o, o);

  // Eq. (4), but with the moments about C. Gravity has a moment, although its force is left out.
  Plane force = -p.k * o - p.d * v;
  Term moment = -(b.m * p.g * (of.whole_gravity_moment ? z.c.y : e.y)) - cross(e, force);
  if (phase.motor) moment = moment + p.M;

  // Errors with about the same effect in flight, and in contact.
  scale = {1, 1, 100, 100, 100, 1e4, 1};
  if (phase.contact == Contact::free) {
    watch(p.c * p.c - displacement_squared, {"touch_down", phase.in(Contact::sliding)});
  } else {
    scale = {1, 1, 10, 1e4, 1e4, 1e5, 0.1};
    const Term rho = sqrt(displacement_squared);
    const Plane n = o / rho, t = quarter_turn(n);
    const Plane arm = p.r * n - e;  // from C to K
    const Term Delta = rho - p.c, Delta_rate = dot(n, v);
    const Term F_n = -(p.k_t * Delta + p.d_t * Delta_rate);  // Eq. (21)
    pressure = -F_n;
    slip = dot(t, v) + p.r * z.w;  // Eq. (19)
    if (phase.contact == Contact::indented) {
      watch(Delta, {"ring_clear", phase.in(Contact::free), {1}});
      watch(F_n, {"renewed_contact", phase.in(Contact::sliding), {1}});
    } else {
      force = force + F_n * n;
      moment = moment + F_n * cross(arm, n);
      watch(pressure, {"release", phase.in(Contact::indented), {0, 1}});
      const Term lever = cross(arm, t);
      Term F_tau = phase.direction * (p.mu * F_n);  // Eqs. (22)-(24)
      if (phase.contact == Contact::sliding) {
        watch(phase.direction * slip, {"no_slip", phase.in(Contact::rolling)});
      } else {
        // F_tau keeps the slip constant: its rate without friction + F_tau / m_tau = 0. t' = -n
        // (t.v) / rho.
        const Term alpha = moment / b.I;
        const Term without = dot(t, force) / b.m - alpha * dot(t, quarter_turn(e)) +
                             z.w * z.w * dot(t, e) - dot(t, v) * Delta_rate / rho + p.r * alpha;
        F_tau = -(without / (1 / b.m + lever * lever / b.I));
        const Term limit = p.mu * pressure;
        watch(limit - F_tau, {"break_away", phase.in(Contact::sliding, -1), {0, 2}});
        watch(limit + F_tau, {"break_away", phase.in(Contact::sliding, 1), {0, 2}});
      }
      force = force + F_tau * t;
      moment = moment + F_tau * lever;
    }
  }
  Phase without_motor = phase, mass_lost = phase;
  without_motor.motor = false;
  mass_lost.mass_lost = true;
  if (phase.motor) watch(p.two_pi * p.f_max - z.w, {"motor_off", without_motor});
  if (!phase.mass_lost) watch(p.t_1 - z.t, {"mass_loss", mass_lost});
  watch(p.t_end - z.t, {"end", phase});

  const Plane a = force / b.m;
  const std::vector<Term> rates = {z.v.x, z.v.y, z.w, a.x, a.y, moment / b.I, tape.constant(1)};
  for (std::size_t i = 0; i < rates.size(); ++i) tape.set_rate(states[i], rates[i]);
}

class Run {
 public:
  explicit Run(const Case& of)
      : of_(of), inputs_(of), set_(Row(7), inputs_.values, inputs_.widths) {}

  Findings findings() {
    try {
      for (Switch now{"start", start()}; now.event != "end";) now = after(now);
    } catch (const Undecided& what) {
      throw Undecided(what.what() + (", after t = " + std::to_string(reached_s_.to_double())) +
                      " s");
    }
    note("touch_downs", touch_downs_);
    if (touch_downs_ > 0) note("peak_normal_force_N", force_.value());
    note("max_displacement_m", sqrt(displacement_.value()));
    return std::move(findings_);
  }

 private:
  Switch after(const Switch& from) {
    const Phase& phase = from.next;
    const Motion motion(of_, inputs_, phase);
    const auto observer = [&](const Step& step, const Ball& surely, const Ball& at_most) {
      reached_s_ = step.range(motion.time, surely);
      if (!phase.mass_lost) return;
      displacement_.see(step, motion.displacement_squared, surely, at_most);
      if (phase.touches()) force_.see(step, motion.pressure, surely, at_most);
    };
    Switch now = motion.switches[follow(motion, set_, from.vanishing, step_length_, observer)];
    decide(now, phase);
    note(motion, now.event);
    return now;
  }

  /// At rest, or just after the loss in steady response to the unbalance: m w^2 e = (k - m w^2 + i
  /// w d) o, in axes that turn with the rotor, at a speed that is constant.
  Phase start() {
    Tape tape;
    State z{tape};
    const Quantities p{tape, inputs_};
    const Term w = p.two_pi * p.f_0, spring = p.k - p.m * w * w, damper = p.d * w;
    const Term size = p.m * w * w * p.e / (spring * spring + damper * damper);
    z.c = size * Plane{spring, -damper} + p.e * z.unit();
    z.v = w * quarter_turn(z.c);
    z.w = w;
    Phase phase;
    phase.motor = set_.range(tape, p.f_max - p.f_0) > 0;
    phase.mass_lost = set_.range(tape, p.f_0) > 0;
    jump(tape, z);
    if (phase.mass_lost) lose_mass();
    return phase;
  }

  /// O and the rotation continue unchanged, and C is at another place. As printed, O also gets
  /// Delta_vy across the unbalance.
  void lose_mass() {
    Tape tape;
    State z{tape};
    const Quantities p{tape, inputs_};
    const Body b = body(p, true);
    const Plane shift = (b.e - p.e) * z.unit();
    const Term Delta_v = b.lost * z.w * (p.r + p.e) / b.m;  // Eq. (14)
    z.c = z.c + shift;
    z.v = z.v + z.w * quarter_turn(shift);  // Eq. (1)
    if (of_.jump_twice) z.v = z.v + Delta_v * quarter_turn(z.unit());
    jump(tape, z);
  }

  void jump(const Tape& tape, const State& z) {
    set_ = set_.with(set_.map(tape, z.all()), Motion(of_, inputs_, {}).scale);
  }

  /// What depends on the state: the direction of sliding, and whether friction can hold the rim.
  void decide(Switch& now, const Phase& before) {
    if (now.event == "mass_loss" && before.contact != Contact::free)
      throw Undecided("the outcome of a mass loss in contact");
    if (now.event == "mass_loss") lose_mass();
    if (now.next.contact == Contact::sliding && now.next.direction == 0) {
      const Motion sliding(of_, inputs_, now.next);
      const Ball slip = set_.range(sliding.tape, sliding.slip);
      if (!(slip > 0) && !(slip < 0)) throw Undecided("which way the rim slides");
      now.next.direction = slip > 0 ? 1 : -1;
    }
    if (now.event != "no_slip") return;
    const Motion rolling(of_, inputs_, now.next);
    const Ball grip = set_.range(rolling.tape, rolling.guards[1]);
    const Ball grip_back = set_.range(rolling.tape, rolling.guards[2]);
    if (grip > 0 && grip_back > 0)
      now.event = "rolling_onset";
    else if (grip < 0 || grip_back < 0)
      now = {"slip_reversal", before.in(Contact::sliding, -before.direction), {0, 1}};
    else
      throw Undecided("whether friction can hold the rim");
  }

  void note(const std::string& quantity, const Ball& value) {
    findings_.emplace_back(quantity, value);
  }
  void note(const Motion& motion, const std::string& event) {
    const Ball time = set_.range(motion.tape, motion.time);
    const Ball speed_Hz = set_.range(motion.tape, motion.speed) / (2 * Ball::pi());
    if (event == "touch_down") note("touch_down_" + std::to_string(++touch_downs_) + "_s", time);
    if (event == "motor_off") note("motor_off_s", time);
    if (event == "mass_loss") note("speed_at_mass_loss_Hz", speed_Hz);
    if (event != "rolling_onset" || std::exchange(rolled_, true)) return;
    note("rolling_onset_s", time);
    note("rolling_onset_speed_Hz", speed_Hz);
    note("rolling_onset_force_N", set_.range(motion.tape, motion.pressure));
  }

  const Case& of_;
  const Inputs inputs_;
  StateSet set_;
  Ball step_length_ = 1e-5;
  Greatest force_, displacement_;
  long touch_downs_ = 0;
  bool rolled_ = false;
  Ball reached_s_;
  Findings findings_;
};

}  // namespace

Findings prove(const Case& of) { return Run(of).findings(); }

}  // namespace proof
