/// A run whose balances are kept.
#pragma once

#include "verification/support/balance.hpp"
#include "verification/support/follow.hpp"

namespace rotor {

/// A run from an instant to a time, its events and its balances.
class BalancedRun : public BalanceObserver {
 public:
  BalancedRun(const Scenario& scenario, const Instant& from, double until_s)
      : BalanceObserver(scenario) {
    counters_ = follow(scenario, from, until_s, *this).counters;
  }

  void on_instant(const Instant& at) override {
    BalanceObserver::on_instant(at);
    events_.on_instant(at);
  }

  long count(Event kind) const { return events_.count(kind); }
  const Instant& last() const { return events_.last(); }
  const Counters& counters() const { return counters_; }

 private:
  EventRecorder events_;
  Counters counters_;
};

}  // namespace rotor
