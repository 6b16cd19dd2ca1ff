/// Records columns at equal distances in time, as spectra want it.
#pragma once

#include <vector>

#include "figures/record/recorder.hpp"

namespace rotor {

class Sampler : public Observer {
 public:
  /// A row every `every_s` seconds from `from_s` on, and at `until_s` if the distance meets it. The
  /// run has to have a dense output.
  Sampler(double from_s, double until_s, double every_s, std::vector<const Column*> columns,
          const Scenario& scenario, RowSink sink);

  bool wants_dense_output(const double& from_s, const double& until_s) const override;
  void on_step(const DenseOutput& motion) override;

  long rows() const { return next_; }

 private:
  double time_s(long row) const { return from_s_ + static_cast<double>(row) * every_s_; }

  double from_s_, end_s_, until_s_, every_s_;
  std::vector<const Column*> columns_;
  ColumnContext context_;
  RowSink sink_;
  long next_ = 0;  ///< row
};

}  // namespace rotor
