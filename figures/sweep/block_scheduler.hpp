/// Distributes the points of a sweep in blocks. Their rows may return in any order, and are passed
/// on in the order of the points.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace rotor {

struct Block {
  long from, until;  ///< points from the first one up to, but without, `until`
};

class BlockScheduler {
 public:
  /// Receives rows in order: those of points up to, but without, `until`.
  using Sink = std::function<void(std::string_view rows, long until)>;

  BlockScheduler(long from, long until, Sink sink)
      : next_(from), due_(from), until_(until), sink_(std::move(sink)) {}

  /// The next block, or none if all have been distributed or it was stopped. Waits while the rows
  /// of unfinished blocks would take too much memory.
  std::optional<Block> next();
  /// The same, but returns none instead of waiting.
  std::optional<Block> next_if_due();

  void take(const Block& block, std::string rows);

  /// Distributes no further blocks. Keeps the first reason.
  void stop(std::exception_ptr reason);

  /// Whether all rows have been passed on. Throws the reason if it was stopped.
  bool is_finished();

 private:
  static constexpr long block_size = 4, most_out = 16384;

  bool must_wait() const { return next_ - due_ > most_out; }
  std::optional<Block> deal();

  std::mutex mutex_;
  std::condition_variable changed_;
  long next_, due_, until_;
  Sink sink_;
  std::map<long, std::pair<Block, std::string>> early_;  ///< rows that must wait for earlier ones
  std::exception_ptr reason_;
};

/// Computes the row of a point. Each worker has its own.
using Work = std::function<std::string(long point)>;

/// Lets threads work on the blocks until all rows have been passed on. This thread calls
/// `meanwhile` repeatedly until then. Throws what the work has thrown.
void work(BlockScheduler& scheduler, int threads, const std::function<Work()>& make_worker,
          const std::function<void()>& meanwhile);

/// The rows of a block.
std::string rows_of(const Block& block, const Work& work);

}  // namespace rotor
