/// The quantities that reference-data/problems asks for, of a run by the engine or beside it.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "model/results/summary.hpp"

namespace rotor {

class ProblemObserver : public SummaryObserver {
 public:
  using SummaryObserver::SummaryObserver;
  void on_instant(const Instant& at) override {
    SummaryObserver::on_instant(at);
    if (at.event == Event::touch_down) touch_downs_s_.push_back(at.time_s);
  }

  /// Fixed steps locate no events: of touch-downs they have the first alone.
  std::map<std::string, double> values() const {
    const Summary& s = summary();
    std::map<std::string, double> all = {
        {"touch_downs", static_cast<double>(s.touch_downs)},
        {"final_displacement_m", std::hypot(s.final_q1_m, s.final_q2_m)}};
    for (const SummaryField<double>& field : summary_fields<double>) {
      if (const auto* number = std::get_if<double Summary::*>(&field.value))
        all[std::string(field.key)] = s.**number;
      if (const auto* perhaps = std::get_if<std::optional<double> Summary::*>(&field.value))
        if (const auto& value = s.**perhaps) all[std::string(field.key)] = *value;
    }
    if (s.first_contact_s) all[time_of_touch_down(1)] = *s.first_contact_s;
    for (std::size_t n = 0; n < touch_downs_s_.size(); ++n)
      all[time_of_touch_down(n + 1)] = touch_downs_s_[n];
    return all;
  }
  static std::string time_of_touch_down(std::size_t number) {
    return "touch_down_" + std::to_string(number) + "_s";
  }

 private:
  std::vector<double> touch_downs_s_;
};

}  // namespace rotor
