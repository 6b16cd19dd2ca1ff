/// Records the columns that are asked for, inside the window that is asked for, as they come.
#pragma once

#include <array>
#include <boost/container/small_vector.hpp>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "figures/data/thinning.hpp"
#include "figures/record/columns.hpp"
#include "model/scenario/observer.hpp"

namespace rotor {

/// As close as a recorded curve is to the motion before it is thinned by the rest, relative to the
/// same.
inline constexpr double sampling = thinning / 2;

/// The part of a run that is recorded: from a given time on, or from the onset of rolling on.
struct Window {
  double from_s = 0;
  bool from_rolling_onset = false;  ///< if so, from_s does not count
  double length_s = std::numeric_limits<double>::infinity();
};

/// Who takes the rows.
using RowSink = std::function<void(std::span<const double>)>;

class Recorder : public Observer {
 public:
  /// Where the motion is known, rows lie so close that halfway between two of them each column is
  /// within `tolerance` of a straight line, relative to its range so far; a 64th of an arc is the
  /// closest.
  Recorder(const Window& window, std::vector<const Column*> columns, const Scenario& scenario,
           double tolerance, RowSink sink);

  void on_instant(const Instant& at) override;
  bool wants_dense_output(const double& from_s, const double& until_s) const override;
  void on_step(const DenseOutput& motion) override;
  double threshold(Extreme of, const double& from_s, const double& until_s) const override;
  void on_maximum(const Maximum& maximum) override;

  long rows() const { return rows_; }

 private:
  using Row = boost::container::small_vector<double, 8>;

  bool contains(double time_s) const;
  Row row(const Instant& at) const;
  void add(const Row& row);
  void note_extremes(const Instant& at);
  /// Rows of a part of a step, after the first and with the last one.
  void sample(const DenseOutput& motion, double from_s, const Row& from, double until_s,
              const Row& until);
  /// Rows between two that are known, where a straight line would miss the motion.
  void refine(const DenseOutput& motion, double from_s, const Row& from, double until_s,
              const Row& until, int depth);
  bool is_straight(const Row& from, const Row& middle, const Row& until) const;

  Window window_;
  bool open_;  ///< whether it is known where the window begins
  std::vector<const Column*> columns_;
  double tolerance_;
  ColumnContext context_;
  RowSink sink_;
  long rows_ = 0;
  std::vector<Instant> maxima_;  ///< in the step that comes next
  Row last_;
  Row least_, greatest_;                         ///< of each column so far
  std::array<double, extreme_count> largest_{};  ///< of each Extreme so far
};

/// Records columns at equal distances in time, as spectra want it.
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
