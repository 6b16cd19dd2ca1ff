/// Several observers of one run.
#pragma once

#include <algorithm>
#include <vector>

#include "model/scenario/observer.hpp"

namespace rotor {

/// Several observers as one. Each is shown what it would be shown on its own.
class ObserverGroup : public Observer {
 public:
  void add(Observer& observer) { all_.push_back(&observer); }
  void add(const ObserverGroup& observers) {
    all_.insert(all_.end(), observers.all_.begin(), observers.all_.end());
  }

  void on_instant(const Instant& at) override {
    for (Observer* observer : all_) observer->on_instant(at);
  }

  bool goes_on(const Progress& now) override {
    bool all = true;
    for (Observer* observer : all_) all = observer->goes_on(now) && all;
    return all;
  }

  bool wants_dense_output(const double& from_s, const double& until_s) const override {
    return std::any_of(all_.begin(), all_.end(), [&](const Observer* observer) {
      return observer->wants_dense_output(from_s, until_s);
    });
  }
  void on_step(const DenseOutput& step) override {
    for (Observer* observer : all_)
      if (observer->wants_dense_output(step.from_s, step.until_s)) observer->on_step(step);
  }

  double threshold(Extreme of, const double& from_s, const double& until_s) const override {
    double least = Observer::threshold(of, from_s, until_s);
    for (const Observer* observer : all_)
      least = std::min(least, observer->threshold(of, from_s, until_s));
    return least;
  }
  void on_maximum(const Maximum& maximum) override {
    for (Observer* observer : all_)
      if (maximum.bound > observer->threshold(maximum.of, maximum.at.time_s, maximum.at.time_s))
        observer->on_maximum(maximum);
  }

 private:
  std::vector<Observer*> all_;
};

}  // namespace rotor
