/// The answers of reference-data/problems, each computed in the two ways that its row names.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <filesystem>
#include <limits>
#include <map>

#include "figures/data/read_csv.hpp"
#include "figures/runs/scene.hpp"
#include "model/digits/digits.hpp"
#include "model/digits/quad.hpp"
#include "verification/support/newton.hpp"
#include "verification/support/problem_observer.hpp"

namespace rotor {
namespace {

const std::filesystem::path folder = ROTOR_REFERENCE_DATA "/problems";

/// A value, and by how much it may be off.
struct Found {
  double value, error;
};
using Values = std::map<std::string, Found, std::less<>>;

/// A row of answers.csv.
struct Answer {
  std::string quantity;
  double value;
  int digits;  ///< 0: a count
  std::string known;

  explicit Answer(const CsvRow& row)
      : quantity(row["quantity"]),
        value(static_cast<double>(row.number("value"))),
        digits(row["digits"] == "exact" ? 0 : static_cast<int>(row.number("digits"))),
        known(row["known"]) {}

  /// One in its last digit.
  double unit() const {
    return digits == 0 ? 1 : std::pow(10, std::floor(std::log10(std::abs(value))) + 1 - digits);
  }
  bool is_known_by(std::string_view way) const { return known.find(way) != known.npos; }
  /// The value itself is rounded to its digits.
  bool agrees_with(const Found& found) const {
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * std::abs(value);
    return std::abs(found.value - value) <= 0.5 * unit() + rounding + found.error;
  }
};

std::vector<Answer> answers_to(const std::string& problem) {
  std::vector<Answer> answers;
  for (const CsvRow& row : read_csv(folder / "answers.csv"))
    if (row["problem"] == problem) answers.emplace_back(row);
  return answers;
}

// ---- the first way: the engine, in the precision that its row names

Values by_engine(const Scenario& scenario, int digits) {
  const auto found = run_to_digits(scenario, digits, [](double) { return true; }).value();
  EXPECT_TRUE(found.is_course_sure);
  Values all = {{"touch_downs", {static_cast<double>(found.values.touch_downs), 0}}};
  const auto add = [&](const std::string& name, const NamedEstimate& of) {
    if (of.value) all[name] = {*of.value, of.error};
  };
  for (const NamedEstimate& of : found.summary) add(std::string(of.name), of);
  std::size_t touch_downs = 0;
  for (const EventEstimate& event : found.events)
    if (event.event == Event::touch_down)
      add(ProblemObserver::time_of_touch_down(++touch_downs), event.values.front());
  const Found q1 = all.at("final_q1_m"), q2 = all.at("final_q2_m");
  all["final_displacement_m"] = {std::hypot(q1.value, q2.value), q1.error + q2.error};
  return all;
}

// ---- another way: Newton's laws in the stator's axes

/// Its errors are estimated by a second run with larger steps.
Values by_newton(const Scenario& scenario) {
  const auto run = [&](double tolerance) {
    ProblemObserver recorder(scenario);
    EXPECT_TRUE(run_by_newton(scenario, {tolerance, 30, 10'000'000}, recorder));
    return recorder.values();
  };
  const auto coarse = run(1e-10), fine = run(1e-13);
  Values all;
  for (const auto& [name, value] : fine)
    if (const auto other = coarse.find(name); other != coarse.end())
      all[name] = {value, std::abs(value - other->second) + 1e-11 * std::abs(value)};
  return all;
}

// ---- another way: closed forms, in quadruple precision

Quad typed(double number) { return as_typed<Quad>(number); }

/// A complex number; std::complex is for the standard's own types.
struct Complex {
  Quad re, im;
  friend Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend Complex operator+(const Complex& a, const Complex& b) {
    return {a.re + b.re, a.im + b.im};
  }
  friend Complex operator*(const Quad& a, const Complex& b) { return {a * b.re, a * b.im}; }
  Quad norm() const {
    using std::sqrt;
    return sqrt(Quad(re * re + im * im));
  }
};

Quad pi() {
  using std::acos;
  return acos(Quad(-1));
}

/// Where a function that is positive at first becomes negative.
template <class F>
Quad zero_of(Quad low, Quad high, const F& f) {
  for (int n = 0; n < 120; ++n) {
    const Quad middle = (low + high) / 2;
    (f(middle) > 0 ? low : high) = middle;
  }
  return low;
}

/// O in the axes that turn with the rotor, in steady motion: e m w^2 / (k - m w^2 + i d w).
Complex steady(const Parameters& p, const Quad& mass, const Quad& eccentricity, const Quad& w) {
  const Quad k = typed(p.support_stiffness) - mass * w * w, dw = typed(p.support_damping) * w;
  return eccentricity * mass * w * w / Quad(k * k + dw * dw) * Complex{k, Quad(-dw)};
}

using Exact = std::map<std::string, Quad, std::less<>>;

/// Hertz's impact of a free mass: the energy, and its integral over the time.
Exact hertz(const Scenario& scenario) {
  using std::pow;
  const Parameters& p = scenario.parameters;
  const Quad m = typed(p.mass), v = typed(scenario.start->velocity_x),
             c = typed(p.stated_clearance().value());
  const Quad depth_0 = typed(p.reference_indentation), begin = (c - typed(scenario.start->x)) / v;
  // m v^2 / 2 = k_t D_0 (2 / 5) (D / D_0)^(5/2) D_0
  const Quad energy = m * v * v / 2, k = typed(p.contact_stiffness);
  const Quad ratio = pow(Quad(5 * energy / (2 * k * depth_0 * depth_0)), Quad(Quad(2) / 5));
  // The integral of 2 / sqrt(1 - x^(5/2)) over x from 0 to 1.
  const Quad integral("2.94327518432470465738178730008292");
  const Quad length = integral * ratio * depth_0 / v;
  return {{"touch_downs", 1},
          {"touch_down_1_s", begin},
          {"peak_normal_force_N", k * depth_0 * pow(ratio, Quad(Quad(3) / 2))},
          {"peak_time_s", begin + length / 2},
          {"peak_displacement_m", c + ratio * depth_0},
          {"contact_time_s", length},
          {"final_q1_m", c - v * (typed(scenario.until) - begin - length)}};
}

/// Rolling at constant speed: m (R w / rho)^2 rho = k rho + k_t (rho - c).
Exact sliding_to_rolling(const Scenario& scenario) {
  const Parameters& p = scenario.parameters;
  const Quad rim = typed(p.rotor_radius) * 2 * pi() * typed(scenario.start_speed_Hz);
  const Quad c = typed(p.stated_clearance().value()), k_t = typed(p.contact_stiffness);
  return {{"final_displacement_m", zero_of(c, 2 * c, [&](const Quad& rho) {
             return Quad(typed(p.mass) * rim * rim / rho - typed(p.support_stiffness) * rho -
                         k_t * (rho - c));
           })}};
}

/// Free motion at constant speed after the unbalance has changed: steady motion and a vibration
/// that decays.
Exact graze(const Scenario& scenario) {
  using std::cos, std::exp, std::sin, std::sqrt;
  const Parameters& p = scenario.parameters;
  const Quad w = 2 * pi() * typed(scenario.start_speed_Hz), m = typed(p.mass);
  const Quad e = typed(p.eccentricity), e_1 = typed(p.unbalance_factor) * e;
  const Quad m_1 = m - m * (e_1 - e) / (typed(p.rotor_radius) + e_1);
  const Quad decay = typed(p.support_damping) / (2 * m_1);
  const Quad natural = sqrt(Quad(typed(p.support_stiffness) / m_1 - decay * decay));
  const Complex forced = steady(p, m_1, e_1, w), i{0, 1};
  const Complex off = steady(p, m, e, w) + Quad(-1) * forced;
  const Complex rate = 1 / natural * ((w * (i * off)) + decay * off);
  struct Point {
    Complex at, velocity;
    Quad radial() const { return (at.re * velocity.re + at.im * velocity.im) / at.norm(); }
  };
  const auto point = [&](const Quad& time) -> Point {
    const Complex turn{cos(Quad(w * time)), sin(Quad(w * time))};
    const Quad C = cos(Quad(natural * time)), S = sin(Quad(natural * time));
    const Complex vibration = exp(Quad(-decay * time)) * (C * off + S * rate);
    const Complex change = exp(Quad(-decay * time)) * (natural * (C * rate + Quad(-1) * (S * off)));
    return {forced * turn + vibration,
            w * (i * (forced * turn)) + change + Quad(-decay) * vibration};
  };
  // O moves outwards for a quarter of a period of the vibration.
  const Quad farthest =
      zero_of(typed(0.01), typed(0.03), [&](const Quad& time) { return point(time).radial(); });
  const Quad clearance = typed(p.stated_clearance().value());
  const Quad beyond = point(farthest).at.norm() / clearance - 1;
  EXPECT_NEAR(static_cast<double>(beyond), 1e-9, 1e-12);  // as its page says
  const Quad touch_down = zero_of(typed(0.01), farthest, [&](const Quad& time) {
    return Quad(clearance - point(time).at.norm());
  });
  return {{"touch_downs", 1},
          {"touch_down_1_s", touch_down},
          {"peak_normal_force_N", typed(p.contact_damping) * point(touch_down).radial()}};
}

/// The motor's torque balances the moment of damping, d w rho^2.
Exact sommerfeld(const Scenario& scenario) {
  const Parameters& p = scenario.parameters;
  const auto O = [&](const Quad& w) { return steady(p, typed(p.mass), typed(p.eccentricity), w); };
  const Quad w = zero_of(typed(1), typed(62), [&](const Quad& speed) {
    const Quad rho = O(speed).norm();
    return Quad(typed(p.torque) - typed(p.support_damping) * speed * rho * rho);
  });
  return {{"final_speed_Hz", w / (2 * pi())},
          {"final_displacement_m", O(w).norm()},
          {"final_q1_m", O(w).re},
          {"final_q2_m", O(w).im}};
}

Values by_closed_form(const std::string& problem, const Scenario& scenario) {
  const std::map<std::string, Exact (*)(const Scenario&)> forms = {
      {"hertz", hertz},
      {"sliding-to-rolling", sliding_to_rolling},
      {"graze", graze},
      {"sommerfeld", sommerfeld}};
  Values all;
  for (const auto& [name, value] : forms.at(problem)(scenario))
    all[name] = {static_cast<double>(value), 0};
  return all;
}

// ---- another way: proofs

Values by_proof(const Scenario& scenario) {
  const std::string command =
      fmt::format("build/prove --start-speed-Hz {} --friction {} --equations corrected --until {} ",
                  scenario.start_speed_Hz, scenario.parameters.friction, scenario.until);
  Values all;
  for (const CsvRow& row : read_csv(ROTOR_REFERENCE_DATA "/proven.csv"))
    if (row["command"].starts_with(command) &&
        row["command"].find("rounding") == std::string::npos) {
      const double lower = static_cast<double>(row.number("lower")),
                   upper = static_cast<double>(row.number("upper"));
      all[row["quantity"]] = {(lower + upper) / 2, (upper - lower) / 2};
    }
  return all;
}

class Problems : public testing::TestWithParam<std::string> {};

TEST_P(Problems, HaveTheAnswersThatEachWayFinds) {
  const Scenario scenario = read_scene(folder / (GetParam() + ".toml")).runs.at(0).scenario;
  const std::vector<Answer> answers = answers_to(GetParam());
  ASSERT_FALSE(answers.empty());
  // In double precision chaos and the depth of a graze have few digits; the partial rub lets errors
  // grow a millionfold before it settles.
  const std::map<std::string, double> accuracies = {
      {"chaos", 1e-2}, {"graze", 1e-2}, {"partial-rub", 1e-6}};
  const auto stated = accuracies.find(GetParam());
  const double of_newton = stated == accuracies.end() ? 1e-8 : stated->second;
  std::map<std::string, Values> ways;
  const auto expect_by = [&](const Answer& answer, const std::string& way, const auto& compute,
                             double least_accuracy) {
    if (!answer.is_known_by(way)) return;
    if (!ways.contains(way)) ways[way] = compute();
    SCOPED_TRACE(fmt::format("{} of {} by {}", answer.quantity, GetParam(), way));
    ASSERT_TRUE(ways[way].contains(answer.quantity));
    const Found found = ways[way].at(answer.quantity);
    EXPECT_TRUE(answer.agrees_with(found))
        << fmt::format("{:.17g} +- {:.1e}, not {:.17g}", found.value, found.error, answer.value);
    EXPECT_LE(found.error, least_accuracy * std::abs(answer.value));
  };
  for (const Answer& answer : answers) {
    const double last = answer.digits == 0 ? 0 : std::abs(0.5 * answer.unit() / answer.value);
    expect_by(
        answer, "quadruple", [&] { return by_engine(scenario, most_digits); }, last);
    expect_by(
        answer, "double", [&] { return by_engine(scenario, 9); }, 1e-9);
    expect_by(
        answer, "proof", [&] { return by_proof(scenario); }, last);
    expect_by(
        answer, "closed form", [&] { return by_closed_form(GetParam(), scenario); }, last);
    expect_by(
        answer, "Newton", [&] { return by_newton(scenario); }, of_newton);
  }
}

std::vector<std::string> problems() {
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(folder))
    if (file.path().extension() == ".toml") names.push_back(file.path().stem());
  std::ranges::sort(names);
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, Problems, testing::ValuesIn(problems()), [](const auto& of) {
  std::string name = of.param;
  std::erase(name, '-');
  return name;
});

}  // namespace
}  // namespace rotor
