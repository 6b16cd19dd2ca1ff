/// How far both methods can be pushed: random rotors through the event-located method, and the
/// limit of stability of the published method's step. `stress rotors COUNT FOLDER` ends with
/// status 1 if a run went wrong without saying so; `stress steps FOLDER` finds the limits.
#include <fmt/format.h>

#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/roots.hpp>
#include <chrono>
#include <complex>
#include <map>
#include <random>

#include "figures/csv.hpp"
#include "model/event_method.hpp"
#include "model/published_method.hpp"
#include "verification/just_separated.hpp"
#include "verification/ledger.hpp"
#include "verification/program.hpp"

namespace rotor {
namespace {

constexpr double two_pi = boost::math::constants::two_pi<double>();

/// Keeps the books of a run, and looks for the rim beyond the ring where the run says it is free.
class Auditor : public Ledger {
 public:
  explicit Auditor(const Scenario& scenario)
      : Ledger(scenario), clearance_(Ring<double>(scenario.parameters).clearance) {}

  using Ledger::see;
  void see(const Instant& at) override {
    Ledger::see(at);
    for (const double component : at.state) finite_ = finite_ && std::isfinite(component);
    touch_downs_ += at.event == Event::touch_down;
  }
  void see(const Piece& piece) override {
    Ledger::see(piece);
    constexpr int samples = 32;
    for (int i = 0; i <= samples; ++i) {
      const Instant at = piece.at(piece.from_s + (piece.until_s - piece.from_s) * i / samples);
      if (at.contact == ContactState::free)
        intrusion_ = std::max(intrusion_, at.motion().displacement.norm() / clearance_ - 1);
    }
  }

  bool finite() const { return finite_; }
  long touch_downs() const { return touch_downs_; }
  double intrusion() const { return intrusion_; }  ///< into the ring while free, in clearances

 private:
  double clearance_;
  bool finite_ = true;
  long touch_downs_ = 0;
  double intrusion_ = 0;
};

/// Draws rotors and mass losses, most parameters evenly in their logarithm.
class Lottery {
 public:
  explicit Lottery(unsigned seed) : random_(seed) {}

  double between(double least, double greatest) {
    return least * std::pow(greatest / least, std::uniform_real_distribution<double>()(random_));
  }
  bool one_in(int n) { return std::uniform_int_distribution<int>(1, n)(random_) == 1; }

  Scenario scenario() {
    Scenario scenario;
    Parameters& p = scenario.parameters;
    do {
      draw(p);
    } while (MassLoss<double>(p).after.inertia <= 0);  // as any input is checked
    p.separates = false;                               // the runs start just after it
    scenario.equations = one_in(2) ? Equations::published : Equations::consistent;
    scenario.tolerance = 1e-9;
    return scenario;
  }

  /// Of a rotor just after its mass loss, rad/s.
  double speed() { return one_in(20) ? 0 : two_pi * between(0.1, 1000) * (one_in(10) ? -1 : 1); }

 private:
  void draw(Parameters& p) {
    p.rotor_radius = between(0.01, 1);
    p.mass = between(0.1, 1000);
    p.inertia = p.mass * p.rotor_radius * p.rotor_radius * between(0.1, 2);
    p.contact_stiffness = between(1e5, 1e13);
    p.contact_damping = one_in(10) ? 0 : between(1, 1e7);
    p.friction = one_in(10) ? 0 : between(1e-3, 10);
    p.stator_radius = p.rotor_radius + between(1e-6, 1e-2);
    p.eccentricity = one_in(10) ? 0 : between(1e-7, 1e-3);
    p.unbalance_factor = between(1, 5);
    p.support_stiffness = between(1e3, 1e7);
    p.support_damping = one_in(10) ? 0 : between(1, 1e3);
    p.gravity = one_in(4) ? 0 : 9.81;
    p.torque = one_in(2) ? 0 : between(0.01, 10);
    p.motor_off_Hz = between(1, 1000);
  }

  std::mt19937_64 random_;
};

/// What a run did.
struct Look {
  std::string refusal;  ///< why it ended before its time, if it did
  bool finite = true;
  double intrusion = 0, defect = 0;  ///< into the ring, and of the books
  long touch_downs = 0, right_hand_sides = 0;

  // A flight's step may be wrong by the tolerance of 1/300 of the clearance, and there may be a
  // thousand; the books are those of an error of 1e-9 a step, multiplied by contacts.
  static constexpr double allowed_intrusion = 1e-8, allowed_defect = 1e-6;
  bool missed() const { return intrusion > allowed_intrusion; }
  bool is_off_the_books() const { return !(defect < allowed_defect); }
  bool is_conspicuous() const {
    return !refusal.empty() || !finite || missed() || is_off_the_books();
  }
};

Look look(const Scenario& scenario, const Instant& first) {
  constexpr double duration_s = 0.01;
  Auditor auditor(scenario);
  auditor.see(first);
  Look look;
  Work work;
  try {
    EventMethod<double>(scenario, scenario.tolerance, auditor, work).rub(first, duration_s);
  } catch (const std::runtime_error& error) {
    const std::string reason = error.what();
    look.refusal = reason.substr(reason.find(": ") + 2, 40);
  }
  look.finite = auditor.finite();
  look.intrusion = auditor.intrusion();
  look.defect = std::max(auditor.energy_defect(), auditor.angular_momentum_defect());
  look.touch_downs = auditor.touch_downs();
  look.right_hand_sides = work.right_hand_sides;
  return look;
}

struct Tally {
  long ended = 0, refused = 0, touch_downs = 0, right_hand_sides = 0, second_looks = 0;
  long not_finite = 0, missed = 0, off_the_books = 0;
  double worst_books = 0, worst_intrusion = 0;   ///< at first look
  std::map<int, std::array<long, 2>> by_decade;  ///< how many books, intrusions below 10^key
  std::map<std::string, long> reasons;
};

/// The exponent of the power of ten above a defect; -17 for all that cannot be told from none.
int decade(double defect) {
  return std::max(-17, static_cast<int>(std::ceil(std::log10(std::max(defect, 1e-17)))));
}

std::string describe(const Scenario& s, const Instant& at) {
  std::string text;
  for (const Quantity& quantity : quantities())
    text += fmt::format("{}={} ", quantity.name, quantity.of(s));
  return text + fmt::format("speed={} equations={}", at.state[5], static_cast<int>(s.equations));
}

Tally random_rotors(long count, std::string& worst) {
  Tally tally;
  Lottery lottery(1);
  const auto begin = std::chrono::steady_clock::now();
  for (long n = 0; n < count; ++n) {
    Scenario scenario = lottery.scenario();
    const Instant first = just_separated(scenario, lottery.speed());
    Look seen = look(scenario, first);
    tally.touch_downs += seen.touch_downs;
    tally.right_hand_sides += seen.right_hand_sides;
    ++tally.by_decade[decade(seen.defect)][0];
    ++tally.by_decade[decade(seen.intrusion)][1];
    tally.worst_books = std::max(tally.worst_books, seen.defect);
    tally.worst_intrusion = std::max(tally.worst_intrusion, seen.intrusion);
    if (seen.is_conspicuous()) {
      // Errors of integration fall with the tolerance; a contact missed or a hole in the books
      // stays.
      ++tally.second_looks;
      scenario.tolerance /= 100;
      seen = look(scenario, first);
    }
    ++(seen.refusal.empty() ? tally.ended : tally.refused);
    if (!seen.refusal.empty()) ++tally.reasons[seen.refusal];
    tally.not_finite += !seen.finite;
    tally.missed += seen.missed();
    tally.off_the_books += seen.is_off_the_books();
    if (seen.is_conspicuous())
      worst += fmt::format("{},{},{},{},{},{}\n", n, seen.refusal, seen.finite, seen.intrusion,
                           seen.defect, describe(scenario, first));
    if (n % 1000 == 999)
      fmt::print(stderr, "\r{} of {} rotors, {:.0f} s", n + 1, count,
                 std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  fmt::print(stderr, "\n");
  return tally;
}

/// A rotor that slides round inside the ring without friction, pressed against it by its own whirl,
/// in steps of the published method: whether a small disturbance stays small.
bool stays_bounded(const Parameters& p, double step) {
  const Scenario scenario{.parameters = p, .method = Method::rk4, .step_rub = step};
  const Ring<double> ring(p);
  // So slight that the whirl is slow and the ring nearly straight for as long as this takes.
  const double indentation = 1e-8 * ring.clearance;
  const double rho = ring.clearance + indentation;
  const double whirl = std::sqrt(p.contact_stiffness * indentation / (p.mass * rho));
  struct : Observer {
    void see(const Instant& at) override {
      const double rho_now = std::hypot(at.state[0], at.state[1]);
      largest = std::max(largest, std::abs(rho_now - rho) / disturbance);
    }
    using Observer::see;
    double rho = 0, disturbance = 0, largest = 0;
  } watch;
  watch.rho = rho;
  watch.disturbance = 1e-3 * indentation;
  Instant at = start(scenario);
  at.contact = ContactState::sliding;
  at.state = {rho + watch.disturbance, 0, 0, 0, whirl * rho, 0};
  Work work;
  try {
    PublishedMethod(scenario, watch, work).rub(at, 4000 * step);
  } catch (const std::runtime_error&) {
    return false;
  }
  return watch.largest < 20;
}

/// Largest stable step of classical Runge-Kutta on m x'' + d x' + k x = 0.
double linear_theory(double mass, double damping, double stiffness) {
  using C = std::complex<double>;
  const C root = std::sqrt(C(damping * damping - 4 * mass * stiffness));
  const auto growth = [&](double h) {
    double largest = 0;
    for (const double sign : {-1., 1.}) {
      const C z = h * (-damping + sign * root) / (2 * mass);
      largest = std::max(largest, std::abs(1. + z * (1. + z / 2. * (1. + z / 3. * (1. + z / 4.)))));
    }
    return largest - 1 - 1e-12;
  };
  const double scale = 1 / (std::sqrt(stiffness / mass) + damping / mass);
  double h = scale;
  while (growth(h) < 0) h *= 1.001;
  return h;
}

std::string stability_limits() {
  std::string csv = "contact_stiffness_N_per_m,contact_damping_Ns_per_m,limit_s,linear_theory_s\n";
  // The rim of a rotor that its whirl presses against the ring moves on along the tangent by
  // omega h sqrt(Delta rho) in a step, and the ring curves away from under it by (omega h)^2 Delta
  // / 2: the contact is lost, and comes back, well before linear theory's limit.
  fmt::print(
      "\nLargest stable step of the published method, and by linear theory of a straight ring\n");
  for (const double damping : {0., 1e4, 1e6, 1e7})
    for (double stiffness = 1e5; stiffness < 2e13; stiffness *= 10) {
      Parameters p{.support_stiffness = 0,
                   .support_damping = 0,
                   .gravity = 0,
                   .torque = 0,
                   .contact_stiffness = stiffness,
                   .contact_damping = damping,
                   .friction = 0};
      p.eccentricity = 0;
      const double theory = linear_theory(p.mass, damping, stiffness);
      const auto unstable = [&](double step) { return stays_bounded(p, step) ? -1. : 1.; };
      double limit = std::numeric_limits<double>::quiet_NaN();
      if (unstable(theory / 4) < 0 && unstable(4 * theory) > 0)
        limit =
            boost::math::tools::bisect(unstable, theory / 4, 4 * theory, [&](double a, double b) {
              return b - a < 1e-3 * theory;
            }).first;
      fmt::print("k_t = {:.0e} N/m, d_t = {:.0e} N s/m: {}, theory {:.3e} s\n", stiffness, damping,
                 std::isnan(limit) ? "bounded by the clamp of F_n" : fmt::format("{:.3e} s", limit),
                 theory);
      csv += fmt::format("{},{},{},{}\n", stiffness, damping, limit, theory);
    }
  return csv;
}

int rotors(long count, const std::filesystem::path& folder) {
  std::string worst = "rotor,refusal,finite,intrusion,books_defect,parameters\n";
  const Tally tally = random_rotors(count, worst);
  fmt::print("\n{} random rotors ended, {} refused; {} touch-downs, {} right-hand sides\n",
             tally.ended, tally.refused, tally.touch_downs, tally.right_hand_sides);
  for (const auto& [reason, number] : tally.reasons)
    fmt::print("  refused {}: {}\n", number, reason);
  fmt::print(
      "at a tolerance of 1e-9: deepest into the ring while free {:.1e} of the clearance, books of "
      "energy or angular momentum open by {:.1e} at most\n",
      tally.worst_intrusion, tally.worst_books);
  fmt::print(
      "looked at again at 1e-11: {}; left of them: not finite {}, contacts missed {} (more than "
      "{:.0e}), books open {} (more than {:.0e})\n",
      tally.second_looks, tally.not_finite, tally.missed, Look::allowed_intrusion,
      tally.off_the_books, Look::allowed_defect);
  FileTransaction files;
  files.write(folder / "conspicuous-rotors.csv", worst);
  std::string defects = "below_ten_to_the,books,intrusions\n";
  for (const auto& [exponent, numbers] : tally.by_decade)
    defects += fmt::format("{},{},{}\n", exponent, numbers[0], numbers[1]);
  files.write(folder / "defects.csv", defects);
  files.commit();
  // Bounces that die away in the rounding of the ring's indentation may open the books a little,
  // and are ended by the rule for that.
  const long few = count / 10'000;
  constexpr double little = 1e-4;
  return tally.refused + tally.off_the_books > few || tally.worst_books > little ||
         tally.not_finite + tally.missed > 0;
}

int steps(const std::filesystem::path& folder) {
  FileTransaction files;
  files.write(folder / "stability.csv", stability_limits());
  files.commit();
  return 0;
}

int main(const Arguments& arguments) {
  if (arguments.size() == 3 && arguments[0] == "rotors")
    return rotors(std::stol(arguments[1]), arguments[2]);
  if (arguments.size() == 2 && arguments[0] == "steps") return steps(arguments[1]);
  throw std::runtime_error("needs: rotors COUNT FOLDER, or: steps FOLDER");
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("stress", rotor::main, argc, argv); }
