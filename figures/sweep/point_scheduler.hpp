/// Distributes the points of a sweep. Their rows may return in any order, and are passed on at
/// once.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace rotor {

/// Which points are done: all before the first missing one, and some after it.
class DonePoints {
 public:
  long first_missing() const { return first_missing_; }
  long count() const { return first_missing_ + static_cast<long>(later_.size()); }
  bool has(long point) const { return point < first_missing_ || later_.contains(point); }

  void add(long point) {
    later_.insert(point);
    while (later_.erase(first_missing_) > 0) ++first_missing_;
  }

 private:
  long first_missing_ = 0;
  std::set<long> later_;
};

class PointScheduler {
 public:
  using Sink = std::function<void(long point, std::string_view row)>;

  /// For the points up to, but without, `until` that are not done.
  PointScheduler(DonePoints done, long until, Sink sink)
      : done_(std::move(done)), until_(until), sink_(std::move(sink)) {}

  /// The next point, or none if all have been distributed or it was stopped. Waits while too many
  /// rows are done after a missing one: whoever sorts them has to keep them in memory.
  std::optional<long> next();
  /// The same, but returns none instead of waiting.
  std::optional<long> next_if_due();

  void take(long point, std::string_view row);

  /// Distributes no further points. Keeps the first reason.
  void stop(std::exception_ptr reason);

  /// Whether all rows have been passed on. Throws the reason if it was stopped.
  bool is_finished();

 private:
  static constexpr long most_out = 16384;

  bool must_wait() const { return next_ - done_.first_missing() > most_out; }
  std::optional<long> deal();

  std::mutex mutex_;
  std::condition_variable changed_;
  DonePoints done_;
  long next_ = 0, until_;
  Sink sink_;
  std::exception_ptr reason_;
};

/// Computes the row of a point. Each worker has its own.
using Work = std::function<std::string(long point)>;

/// Lets threads work on the points until all rows have been passed on. This thread calls
/// `meanwhile` repeatedly until then. Throws what the work has thrown.
void work(PointScheduler& scheduler, int threads, const std::function<Work()>& make_worker,
          const std::function<void()>& meanwhile);

}  // namespace rotor
