/// Several observers of one run.
#pragma once

#include <algorithm>
#include <vector>

#include "model/instant.hpp"

namespace rotor {

/// Several observers as one.
class Audience : public Observer {
 public:
  void add(Observer& observer) { all_.push_back(&observer); }
  void add(const Audience& audience) {
    all_.insert(all_.end(), audience.all_.begin(), audience.all_.end());
  }

  void see(const Instant& at) override {
    for (Observer* observer : all_) observer->see(at);
  }
  void see(const Piece& piece) override {
    for (Observer* observer : all_)
      if (observer->wants_pieces(piece.from_s, piece.until_s)) observer->see(piece);
  }
  bool wants_pieces(const double& from_s, const double& until_s) const override {
    return std::ranges::any_of(
        all_, [&](const Observer* observer) { return observer->wants_pieces(from_s, until_s); });
  }
  bool wants(Extreme of, const double& bound, const double& from_s,
             const double& until_s) const override {
    return std::ranges::any_of(all_, [&](const Observer* observer) {
      return observer->wants(of, bound, from_s, until_s);
    });
  }

 private:
  std::vector<Observer*> all_;
};

}  // namespace rotor
