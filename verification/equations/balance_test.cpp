/// The balances of energy and angular momentum along whole runs, contacts included.
#include "verification/support/balance.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "figures/runs/scene.hpp"
#include "model/run/simulation.hpp"
#include "verification/support/law.hpp"

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
    for (const Equations equations : {Equations::published, Equations::consistent}) {
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

std::vector<std::filesystem::path> scenes() {
  std::vector<std::filesystem::path> all;
  for (const auto& [number, scene] : figure_files(ROTOR_SCENES)) all.push_back(scene);
  return all;
}
INSTANTIATE_TEST_SUITE_P(Scenes, Figure, testing::ValuesIn(scenes()),
                         [](const auto& scene) { return scene.param.stem().string(); });

}  // namespace
}  // namespace rotor
