/// Observed orders of convergence, of both methods, where the motion is smooth and across contacts.
#include <gtest/gtest.h>

#include "model/methods/published_method.hpp"
#include "model/results/summary.hpp"
#include "verification/support/follow_with.hpp"
#include "verification/support/observers.hpp"

namespace rotor {
namespace {

double distance(const State<double>& a, const State<double>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// The rotor just after its mass loss at 29.1 s.
Instant after_loss() { return after_mass_loss_with<double>(Scenario{}, 1e-13); }

State<double> by_fixed_steps(const Instant& from, double until_s, double step) {
  const Scenario scenario{.method = Method::rk4, .step_rub = step};
  PublishedMethod method(scenario, from);
  method.advance(until_s, nobody);
  return method.instant().state;
}

RunEnd by_events(const Instant& from, double until_s, double tolerance) {
  return follow_with<double>(Scenario{}, tolerance, from, until_s, nobody);
}

State<double> exact(const Instant& from, double until_s) {
  return by_events(from, until_s, 1e-13).last.state;
}

TEST(Convergence, ThePublishedMethodIsOfFourthOrderInFreeFlight) {
  const Instant from = after_loss();
  const double until_s = 29.104;  // before the first contact
  const State<double> reference = exact(from, until_s);
  const double coarse = distance(by_fixed_steps(from, until_s, 4e-4), reference);
  const double fine = distance(by_fixed_steps(from, until_s, 1e-4), reference);
  EXPECT_GT(std::log2(coarse / fine) / 2 + 0.1, 4);  // it may do better
}

TEST(Convergence, ThePublishedMethodFallsToFirstOrderAtAContact) {
  const Instant from = after_loss();
  const double until_s = 29.106;  // after the first contact
  const State<double> reference = exact(from, until_s);
  // The position of the contact within a step is random: averages over eight nearby steps, six
  // halvings apart.
  const auto mean_error = [&](double step) {
    double sum = 0;
    for (int i = 0; i < 8; ++i)
      sum += std::log(distance(by_fixed_steps(from, until_s, step * (1 + 0.01 * i)), reference));
    return std::exp(sum / 8);
  };
  const double order = std::log2(mean_error(5e-6) / mean_error(5e-6 / 64)) / 6;
  EXPECT_GT(order, 0.7);
  EXPECT_LT(order, 1.6);
}

TEST(Convergence, TheEventMethodKeepsAHighOrderAcrossSevenContactsAndTheOnsetOfRolling) {
  const Instant from = after_loss();
  const double until_s = 29.13;
  const State<double> reference = exact(from, until_s);
  const RunEnd coarse = by_events(from, until_s, 1e-5), fine = by_events(from, until_s, 1e-10);
  const double error_coarse = distance(coarse.last.state, reference);
  const double error_fine = distance(fine.last.state, reference);
  // Counts only steps: the cost of locating events does not depend on the tolerance.
  EXPECT_GT(
      std::log(error_coarse / error_fine) / std::log(static_cast<double>(fine.counters.steps) /
                                                     static_cast<double>(coarse.counters.steps)),
      7);
}

TEST(Convergence, TheDiscretisationErrorOfThePublishedLandmarksIsThatOfFirstOrder) {
  const Instant from = after_loss();
  const auto summary = [&](Method method, double step) {
    Scenario scenario{.method = method, .tolerance = 1e-12, .step_rub = step};
    scenario.until = 29.14;
    SummaryObserver observer(scenario);
    run(scenario, from, observer);
    return observer.summary();
  };
  const Summary exact_one = summary(Method::event, 1);
  constexpr double step = 5e-6, finer = 64;
  const Summary published = summary(Method::rk4, step), fine = summary(Method::rk4, step / finer);
  const auto peak_error = [&](const Summary& s) {
    return std::abs(*s.peak_normal_force_N / *exact_one.peak_normal_force_N - 1);
  };
  const auto onset_error_s = [&](const Summary& s) {
    return std::abs(*s.rolling_onset_s - *exact_one.rolling_onset_s);
  };
  EXPECT_LT(peak_error(published), 2e-3);  // measured: 1.1e-3
  EXPECT_LT(onset_error_s(published), 5 * step);
  EXPECT_NEAR(*published.first_contact_s, *exact_one.first_contact_s, step);
  EXPECT_NEAR(std::log(peak_error(published) / peak_error(fine)) / std::log(finer), 1, 0.3);
  EXPECT_LT(onset_error_s(fine), onset_error_s(published) / 4);  // as the grid has it
}

}  // namespace
}  // namespace rotor
