/// `validate FOLDER TABLE [CASES]`: lets LIGGGHTS compute the accidents, or those with CASES in
/// their name, and compares the engine with it. FOLDER receives the curves of the picture.
/// `validate FOLDER`: enters LIGGGHTS to reference-data/problems, as FOLDER/LIGGGHTS.csv.
#include <sys/resource.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "figures/data/csv.hpp"
#include "figures/data/files.hpp"
#include "figures/data/read_csv.hpp"
#include "figures/data/thinning.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/program.hpp"
#include "verification/validation/cases.hpp"

namespace rotor {
namespace {

constexpr int samples = 25;  // their distance in coarse steps

/// In SI units and the stator's axes.
constexpr const char* input = R"in(atom_style granular
atom_modify map array
communicate single vel yes
region box block -{size} {size} -{size} {size} -{size} {size} units box
create_box 1 box
neigh_modify exclude group all all
{spheres}group disk id 1
fix k_t all property/global kn peratomtypepair 1 {k_t}
fix none all property/global kt peratomtypepair 1 0
fix d_t all property/global gamman{abs} peratomtypepair 1 {d_t}
fix viscosity all property/global gammat{abs} peratomtypepair 1 {viscosity}
fix mu all property/global coefficientFriction peratomtypepair 1 {mu}
pair_style gran model {model}{absolute} limitForce on
pair_coeff * *
timestep {step}
fix body all rigid single force * on on off torque * off off {turns}
fix ring disk wall/gran model {model} &
  primitive type 1 zcylinder {r_a} 0 0 store_force yes{absolute} limitForce on
fix springs disk spring tether {k} {rest_x} {rest_y} 0 0
fix dampers disk viscous {d}
fix weight all gravity {g} vector 1 0 0
fix preload disk addforce -{weight} 0 0
variable x equal x[1]
variable y equal y[1]
variable dx equal x[2]-x[1]
variable dy equal y[2]-y[1]
variable w equal omegaz[1]
variable fx equal f_force_ring[1][1]
variable fy equal f_force_ring[1][2]
fix out all print {every} "$(step) ${{x}} ${{y}} ${{dx}} ${{dy}} ${{w}} ${{fx}} ${{fy}}" screen no file liggghts.out title ""
run {steps}
)in";

/// The rotor is a rigid body of three spheres: one of radius r at O, which alone touches the ring,
/// and two tiny ones at +-arm on the line through C. Their masses give m, e and I.
std::string spheres(const ComparedAccident& accident) {
  const Instant& from = accident.given_from;
  const Body<double>& body = from.body;
  const Motion<double> m = from.motion();
  const double r = accident.given.parameters.rotor_radius, tiny = 1e-2 * r, arm = 5 * r / 6,
               e = body.eccentricity, at_arm = arm * arm + 0.4 * tiny * tiny,
               mass = (body.mass * (at_arm - e * e) - body.inertia) / (at_arm - 0.4 * r * r);
  std::string all;
  for (const int i : {0, 1, -1}) {
    const Vector<double> offset(i * arm, 0),
        swirl = m.speed * quarter_turn(offset),
        at = in_stator_frame(m.displacement + offset, from.state[2]),
        v = in_stator_frame(m.velocity + swirl, from.state[2]);
    all += fmt::format(
        "create_atoms 1 single {} {} 0 units box\n"
        "set atom {} diameter {} mass {} vx {} vy {} omegaz {}\n",
        at.x(), at.y(), i < 0 ? 3 : i + 1, 2 * (i == 0 ? r : tiny),
        i == 0 ? mass : (body.mass - mass + i * body.mass * e / arm) / 2, v.x(), v.y(), m.speed);
  }
  return all;
}

/// Takes steps of that length and samples that many steps apart. Adds the normal force over time to
/// the curve, if there is one.
Course by_liggghts(const ComparedAccident& accident, double step_s, int every,
                   const std::string& folder, Table* curve = nullptr) {
  const Parameters& p = accident.given.parameters;
  const double r = p.rotor_radius;
  using fmt::arg;
  // F = kn sqrt(r) Delta^1.5 in Hertz's contact, and friction of gammat m sqrt(r Delta).
  const bool is_hertz = p.contact_exponent == 1.5;
  const double k_t =
      is_hertz ? p.contact_stiffness / std::sqrt(p.reference_indentation * r) : p.contact_stiffness;
  // A negative viscosity drives the rim instead of braking it.
  const double braking = std::copysign(viscosity(p, step_s), p.friction),
               root = accident.given_from.body.mass * std::sqrt(r * deepest_for_viscosity(p));
  std::ofstream(folder + "/liggghts.in") << fmt::format(
      input, arg("size", 4 * r), arg("spheres", spheres(accident)), arg("k_t", k_t),
      arg("d_t", p.contact_damping), arg("mu", std::abs(p.friction)),
      arg("model", is_hertz ? "hertz/stiffness tangential no_history"
                            : "hooke/stiffness tangential no_history"),
      arg("absolute", is_hertz ? "" : " absolute_damping on"), arg("abs", is_hertz ? "" : "_abs"),
      arg("viscosity", is_hertz ? braking / root : braking), arg("step", step_s),
      arg("r_a", p.stator_radius), arg("k", p.support_stiffness), arg("d", p.support_damping),
      arg("turns", p.drive == Drive::constant_speed ? "off" : "on"),
      arg("rest_x", -p.ring_offset_x), arg("rest_y", -p.ring_offset_y), arg("g", p.gravity),
      arg("weight", accident.given_from.body.mass * p.gravity), arg("every", every),
      arg("steps", std::lround(accident.until_s / step_s)));
  if (std::system(
          fmt::format("cd {} && liggghts -in liggghts.in >liggghts.log 2>&1", folder).c_str()) != 0)
    throw std::runtime_error(
        fmt::format("liggghts failed on liggghts.in: see {}/liggghts.log", folder));
  Course course;
  std::ifstream rows(folder + "/liggghts.out");
  double step = 0, x = 0, y = 0, dx = 0, dy = 0, w = 0, fx = 0, fy = 0;
  while (rows >> step >> x >> y >> dx >> dy >> w >> fx >> fy) {
    const double rho = std::hypot(x, y), force_N = -(fx * x + fy * y) / rho,
                 arm = std::hypot(dx, dy);
    course.add({step * step_s, p.stator_radius - r - rho, force_N, (fy * x - fx * y) / rho,
                in_Hz(w), (x * dx + y * dy) / arm, (y * dx - x * dy) / arm},
               p.friction);
    if (curve != nullptr) curve->add(std::array{step * step_s, force_N});
  }
  return course;
}

constexpr const char* head =
    R"(# Accidents by LIGGGHTS and by the engine, from `make validate`; verification/validation/README.md says what agrees, and why.
# Times count from the mass loss. liggghts: with steps of 5e-4 sqrt(m/k_t), 4e-8 s for the paper's rotor; liggghts_finer: of a third
# of it; empty: not run, or it does not come to that. Differences of times and counts are absolute. engine_lever: the engine's
# equations with LIGGGHTS's lever of friction.
case,quantity,liggghts,liggghts_finer,engine,difference,allowed,expected,engine_lever,left,left_allowed
)";

std::string cell(double value, const char* form = "{:.8g}") {
  return std::isnan(value) ? "" : fmt::format(fmt::runtime(form), value);
}

/// Processor time of the programs that this one has waited for.
double seconds_of_others() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  return static_cast<double>(used.ru_utime.tv_sec) +
         1e-6 * static_cast<double>(used.ru_utime.tv_usec);
}

/// Samples have the distance of `accidents`, or a little less so that the last is at the end. The
/// forces are computed once in a step.
int enter_problems(const std::string& folder) {
  std::string csv =
      "# An entry to the problems of rub by LIGGGHTS, from `make validate`\n"
      "problem,quantity,value,seconds,right_hand_sides\n";
  for (const ComparedAccident& problem : problems()) {
    fmt::print(stderr, "problem {}\n", problem.name);
    const Parameters& p = problem.scenario.parameters;
    const int every = samples * finer;
    const long steps = every * std::lround(std::ceil(problem.until_s / coarse_step_s(p) / samples));
    const double begin_s = seconds_of_others();
    const auto values =
        by_liggghts(problem, problem.until_s / static_cast<double>(steps), every, folder).values(p);
    const double seconds = seconds_of_others() - begin_s;
    for (const CsvRow& row : read_csv(ROTOR_REFERENCE_DATA "/problems/answers.csv"))
      if (const auto value = values.find(row["quantity"]);
          row["problem"] == problem.name && value != values.end())
        csv += fmt::format("{},{},{:.10g},{:.2g},{}\n", problem.name, value->first, value->second,
                           seconds, steps);
  }
  write_file(folder + "/LIGGGHTS.csv", csv);
  return 0;
}

int validate(const Arguments& arguments) {
  if (arguments.empty()) throw std::invalid_argument("usage: validate FOLDER [TABLE [CASES]]");
  const std::string& folder = arguments[0];
  if (arguments.size() == 1) return enter_problems(folder);
  FileTransaction files;
  OutputFile& table = files.open(arguments[1]);
  table.write(head);
  Table force(2), rebounds(2);
  int unexpected = 0;
  for (const ComparedAccident& accident : accidents()) {
    if (arguments.size() > 2 && accident.name.find(arguments[2]) == std::string::npos) continue;
    fmt::print(stderr, "{}\n", accident.name);
    const bool mistaken = accident.mistaken;
    const auto findings = [&](int divisor, Table* curve = nullptr) {
      const double step_s = coarse_step_s(accident.given.parameters) / divisor;
      return by_liggghts(accident, step_s, samples * divisor, folder, curve).findings(accident);
    };
    const auto theirs = findings(1, force.rows() == 0 ? &force : nullptr),
               better = mistaken ? theirs : findings(finer),
               with = mistaken ? theirs : with_lever(accident).findings(accident);
    for (const Finding& ours : by_engine(accident).findings(accident)) {
      const std::string& name = ours.quantity;
      if (mistaken && name != "touch_down_7_s" && name != "peak_normal_force_N") continue;
      Finding lever = ours;
      lever.value = ours.lever_allowed > 0 && !mistaken ? find(with, name) : NAN;
      const double best = find(better, name), difference = ours.difference(best),
                   left = lever.difference(best);
      const bool agrees =
          std::abs(difference) <= ours.allowed && !(std::abs(left) > ours.lever_allowed);
      const std::string row =
          fmt::format("{},{},{},{},{},{},{:.2g},{},{},{},{}\n", csv_field(accident.name), name,
                      cell(find(theirs, name)), cell(mistaken ? NAN : best), cell(ours.value),
                      cell(difference, "{:.1e}"), ours.allowed, mistaken ? "differ" : "agree",
                      cell(lever.value), cell(left, "{:.1e}"),
                      cell(std::isnan(left) ? NAN : ours.lever_allowed));
      table.write(row);
      if (agrees != mistaken) continue;
      ++unexpected;
      fmt::print(stderr, "not as expected: {}", row);
    }
  }
  for (double angle_deg = 1; angle_deg < 90; ++angle_deg)
    rebounds.add(std::array{angle_deg, rebound(angle_deg).tangential_restitution});
  const auto write = [&](const char* name, std::string_view x, std::string_view y,
                         const Table& rows) {
    files.write(folder + name, csv_head({}, {"run", x, y}) + csv_rows({{"", rows}}));
  };
  write("/force.csv", "time_s", "normal_force_N", thinned(force, thinning));
  write("/rebounds.csv", "angle_deg", "tangential_restitution", rebounds);
  files.commit();
  return unexpected > 0 ? 1 : 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  return rotor::run_program("validate", rotor::validate, argc, argv);
}
