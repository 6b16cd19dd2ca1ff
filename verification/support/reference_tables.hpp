/// The high-precision results in reference-data/.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

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
std::vector<ReferenceLandmark> reference_run(const std::filesystem::path& table,
                                             std::string_view name);

}  // namespace rotor
