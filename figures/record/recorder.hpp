/// Records columns of a run within a window, row by row.
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

/// Largest distance of a recorded curve from the motion, relative to its range. Thinning may add
/// the rest of its tolerance.
inline constexpr double sampling = thinning / 2;

/// The part of a run that is recorded: from a given time on, or from the onset of rolling on.
struct Window {
  double from_s = 0;
  bool from_rolling_onset = false;  ///< instead of from_s
  double length_s = std::numeric_limits<double>::infinity();
};

using RowSink = std::function<void(std::span<const double>)>;

class Recorder : public Observer {
 public:
  /// Where the motion between steps is known, rows are so close that halfway between two of them
  /// each column is within `tolerance` of a straight line, relative to its range so far; the least
  /// distance is a 64th of an arc.
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
  /// Adds rows of a part of a step, without its first and with its last one.
  void sample(const DenseOutput& motion, double from_s, const Row& from, double until_s,
              const Row& until);
  /// Adds rows between two others where a straight line would be too far from the motion.
  void refine(const DenseOutput& motion, double from_s, const Row& from, double until_s,
              const Row& until, int depth);
  bool is_straight(const Row& from, const Row& middle, const Row& until) const;

  Window window_;
  bool open_;  ///< whether the start of the window is known
  std::vector<const Column*> columns_;
  double tolerance_;
  ColumnContext context_;
  RowSink sink_;
  long rows_ = 0;
  std::vector<Instant> maxima_;  ///< of the next step
  Row last_;
  Row least_, greatest_;                         ///< of each column so far
  std::array<double, extreme_count> largest_{};  ///< of each Extreme so far
};

/// Records columns at equal intervals of time, as spectra need them.
class Sampler : public Observer {
 public:
  /// A row every `every_s` seconds from `from_s` to `until_s`, which is included if it is reached.
  /// The run must have a dense output.
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
  long next_ = 0;  ///< number of the next row
};

}  // namespace rotor
