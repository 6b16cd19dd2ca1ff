/// The balances of energy and angular momentum along whole runs, contacts included.
#include "verification/support/balance.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>

#include "figures/runs/scene.hpp"
#include "model/results/energy.hpp"
#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"
#include "verification/support/law.hpp"
#include "verification/support/short_run.hpp"

namespace rotor {
namespace {

class Figure : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Figure, BalancesEnergyAndAngularMomentumInBothSetsOfEquations) {
  // Five times the worst seen, 1.8e-12: the sum of 40,000 steps with errors of about 1e-14.
  const double accuracy = 1e-11;
  Law energy("balance of energy along each figure's runs, of the greatest energy", accuracy);
  Law momentum("balance of angular momentum along each figure's runs, of the greatest", accuracy);
  for (SceneRun scene_run : read_scene(GetParam()).runs) {
    if (scene_run.scenario.method != Method::event) continue;
    for (const Equations equations : {Equations::published, Equations::corrected}) {
      Scenario& scenario = scene_run.scenario;
      scenario.equations = equations;
      scenario.tolerance = 1e-12;
      BalanceObserver balance(scenario);
      run(scenario, balance);
      energy.expect_left(balance.energy_residual());
      momentum.expect_left(balance.angular_momentum_residual());
    }
  }
}

TEST(ContactLaws, BalanceEnergyAndAngularMomentumInAccidents) {
  Law law("balances with a power law, with and without a dashpot, of the greatest", 1e-11);
  Law by_cause("energy by cause with these laws, of the initial one", 1e-11);
  for (const auto& [exponent, damping] : {std::array{1.5, 1e4}, {1.25, 0.}, {1., 0.}, {2.5, 1e3}}) {
    Scenario scenario = short_run(0.04);
    Parameters& p = scenario.parameters;
    p.contact_exponent = exponent;
    p.reference_indentation = 1e-4;
    p.contact_damping = damping;
    scenario.tolerance = 1e-12;
    BalanceObserver balance(scenario);
    EnergyObserver energy(scenario);
    SummaryObserver summary(scenario);
    ObserverGroup all{&balance, &energy, &summary};
    run(scenario, all);
    EXPECT_GT(summary.summary().touch_downs, 3);
    EXPECT_EQ(summary.summary().outcome, Outcome::rolling);
    law.expect_left(balance.energy_residual());
    law.expect_left(balance.angular_momentum_residual());
    by_cause.expect_left(energy.balance().residual() / energy.balance().initial);
  }
}

std::vector<std::filesystem::path> scenes() {
  std::vector<std::filesystem::path> all;
  for (const auto& [number, scene] : figure_files(ROTOR_SCENES)) all.push_back(scene);
  return all;
}
INSTANTIATE_TEST_SUITE_P(Scenes, Figure, testing::ValuesIn(scenes()),
                         [](const auto& scene) { return scene.param.stem().string(); });

}  // namespace
}  // namespace rotor
