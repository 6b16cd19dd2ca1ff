/// The high-precision results in reference-data/.
#pragma once

#include <fmt/format.h>

#include <stdexcept>

#include "figures/data/read_csv.hpp"
#include "model/mechanics/rotating_frame.hpp"

namespace rotor {

/// An event of a run, or its end.
struct ReferenceLandmark {
  std::string kind;  ///< the event's name, or "end"
  long double time_s{};
  State<long double> state{};
  double time_error_s{}, state_error{};  ///< relative to what the file's header says
};

/// The landmarks of one run, in their order. Throws std::runtime_error if there is no such run.
inline std::vector<ReferenceLandmark> reference_run(const std::filesystem::path& table,
                                                    std::string_view name) {
  std::vector<ReferenceLandmark> landmarks;
  for (const CsvRow& row : read_csv(table)) {
    if (row["run"] != name) continue;
    landmarks.push_back({.kind = row["landmark"],
                         .time_s = row.number("time_s"),
                         .state = {row.number("q1_m"), row.number("q2_m"), row.number("q3_rad"),
                                   row.number("q1_rate_m_per_s"), row.number("q2_rate_m_per_s"),
                                   row.number("q3_rate_rad_per_s")},
                         .time_error_s = static_cast<double>(row.number("time_error_s")),
                         .state_error = static_cast<double>(row.number("state_error"))});
  }
  if (landmarks.empty())
    throw std::runtime_error(fmt::format("{} has no run \"{}\"", table.string(), name));
  return landmarks;
}

}  // namespace rotor
