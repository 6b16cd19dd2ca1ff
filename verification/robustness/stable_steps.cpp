/// `stable-steps FOLDER`: the limits of stability of the published method's step.
#include <fmt/format.h>

#include <boost/math/tools/roots.hpp>
#include <complex>

#include "figures/data/files.hpp"
#include "model/methods/published_method.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

/// Whether a small disturbance stays small in steps of the published method, for a rotor that
/// slides along the ring without friction, pressed against it by its own whirl.
bool stays_bounded(const Parameters& p, double step) {
  const Scenario scenario{.parameters = p, .method = Method::rk4, .step_rub = step};
  const Ring<double> ring(p);
  // So small that the whirl is slow and the ring nearly straight during this time.
  const double indentation = 1e-8 * ring.clearance;
  const double rho = ring.clearance + indentation;
  const double whirl = std::sqrt(p.contact_stiffness * indentation / (p.mass * rho));
  struct : Observer {
    void on_instant(const Instant& at) override {
      const double rho_now = std::hypot(at.state[0], at.state[1]);
      largest = std::max(largest, std::abs(rho_now - rho) / disturbance);
    }
    double rho = 0, disturbance = 0, largest = 0;
  } watch;
  watch.rho = rho;
  watch.disturbance = 1e-3 * indentation;
  Instant at = at_rest(p);
  at.contact = ContactState::sliding;
  at.state = {rho + watch.disturbance, 0, 0, 0, whirl * rho, 0};
  try {
    PublishedMethod(scenario, at).advance(4000 * step, watch);
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
  // In one step the rim of a whirling rotor moves along the tangent by omega h sqrt(Delta rho), and
  // the ring curves away from it by (omega h)^2 Delta / 2: the contact is lost, and resumes, well
  // below the limit of linear theory.
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

int main(const Arguments& arguments) {
  if (arguments.size() != 1) throw std::runtime_error("needs: FOLDER");
  FileTransaction files;
  files.write(std::filesystem::path(arguments[0]) / "stability.csv", stability_limits());
  files.commit();
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  return rotor::run_program("stable-steps", rotor::main, argc, argv);
}
