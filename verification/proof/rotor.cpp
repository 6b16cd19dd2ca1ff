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

/// The state and the inputs as terms. Jumps and motions are made of them.
struct Rotor : Flow {
  const Case& of;

  // C about O_a in the stator's axes, x downwards, the rotor's angle, their rates, and the time.
  Plane z{tape.state(), tape.state()};
  Term phi = tape.state();
  Plane v{tape.state(), tape.state()};
  Term w = tape.state(), t = tape.state();

  Term m = input("mass"), I = input("inertia"), e = input("eccentricity");
  Term k = input("support-stiffness"), d = input("support-damping"), g = input("gravity");
  Term M_mot = input("torque"), f_max = input("motor-off-Hz");
  Term k_t = input("contact-stiffness"), d_t = input("contact-damping"), mu = input("friction");
  Term r = input("rotor-radius"), c = input("clearance"), k_u = input("unbalance-factor");
  Term f_0 = input("start-speed-Hz"), t_1 = input("mass-loss-time"), t_end = input("until");
  Term two_pi = tape.constant(2 * Ball::pi());

  // The lost mass, and the rotor without it.
  Term e_1 = k_u * e, m_u = m * (e_1 - e) / (r + e_1), m_1 = m - m_u;    // Eq. (5)
  Term I_1 = I - m_u * (r + e) * (r + e) - m_1 * (e_1 - e) * (e_1 - e);  // Eq. (12)

  // Along the rotor's x axis, from O to C.
  std::pair<Term, Term> sine_and_cosine = tape.sine_and_cosine(phi, w);
  Plane unit{sine_and_cosine.second, sine_and_cosine.first};

  explicit Rotor(const Case& of_run) : of(of_run) {
    scale = {1, 1, 100, 100, 100, 1e4, 1};  // errors with about the same effect in flight
  }
  Term input(const std::string& name) {
    const auto& [value, rounding] = of.inputs.at(name);
    return tape.parameter(Ball(value), (Ball(of.rounding) * Ball(rounding)).upper());
  }
  std::vector<Term> state() const { return {z.x, z.y, phi, v.x, v.y, w, t}; }
};

/// After a release the ring may stay indented for a while.
enum class Contact { free, sliding, rolling, indented };

struct Phase {
  Contact contact = Contact::free;
  int direction = 0;  // sign of the slip, in sliding; 0: to be found
  bool motor = false, mass_lost = false;

  Phase in(Contact next, int slip = 0) const { return {next, slip, motor, mass_lost}; }
};

/// An event, the phase after it, and the order of the zeros of its guards at the start.
struct Switch {
  std::string event;
  Phase next;
  std::vector<std::size_t> vanishing{};
};

struct Motion : Rotor {
  std::vector<Switch> switches;  // of the guards
  Term displacement_squared{}, pressure{}, slip{};

  void watch(Term guard, const Switch& at) {
    guards.push_back(guard);
    switches.push_back(at);
  }
  Motion(const Case& of_run, const Phase& phase) : Rotor(of_run) {
    const Term mass = phase.mass_lost ? m_1 : m, inertia = phase.mass_lost ? I_1 : I;
    const Plane to_C = (phase.mass_lost ? e_1 : e) * unit;  // from O
    const Plane o = z - to_C, v_O = v - w * quarter_turn(to_C);
    displacement_squared = dot(o, o);

    // Eq. (4), but with the moments about C. Gravity has a moment, although its force is left out.
    Plane force = -k * o - d * v_O;
    Term moment = -(mass * g * (of.published ? z.y : to_C.y)) - cross(to_C, force);
    if (phase.motor) moment = moment + M_mot;

    if (phase.contact == Contact::free) {
      watch(c * c - displacement_squared, {"touch_down", phase.in(Contact::sliding)});
    } else {
      scale = {1, 1, 10, 1e4, 1e4, 1e5, 0.1};
      const Term rho = sqrt(displacement_squared);
      const Plane e_n = o / rho, e_tau = quarter_turn(e_n), to_K = r * e_n - to_C;  // from C
      const Term Delta = rho - c, Delta_rate = dot(e_n, v_O);
      const Term F_n = -(k_t * Delta + d_t * Delta_rate);  // Eq. (21)
      pressure = -F_n;
      slip = dot(e_tau, v_O) + r * w;  // Eq. (19)
      if (phase.contact == Contact::indented) {
        watch(Delta, {"ring_clear", phase.in(Contact::free), {1}});
        watch(F_n, {"renewed_contact", phase.in(Contact::sliding), {1}});
      } else {
        // Pressure ends before the indentation does, which therefore needs no guard.
        force = force + F_n * e_n;
        moment = moment + F_n * cross(to_K, e_n);
        watch(pressure, {"release", phase.in(Contact::indented), {0, 1}});
        const Term lever = cross(to_K, e_tau);
        Term F_tau = phase.direction * (mu * F_n);  // Eqs. (22)-(24)
        if (phase.contact == Contact::sliding) {
          watch(phase.direction * slip, {"no_slip", phase.in(Contact::rolling)});
        } else {
          // F_tau keeps the slip constant: its rate without friction + F_tau / m_tau = 0, where
          // e_tau' = -e_n (e_tau . v_O) / rho.
          const Term alpha = moment / inertia;
          const Term without = dot(e_tau, force) / mass - alpha * dot(e_tau, quarter_turn(to_C)) +
                               w * w * dot(e_tau, to_C) - dot(e_tau, v_O) * Delta_rate / rho +
                               r * alpha;
          F_tau = -(without / (1 / mass + lever * lever / inertia));
          const Term limit = mu * pressure;
          watch(limit - F_tau, {"break_away", phase.in(Contact::sliding, -1), {0, 2}});
          watch(limit + F_tau, {"break_away", phase.in(Contact::sliding, 1), {0, 2}});
        }
        force = force + F_tau * e_tau;
        moment = moment + F_tau * lever;
      }
    }
    Phase without_motor = phase;
    without_motor.motor = false;
    if (phase.motor) watch(two_pi * f_max - w, {"motor_off", without_motor});
    if (!phase.mass_lost) watch(t_1 - t, {"mass_loss", {.motor = phase.motor, .mass_lost = true}});
    watch(t_end - t, {"end", phase});

    const Plane a = force / mass;
    tape.set_rates({v.x, v.y, w, a.x, a.y, moment / inertia, tape.constant(1)});
  }
};

class Run {
 public:
  explicit Run(const Case& of) : of_(of), set_(Row(7), Rotor(of).tape) {}

  Findings findings() {
    try {
      for (Switch now{"start", start()}; now.event != "end";) now = after(now);
    } catch (const Undecided& what) {
      const double reached_s = set_.values[6][0].to_double();  // the last state
      throw Undecided("undecided at " + std::to_string(Ball::bits) +
                      " bits after t = " + std::to_string(reached_s) + " s: " + what.what());
    }
    found_.emplace_back("touch_downs", touch_downs_);
    if (touch_downs_ > 0) found_.emplace_back("peak_normal_force_N", force_.value());
    found_.emplace_back("peak_displacement_m", sqrt(displacement_.value()));
    return std::move(found_);
  }

 private:
  Switch after(const Switch& from) {
    const Phase& phase = from.next;
    const Motion motion(of_, phase);
    const auto observer = [&](const Step& step, const Ball& surely, const Ball& at_most) {
      if (!phase.mass_lost) return;
      displacement_.see(step, motion.displacement_squared, surely, at_most);
      if (phase.contact != Contact::free) force_.see(step, motion.pressure, surely, at_most);
    };
    Switch now = motion.switches[follow(motion, set_, step_length_, from.vanishing, observer)];
    decide(now, phase);
    note(motion, now.event);
    return now;
  }

  /// At rest, or just after the loss in steady response to the unbalance: in axes that turn with
  /// the constant speed m w^2 e = (k - m w^2 + i w d) o. The motor is on if all start below its
  /// end.
  Phase start() {
    Rotor z(of_);
    const Term w = z.two_pi * z.f_0, spring = z.k - z.m * w * w, damper = z.d * w;
    const Term size = z.m * w * w * z.e / (spring * spring + damper * damper);
    z.z = size * Plane{spring, -damper} + z.e * z.unit;
    z.v = w * quarter_turn(z.z);
    z.w = w;
    const Phase phase{.motor = set_.range(z.f_max - z.f_0) > 0, .mass_lost = set_.range(z.f_0) > 0};
    jump(z);
    if (phase.mass_lost) lose_mass();
    return phase;
  }

  /// O and the rotation continue unchanged, and C is at another place. As printed, O also gets
  /// Delta_vy across the unbalance.
  void lose_mass() {
    Rotor z(of_);
    const Plane shift = (z.e_1 - z.e) * z.unit;
    const Term Delta_v = z.m_u * z.w * (z.r + z.e) / z.m_1;  // Eq. (14)
    z.z = z.z + shift;
    z.v = z.v + z.w * quarter_turn(shift);  // Eq. (1)
    if (of_.published) z.v = z.v + Delta_v * quarter_turn(z.unit);
    jump(z);
  }

  void jump(const Rotor& to) { set_ = set_.with(set_.map(to.state()), to.scale); }

  /// What depends on the state: the direction of sliding, and whether friction can hold the rim.
  void decide(Switch& now, const Phase& before) {
    if (now.event == "mass_loss" && before.contact != Contact::free)
      throw Undecided("the outcome of a mass loss in contact");
    if (now.event == "mass_loss") lose_mass();
    if (now.next.contact == Contact::sliding && now.next.direction == 0) {
      const Ball slip = set_.range(Motion(of_, now.next).slip);
      if (!(slip > 0) && !(slip < 0)) throw Undecided("which way the rim slides");
      now.next.direction = slip > 0 ? 1 : -1;
    }
    if (now.event != "no_slip") return;
    const Motion rolling(of_, now.next);
    const Ball grip = set_.range(rolling.guards[1]), grip_back = set_.range(rolling.guards[2]);
    if (grip > 0 && grip_back > 0)
      now.event = "rolling_onset";
    else if (grip < 0 || grip_back < 0)
      now = {"slip_reversal", before.in(Contact::sliding, -before.direction), {0, 1}};
    else
      throw Undecided("whether friction can hold the rim");
  }

  void note(const Motion& motion, const std::string& event) {
    const Ball time = set_.range(motion.t), speed_Hz = set_.range(motion.w) / (2 * Ball::pi());
    if (event == "touch_down")
      found_.emplace_back("touch_down_" + std::to_string(++touch_downs_) + "_s", time);
    if (event == "motor_off") found_.emplace_back("motor_off_s", time);
    if (event == "mass_loss") found_.emplace_back("speed_at_mass_loss_Hz", speed_Hz);
    if (event != "rolling_onset" || std::exchange(rolled_, true)) return;
    found_.emplace_back("rolling_onset_s", time);
    found_.emplace_back("rolling_onset_speed_Hz", speed_Hz);
    found_.emplace_back("rolling_onset_force_N", set_.range(motion.pressure));
  }

  const Case& of_;
  StateSet set_;
  Ball step_length_ = 1e-5;
  Greatest force_, displacement_;
  long touch_downs_ = 0;
  bool rolled_ = false;
  Findings found_;
};

}  // namespace

Findings prove(const Case& of) { return Run(of).findings(); }

}  // namespace proof
