/// Runs that stop at their outcome against whole runs.
#pragma once

#include "figures/results/run_result.hpp"

namespace rotor {

/// The first result that a stopped run reports, and the whole run differently; empty if none.
inline std::string contradiction(const RunResult& stopped, const RunResult& whole) {
  const Json reported = to_json(stopped), all = to_json(whole);
  for (const auto& field : summary_fields<double>) {
    const std::string key(field.key);
    if (field.scale != ErrorScale::exact && !reported[key].is_null() && reported[key] != all[key])
      return key;
  }
  return "";
}

}  // namespace rotor
