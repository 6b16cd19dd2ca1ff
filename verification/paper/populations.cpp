#include "verification/paper/populations.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "figures/data/read_csv.hpp"
#include "verification/paper/readings.hpp"
#include "verification/paper/rules.hpp"

namespace rotor {
namespace {

/// Ranges of the proposals for inputs on which the text prints arithmetic: each as if those before
/// it and the speed were as printed. m follows from Delta_vy, e_x from 75 g cm, k_u from 223.9 g
/// cm, r from v_DC, I_C from I_C1; all ranges are slightly wider than these digits allow. A test
/// checks that no draw is near an end.
const std::vector<InputRange>& proposals() {
  static const std::vector<InputRange> box = {
      {"mass", 4.968, 5.020},
      {"eccentricity", 0.1489e-3, 0.1511e-3},
      {"unbalance_factor", 2.9985, 3.0020},
      {"rotor_radius", 0.05994, 0.06008},
      {"inertia", 8.9935e-3, 9.0065e-3},
  };
  return box;
}

/// Converts a proposal to inputs: a larger m reduces e_x, both reduce k_u, and the speed reduces r.
/// The map is linear and preserves volumes, and so a uniform distribution stays uniform.
void put_in_place(std::map<std::string, double, std::less<>>& numbers) {
  const Parameters p;
  const auto more = [&](const char* input, double printed) {
    return numbers.at(input) / printed - 1;
  };
  numbers.at("eccentricity") -= p.eccentricity * more("mass", p.mass);
  numbers.at("unbalance_factor") -=
      p.unbalance_factor * (more("mass", p.mass) + more("eccentricity", p.eccentricity));
  numbers.at("rotor_radius") -= p.rotor_radius * more("motor_off_Hz", p.motor_off_Hz);
}

/// Draws of the run-up, from which the torque and a time follow.
constexpr const char *motor_off_s = "motor_off_s", *speed_at_50 = "speed_at_50";

bool is_left_to_arithmetic(const std::string& input) {
  for (const char* found : {"torque", "t_50", "clearance", "lost_mass"})
    if (input == found) return true;
  return std::ranges::find(proposals(), input, &InputRange::input) != proposals().end();
}

/// A conditioning number: its formula, and the range that prints the same.
struct Condition {
  std::function<double(const PaperInputs&, const Parameters&)> value;
  Allowed allowed;
};

/// The conditioning claims, and the allowed ranges of those that the run-up determines.
struct Conditions {
  std::vector<Condition> arithmetic;
  Allowed motor_off_s, speed_at_50;
};

Conditions read_conditions(const std::filesystem::path& claims) {
  Conditions conditions;
  for (const CsvRow& row : read_csv(claims)) {
    if (row["conditions"] != "yes") continue;
    const Allowed printed = allowed(row["printed"], row["rule"]);
    if (row["kind"] == "arithmetic") {
      conditions.arithmetic.push_back({all_arithmetic().at(row["readings"]), printed});
    } else if (row["number"] == "motor_off") {
      conditions.motor_off_s = printed;
    } else if (row["number"] == "speed_9") {
      conditions.speed_at_50 = printed;
    } else if (row["number"] != "speed_14") {  // it follows from the others
      row.fail("no draw can be conditioned on that");
    }
  }
  return conditions;
}

void add(Sweep& sweep, const std::string& input, double least, double greatest) {
  sweep.sample.over.push_back({input, Distribution::uniform, least, greatest});
}

/// When the run-up of a rotor reaches a speed, s.
double run_up_time(const ScenarioSpec& spec, double speed_Hz) {
  RunUps run_ups;
  Observer null_observer;
  const auto reached =
      run_ups.time_at_speed(scenario_of(spec, run_ups), speed_Hz, std::nullopt, null_observer);
  if (!reached.time_s) throw std::runtime_error("the run-up does not reach that speed");
  return *reached.time_s;
}

/// The torque with which the motor is switched off at a time. The time is nearly inversely
/// proportional to the torque, so each iteration multiplies the error by about a thousandth, the
/// share of the losses.
double torque_for(const PaperInputs& inputs, double off_s) {
  ScenarioSpec spec = inputs.spec;
  const double speed_Hz = spec.numbers.at("motor_off_Hz");
  spec.numbers["motor_off_Hz"] = 1.01 * speed_Hz;  // the motor still drives at that instant
  double torque = Parameters{}.torque;
  for (int n = 0; n < 8; ++n) {
    spec.numbers["torque"] = torque;
    const double at_s = run_up_time(spec, speed_Hz);
    torque *= at_s / off_s;
    if (std::abs(at_s / off_s - 1) < 1e-8) break;
  }
  return torque;
}

}  // namespace

std::vector<InputRange> read_input_ranges(const std::filesystem::path& printed_inputs) {
  std::vector<InputRange> ranges;
  for (const CsvRow& row : read_csv(printed_inputs))
    ranges.push_back({row["input"], static_cast<double>(row.number("least")),
                      static_cast<double>(row.number("greatest"))});
  return ranges;
}

PopulationDraws::PopulationDraws(Population population, const std::filesystem::path& reference_data,
                                 long count, unsigned seed) {
  const std::vector<InputRange> ranges = read_input_ranges(reference_data / "printed-inputs.csv");
  sweep_.sample.seed = seed;
  sweep_.sample.count = std::numeric_limits<long>::max();
  if (population == Population::a) {
    for (const auto& [input, least, greatest] : ranges)
      if (input.starts_with("t_")) add(sweep_, input, least, greatest);
    return;
  }
  // Independent draws: an accepted part of Sobol's sequence would not be one.
  sweep_.sample.method = Sampling::random;
  for (const auto& [input, least, greatest] : proposals()) add(sweep_, input, least, greatest);
  const auto speed = std::ranges::find(ranges, "motor_off_Hz", &InputRange::input);
  add(sweep_, speed->input, speed->least, speed->greatest);
  const Sweep proposed = sweep_;
  const Conditions conditions = read_conditions(reference_data / "claims.csv");
  const SweepPoints propose(proposed);
  long tried = 0;
  for (; static_cast<long>(accepted_.size()) < count; ++tried) {
    if (tried > 100'000 &&
        static_cast<double>(accepted_.size()) < 1e-4 * static_cast<double>(tried))
      throw std::runtime_error("population (b): hardly any proposal prints the paper's numbers");
    PaperInputs inputs;
    inputs.spec = propose(tried).spec;
    put_in_place(inputs.spec.numbers);
    const Parameters p = scenario_of(inputs.spec).parameters;
    if (std::ranges::all_of(conditions.arithmetic, [&](const Condition& condition) {
          return condition.allowed.holds(condition.value(inputs, p));
        }))
      accepted_.push_back(tried);
  }
  proposals_a_draw_ = static_cast<double>(tried) / static_cast<double>(count);
  for (const auto& [input, least, greatest] : ranges)
    if (!is_left_to_arithmetic(input) && input != "motor_off_Hz")
      add(sweep_, input, least, greatest);
  const Allowed ring = allowed("0.063", "digits");  // r_a
  add(sweep_, "stator_radius", ring.least(), ring.greatest());
  add(sweep_, motor_off_s, conditions.motor_off_s.least(), conditions.motor_off_s.greatest());
  add(sweep_, speed_at_50, conditions.speed_at_50.least(), conditions.speed_at_50.greatest());
  for (const CsvRow& row : read_csv(reference_data / "printed-results.csv")) {
    const Allowed printed = allowed(row["printed"], row["rule"]);
    add(sweep_, row["input"], printed.least(), printed.greatest());
  }
}

std::map<std::string, double> PopulationDraws::proposed_shares(long n) const {
  const auto drawn = SweepPoints(sweep_)(accepted_.at(static_cast<std::size_t>(n))).spec.numbers;
  std::map<std::string, double> shares;
  for (const auto& [input, least, greatest] : proposals())
    shares[input] = (drawn.at(input) - least) / (greatest - least);
  return shares;
}

PaperInputs PopulationDraws::operator()(long n, const Equations& equations) const {
  const long point = accepted_.empty() ? n : accepted_.at(static_cast<std::size_t>(n));
  PaperInputs inputs;
  inputs.spec.equations = equations;
  inputs.spec.numbers["tolerance"] = 1e-8;  // draws need only the printed digits
  std::map<std::string, double, std::less<>> drawn = SweepPoints(sweep_)(point).spec.numbers;
  const auto taken = [&](const char* input) { return drawn.extract(input).mapped(); };
  if (accepted_.empty()) {
    for (const auto& [input, value] : drawn) inputs.set(input, value);
    return inputs;
  }
  put_in_place(drawn);
  const double off_s = taken(motor_off_s), speed_Hz = taken(speed_at_50);
  for (const auto& [input, value] : drawn) inputs.set(input, value);
  inputs.set("torque", torque_for(inputs, off_s));
  inputs.set("t_50", run_up_time(inputs.spec, speed_Hz));
  return inputs;
}

}  // namespace rotor
