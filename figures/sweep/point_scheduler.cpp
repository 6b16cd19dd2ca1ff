#include "figures/sweep/point_scheduler.hpp"

#include <chrono>
#include <system_error>
#include <thread>
#include <vector>

namespace rotor {

std::optional<long> PointScheduler::next() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !must_wait() || reason_; });
  return deal();
}

std::optional<long> PointScheduler::next_if_due() {
  const std::lock_guard lock(mutex_);
  return must_wait() ? std::nullopt : deal();
}

std::optional<long> PointScheduler::deal() {
  while (next_ < until_ && done_.has(next_)) ++next_;
  if (next_ == until_ || reason_) return std::nullopt;
  return next_++;
}

void PointScheduler::take(long point, std::string_view row) {
  const std::lock_guard lock(mutex_);
  sink_(point, row);
  done_.add(point);
  changed_.notify_all();
}

void PointScheduler::stop(std::exception_ptr reason) {
  const std::lock_guard lock(mutex_);
  if (!reason_) reason_ = std::move(reason);
  changed_.notify_all();
}

bool PointScheduler::is_finished() {
  const std::lock_guard lock(mutex_);
  if (reason_) std::rethrow_exception(reason_);
  return done_.first_missing() == until_;
}

void work(PointScheduler& scheduler, int threads, const std::function<Work()>& make_worker,
          const std::function<void()>& meanwhile) {
  const auto body = [&] {
    try {
      const Work work = make_worker();
      while (const auto point = scheduler.next()) scheduler.take(*point, work(*point));
    } catch (...) {
      scheduler.stop(std::current_exception());
    }
  };
  std::vector<std::thread> all;
  try {
    while (static_cast<int>(all.size()) < threads) all.emplace_back(body);
  } catch (const std::system_error&) {  // no more threads
    if (all.empty()) scheduler.stop(std::current_exception());
  }
  std::exception_ptr reason;
  try {
    while (!scheduler.is_finished()) {
      meanwhile();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  } catch (...) {
    reason = std::current_exception();
    scheduler.stop(reason);
  }
  for (std::thread& thread : all) thread.join();
  if (reason) std::rethrow_exception(reason);
}

}  // namespace rotor
