#include "verification/support/reference_tables.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "figures/data/csv.hpp"

namespace rotor {

std::vector<ReferenceLandmark> reference_run(const std::filesystem::path& table,
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
