/// Deals out the points of a sweep in blocks. Their rows come back from anywhere in any order, and
/// go on in the order of the points.
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
  long from, until;  ///< points from the first one up to, but without, the last one
};

class BlockScheduler {
 public:
  /// Takes rows as they become due: those of points up to, but without, that one.
  using Sink = std::function<void(std::string_view rows, long until)>;

  BlockScheduler(long from, long until, Sink sink)
      : next_(from), due_(from), until_(until), sink_(std::move(sink)) {}

  /// The next block, or none if all have been dealt out or it was stopped. Waits while so many are
  /// out that their rows would take too much memory.
  std::optional<Block> next();
  /// The same, but none also where `next` would wait.
  std::optional<Block> next_if_due();

  void take(const Block& block, std::string rows);

  /// Nothing is dealt out any more. The first reason is kept.
  void stop(std::exception_ptr reason);
  void rethrow_if_stopped();

  bool is_dealt_out();  ///< there is no next block, and there will be none
  bool is_finished();   ///< all rows have gone on, or it was stopped

 private:
  static constexpr long block_size = 4, most_out = 16384;

  bool must_wait() const { return next_ - due_ > most_out; }
  std::optional<Block> deal();

  std::mutex mutex_;
  std::condition_variable changed_;
  long next_, due_, until_;
  Sink sink_;
  std::map<long, std::pair<Block, std::string>> early_;  ///< rows that are not due yet
  std::exception_ptr reason_;
};

/// Computes a point's row. Each worker has its own.
using Work = std::function<std::string(long point)>;

/// Lets so many threads work on what is dealt out, until all rows have gone on. `meanwhile` is
/// called again and again by this thread as long as they do. Throws what the work has thrown.
void work(BlockScheduler& scheduler, int threads, const std::function<Work()>& make_worker,
          const std::function<void()>& meanwhile);

/// The rows of a block.
std::string rows_of(const Block& block, const Work& work);

}  // namespace rotor
