/// A limit that only a run in trouble exceeds.
#pragma once

namespace rotor {

/// Tells a run that gets nowhere: one that switches between phases more often than a motion can.
template <class S>
class SwitchLimit {
 public:
  static constexpr int most = 1000;  ///< within the shortest natural period

  void restart(const S& time) {
    since_ = time;
    switches_ = 0;
  }

  /// Whether one more switch is too many.
  bool exceeded(const S& time, const S& period) {
    if (time - since_ > period) restart(time);
    return ++switches_ > most;
  }

 private:
  S since_{0};
  int switches_ = 0;
};

}  // namespace rotor
