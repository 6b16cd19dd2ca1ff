/// A part of a sweep, which is computed by itself, perhaps on another machine.
#pragma once

#include "figures/sweep/mixed.hpp"

namespace rotor {

/// Points are dealt out one by one, because neighbours take similar times. Each round starts at
/// another part, or a part could have whole columns of a grid. So each part is a sample of all
/// regions, and results are joined by taking rows in turn.
struct Part {
  /// A program may usually read twice as many files at once.
  static constexpr long most = 500;

  long number = 1, of = 1;  ///< the first part is 1; 1 of 1 is the whole sweep

  /// The point in a row of the part, from 0 on: one of each round.
  long point(long row) const { return row * of + (number - 1 + start(row, of)) % of; }
  /// How many of all points the part has.
  long points(long all) const {
    const long rounds = all / of;
    return rounds + (point(rounds) < all ? 1 : 0);
  }
  /// The number of the part that has a point.
  static long with(long point, long of) {
    return (point % of + of - start(point / of, of)) % of + 1;
  }

 private:
  static long start(long round, long of) {
    return static_cast<long>(mixed(static_cast<std::uint64_t>(round)) %
                             static_cast<std::uint64_t>(of));
  }
};

}  // namespace rotor
