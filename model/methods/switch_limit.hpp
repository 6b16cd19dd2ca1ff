/// A limit that a run exceeds only if something is wrong.
#pragma once

namespace rotor {

/// Detects a run that makes no progress: it switches between phases more often than a motion can.
template <class S>
class SwitchLimit {
 public:
  static constexpr int most = 1000;  ///< per shortest natural period

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
