#include "figures/record/sampler.hpp"

#include <algorithm>
#include <utility>

namespace rotor {

Sampler::Sampler(double from_s, double until_s, double every_s, std::vector<const Column*> columns,
                 const Scenario& scenario, RowSink sink)
    : from_s_(from_s),
      end_s_(until_s),
      until_s_(until_s + every_s / 1e6),  // which rounding may miss
      every_s_(every_s),
      columns_(std::move(columns)),
      context_(scenario),
      sink_(std::move(sink)) {}

bool Sampler::wants_dense_output(const double& from_s, const double& until_s) const {
  const double time = time_s(next_);
  return time <= until_s_ && from_s <= time && time <= until_s + every_s_ / 1e6;
}

void Sampler::on_step(const DenseOutput& motion) {
  std::vector<double> row(columns_.size());
  for (; wants_dense_output(motion.from_s, motion.until_s); ++next_) {
    const double time = std::min(time_s(next_), end_s_);
    Instant at = motion.at(std::min(time, motion.until_s));
    at.time_s = time;
    View view(at, context_);
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = columns_[i]->value(view);
    sink_(row);
  }
}

}  // namespace rotor
