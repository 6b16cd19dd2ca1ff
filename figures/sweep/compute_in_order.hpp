/// Computes rows on several threads, and passes them on in the order of their points.
#pragma once

#include <functional>
#include <string>

namespace rotor {

/// Computes the row of a point. Each thread has its own.
using Work = std::function<std::string(long point)>;

/// The rows of the points from `first` up to, but without, `until`. `take` is called by one thread
/// at a time; this thread calls `meanwhile` repeatedly. Throws what the work or `take` throws,
/// after which no further row is passed on.
void compute_in_order(
    long first, long until, int threads, const std::function<Work()>& make_work,
    const std::function<void(const std::string& row)>& take,
    const std::function<void()>& meanwhile = [] {});

}  // namespace rotor
