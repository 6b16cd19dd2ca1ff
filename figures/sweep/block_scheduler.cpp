#include "figures/sweep/block_scheduler.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <thread>
#include <vector>

namespace rotor {

std::optional<Block> BlockScheduler::next() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !must_wait() || reason_; });
  return deal();
}

std::optional<Block> BlockScheduler::next_if_due() {
  const std::lock_guard lock(mutex_);
  return must_wait() ? std::nullopt : deal();
}

std::optional<Block> BlockScheduler::deal() {
  if (next_ == until_ || reason_) return std::nullopt;
  const Block block{next_, std::min(next_ + block_size, until_)};
  next_ = block.until;
  return block;
}

void BlockScheduler::take(const Block& block, std::string rows) {
  const std::lock_guard lock(mutex_);
  early_.emplace(block.from, std::pair(block, std::move(rows)));
  for (auto first = early_.begin(); first != early_.end() && first->first == due_;
       first = early_.erase(first)) {
    due_ = first->second.first.until;
    sink_(first->second.second, due_);
  }
  changed_.notify_all();
}

void BlockScheduler::stop(std::exception_ptr reason) {
  const std::lock_guard lock(mutex_);
  if (!reason_) reason_ = std::move(reason);
  changed_.notify_all();
}

bool BlockScheduler::is_finished() {
  const std::lock_guard lock(mutex_);
  if (reason_) std::rethrow_exception(reason_);
  return due_ == until_;
}

std::string rows_of(const Block& block, const Work& work) {
  std::string rows;
  for (long point = block.from; point < block.until; ++point) rows += work(point);
  return rows;
}

void work(BlockScheduler& scheduler, int threads, const std::function<Work()>& make_worker,
          const std::function<void()>& meanwhile) {
  const auto body = [&] {
    try {
      const Work work = make_worker();
      while (const auto block = scheduler.next()) scheduler.take(*block, rows_of(*block, work));
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
