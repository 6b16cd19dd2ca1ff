#include "figures/sweep/compute_in_order.hpp"

#include <chrono>
#include <condition_variable>
#include <future>
#include <map>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace rotor {
namespace {

/// Points to compute, and rows that wait for earlier ones.
class Queue {
 public:
  Queue(long first, long until, const std::function<void(const std::string&)>& take)
      : next_(first), passed_on_(first), until_(until), take_(take) {}

  /// The next point; none if all have been taken, or after a failure.
  std::optional<long> next() {
    constexpr long most_waiting = 4096;            // rows, which are in memory
    constexpr std::size_t most_bytes = 1U << 28U;  // of them
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] {
      return (next_ - passed_on_ < most_waiting && bytes_ < most_bytes) || has_failed_;
    });
    if (next_ == until_ || has_failed_) return std::nullopt;
    return next_++;
  }

  void put(long point, std::string row) {
    const std::lock_guard lock(mutex_);
    bytes_ += row.size();
    waiting_.emplace(point, std::move(row));
    for (; !has_failed_ && waiting_.contains(passed_on_); ++passed_on_) {
      const std::string next = waiting_.extract(passed_on_).mapped();
      bytes_ -= next.size();
      take_(next);
    }
    changed_.notify_all();
  }

  void fail() {
    const std::lock_guard lock(mutex_);
    has_failed_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  long next_, passed_on_, until_;
  const std::function<void(const std::string&)>& take_;
  std::map<long, std::string> waiting_;
  std::size_t bytes_ = 0;  ///< of those that wait
  bool has_failed_ = false;
};

}  // namespace

void compute_in_order(long first, long until, int threads, const std::function<Work()>& make_work,
                      const std::function<void(const std::string& row)>& take,
                      const std::function<void()>& meanwhile) {
  Queue queue(first, until, take);
  const auto work_on = [&] {
    try {
      const Work work = make_work();
      while (const auto point = queue.next()) queue.put(*point, work(*point));
    } catch (...) {
      queue.fail();
      throw;
    }
  };
  std::vector<std::future<void>> all;
  try {
    while (static_cast<int>(all.size()) < threads)
      all.push_back(std::async(std::launch::async, work_on));
  } catch (const std::system_error&) {  // no more threads
    if (all.empty()) throw;
  }
  for (const std::future<void>& one : all)
    while (one.wait_for(std::chrono::milliseconds(10)) != std::future_status::ready) meanwhile();
  for (std::future<void>& one : all) one.get();
}

}  // namespace rotor
