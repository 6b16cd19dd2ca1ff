/// All that a run of the model reports, as text.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <variant>

#include "figures/runs/run_ups.hpp"
#include "model/results/energy.hpp"
#include "model/results/stop_on.hpp"
#include "verification/support/observers.hpp"

namespace rotor {

/// Lines of a name and numbers: results and costs; then, after a line "energy", works by cause.
inline std::string whole_report(const std::map<std::string, double, std::less<>>& numbers) {
  ScenarioSpec spec;
  spec.equations = Equations::published;
  spec.numbers = numbers;
  const Scenario scenario = scenario_of(spec);
  SummaryObserver summary(scenario);
  EnergyObserver energy(scenario);
  EventRecorder events;
  ObserverGroup all{&summary, &energy, &events};
  const RunEnd end = run(scenario, all);
  std::string text = fmt::format("mass_loss_s {}\nright_hand_sides {}\ncontact_evaluations {}\n",
                                 scenario.parameters.mass_loss_time, end.counters.right_hand_sides,
                                 end.counters.contact_evaluations);
  for (const Instant& at : events.events())
    text += fmt::format("event {} {} {}\n", static_cast<int>(at.event), at.time_s,
                        fmt::join(at.state, " "));
  for (const auto& field : summary_fields<double>)
    std::visit(
        [&](auto of) {
          using Value = std::decay_t<decltype(summary.summary().*of)>;
          text += field.key;
          if constexpr (std::is_same_v<Value, std::optional<double>>)
            text += fmt::format(" {}\n", (summary.summary().*of).value_or(-1));
          else
            text += fmt::format(" {}\n", static_cast<double>(summary.summary().*of));
        },
        field.value);
  StopObserver stop(StopOn::outcome, scenario);
  SummaryObserver until_stop(scenario);
  ObserverGroup both{&stop, &until_stop};
  run(scenario, both);
  text += fmt::format("outcome_where_it_is_decided {}\n",
                      static_cast<int>(until_stop.summary().outcome));
  const EnergyBalance& balance = energy.balance();
  text += "energy\n";
  for (std::size_t i = 0; i < balance.work.loads.size(); ++i)
    text += fmt::format("{} {}\n", EnergyByCause::loads_by_name[i], balance.work.loads[i]);
  return text + fmt::format("kinetic {}\nresidual {}\n", balance.kinetic, balance.residual());
}

}  // namespace rotor
