/// Runs that would take too many steps are refused at once, and no others.
#include "model/methods/step_limit.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <numbers>

#include "model/integration/verner.hpp"
#include "model/results/stop_on.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/random_inputs.hpp"

namespace rotor {
namespace {

using Limit = StepLimit<double>;

// x' = z x in steps of 1, for decaying z in all directions.
TEST(StepLimit, IsBeyondEveryStableStep) {
  using Plane = std::array<double, 2>;
  const auto growth = [](const std::complex<double>& z) {
    const auto system = [&](const Plane& x, Plane& rates, double) {
      const std::complex<double> rate = z * std::complex(x[0], x[1]);
      rates = {rate.real(), rate.imag()};
    };
    Verner87<Plane, double> stepper;
    const Plane start = {1, 0};
    Plane rates, end, errors;
    system(start, rates, 0);
    stepper.do_step(system, start, rates, 0., end, 1., errors);
    return std::hypot(end[0], end[1]);
  };
  double longest = 0;
  for (int degrees = 90; degrees <= 180; ++degrees)
    for (double size = 1; size < 30; size += 0.01)
      if (growth(std::polar(size, degrees * std::numbers::pi / 180)) <= 1) longest = size;
  EXPECT_LT(longest, Limit::longest_stable);
  EXPECT_GT(longest, 0.97 * Limit::longest_stable);
}

/// Compares the mean of so many steps with the bound for which runs are refused, once it has been
/// shorter.
class MeanStep : public Observer {
 public:
  MeanStep(const Scenario& scenario, long most)
      : rotor_(scenario.parameters, scenario.equations), left_(most) {}

  void on_instant(const Instant& at) override { rotor_.body = at.body; }
  bool should_continue(const Progress& now) override {
    constexpr long together = 512;
    if (left_ % together == 0) {
      const double size =
          (now.time_s - last_s_) / static_cast<double>(together) * support_rate(rotor_).per_s;
      if (is_bound_) greatest = std::max(greatest, size);
      is_bound_ = is_bound_ || size < Limit::longest_stable;
      last_s_ = now.time_s;
    }
    return --left_ > 0;
  }
  bool may_stop_early() const override { return true; }

  double greatest = 0;

 private:
  RotorSystem<double> rotor_;
  long left_;
  double last_s_ = 0;
  bool is_bound_ = false;
};

// A thousand times as long as usual, through run-ups, contacts and what follows them.
TEST(StepLimit, IsTheMostThatAnyRunTakesInTheMean) {
  RandomInputs random(1);
  double greatest = 0;
  for (int n = 0; n < 80; ++n) {
    const RandomInputs::Rotor drawn = random.rotor();
    Scenario scenario = drawn.scenario;
    scenario.method = Method::event;
    scenario.until *= 1000;
    MeanStep mean(scenario, 20'000);
    run(scenario, mean);
    EXPECT_LT(mean.greatest, Limit::longest_stable) << options_of(drawn.stated);
    greatest = std::max(greatest, mean.greatest);
  }
  EXPECT_GT(greatest, 2);  // some follow their supports
}

/// Why a run is refused within a fifth of a second; empty if it is not.
std::string refusal(const Scenario& scenario, std::optional<StopOn> stop_on = {}) {
  constexpr long most = 100'000;
  struct Few : Observer {
    bool should_continue(const Progress& /*now*/) override { return ++count < most; }
    long count = 0;
  } few;
  ObserverGroup observers = {&few};
  std::optional<StopObserver> stop;
  if (stop_on) observers.add(stop.emplace(*stop_on, scenario));
  try {
    run(scenario, observers);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  EXPECT_LT(few.count, most) << "neither refused nor finished";
  return "";
}

void expect_refusal(const Scenario& scenario, std::initializer_list<const char*> inputs) {
  const std::string reason = refusal(scenario);
  EXPECT_NE(reason, "");
  for (const char* input : inputs)
    EXPECT_NE(reason.find(input), std::string::npos) << input << " in: " << reason;
}

TEST(StepLimit, RefusesARunThatIsTooLongForItsSupports) {
  expect_refusal({.parameters = {.support_damping = 5e9}}, {"support_damping / (2 mass)", "until"});
  expect_refusal({.parameters = {.support_stiffness = 1e22}}, {"sqrt(support_stiffness / mass)"});
  expect_refusal({.until = 1e9}, {"until", "sqrt(support_stiffness / mass)"});
  expect_refusal({.parameters = {.mass_loss_time = 1e9}, .until = 2e9}, {"mass_loss_time"});
  // What stops early, or is not moved by anything, may last as long as it will.
  EXPECT_EQ(refusal({.until = 1e9}, StopOn::outcome), "");
  EXPECT_EQ(refusal({.parameters = {.eccentricity = 0, .support_damping = 5e9}, .until = 1e9}), "");
}

TEST(StepLimit, RefusesAToleranceBelowRounding) {
  Scenario scenario;
  scenario.parameters.stator_radius = scenario.parameters.rotor_radius + 1e-12;
  expect_refusal(scenario, {"tolerance = 1e-11", "clearance = 1e-12 m"});
}

// The times of a run are rounded to some 4e-15 s here; with the second stiffness a step as short
// was tried again and again.
TEST(StepLimit, RefusesStepsThatAreShorterThanTheRoundingOfTime) {
  for (const double stiffness : {1e30, 1e28})
    expect_refusal({.parameters = {.contact_stiffness = stiffness}},
                   {"sqrt(contact_stiffness / mass)"});
}

}  // namespace
}  // namespace rotor
