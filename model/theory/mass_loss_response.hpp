/// The motion after a mass loss, as long as the rotor stays clear of the ring, in closed form,
/// which README.md beside this file derives.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "model/mechanics/contact.hpp"
#include "model/mechanics/mass_loss.hpp"

namespace rotor {

class MassLossResponse {
 public:
  using Complex = std::complex<double>;

  /// Throws std::domain_error for supports that do not vibrate: without stiffness, or
  /// with at least critical damping; and for a ring that is off centre.
  MassLossResponse(const Parameters& p, Equations equations, double speed)
      : speed_(speed), clearance_(Ring<double>(p).clearance) {
    const MassLoss<double> loss(p);
    const Supports<double> supports = Supports<double>(p).required_centred();
    const auto steady = [&](const Body<double>& body) {
      const Vector<double> centre = supports.unbalance_response(body, speed);
      return Complex(centre.x() - body.eccentricity, centre.y());
    };
    const State<double> before = {
        steady(loss.before).real(), steady(loss.before).imag(), 0, 0, 0, speed};
    const State<double> after = loss.lose_mass(before, equations);
    const Complex z(after[0], after[1]), rate = Complex(after[3], after[4]) + i * speed * z;
    steady_ = steady(loss.after);
    decay_ = p.support_damping / (2 * loss.after.mass);
    const double stiffness = p.support_stiffness;
    const double square = stiffness / loss.after.mass - decay_ * decay_;
    if (!(square > 0))
      throw std::domain_error(fmt::format(
          "support_stiffness k = {} N/m, support_damping d = {} N s/m: the supports must be able "
          "to vibrate after the mass loss, with k > 0 and a damping ratio d / (2 sqrt(k m)) below 1"
          "{}",
          stiffness, p.support_damping,
          stiffness > 0 ? fmt::format("; it is {:.3g}",
                                      decay_ / natural_frequency(stiffness, loss.after.mass))
                        : ""));
    frequency_ = std::sqrt(square);
    const Complex free = z - steady_, free_rate = rate - i * speed * steady_;
    a_ = (free_rate + (decay_ + i * frequency_) * free) / (2. * i * frequency_);
    b_ = free - a_;
  }

  /// O and its velocity at a time after the loss, in stator axes along the rotor's axes at the
  /// loss.
  Complex position(double t) const { return driven(t) + forward(t) + backward(t); }
  Complex velocity(double t) const {
    return i * speed_ * driven(t) + (i * frequency_ - decay_) * forward(t) -
           (i * frequency_ + decay_) * backward(t);
  }

  double steady() const { return std::abs(steady_); }  ///< limit of |z|, m
  double bound() const { return reach_from(0); }       ///< upper bound of |z|, m

  /// The largest |z|, m, from parabolas through three samples each, whose error is below 1e-4 of it
  /// up to half the critical damping. If damping has not ended the vibration by then, the largest
  /// of 16,000 periods of the faster motion.
  double greatest() const {
    constexpr double none = std::numeric_limits<double>::infinity();  // before the first sample
    // Each sample turns the last: its rounding, 1e-16, adds up to 1e-10.
    std::array<Complex, 3> parts = {driven(0), forward(0), backward(0)};
    const std::array turns = {std::exp(i * speed_ * look()),
                              std::exp((i * frequency_ - decay_) * look()),
                              std::exp(-(i * frequency_ + decay_) * look())};
    const double decay = std::exp(-decay_ * look());
    double found = steady(), last = none, here = std::abs(position(0)), swing = bound() - steady();
    for (long n = 0; n < most_looks && steady() + swing > (1 + 1e-5) * found; ++n) {
      Complex z = 0;
      for (std::size_t k = 0; k < parts.size(); ++k) z += parts[k] *= turns[k];
      swing *= decay;
      const double next = std::abs(z), bend = 2 * here - last - next;
      const bool is_peak = here >= last && here >= next && bend > 0;
      found = std::max(found, is_peak ? here + (next - last) * (next - last) / (8 * bend) : here);
      last = here;
      here = next;
    }
    return found;
  }

  /// When |z| reaches the clearance for the first time, if it does within so many periods, s. A
  /// contact that is over between two samples, 64 per period of the faster motion, is missed.
  std::optional<double> first_contact() const {
    const auto gap = [&](double t) { return clearance_ - std::abs(position(t)); };
    double clear = 0;
    for (long n = 0; gap(clear + look()) > 0; ++n) {
      clear += look();
      if (n == most_looks || reach_from(clear) < clearance_) return std::nullopt;
    }
    double touching = clear + look();
    for (int halving = 0; halving < 50; ++halving) {
      const double middle = (clear + touching) / 2;
      (gap(middle) > 0 ? clear : touching) = middle;
    }
    return touching;
  }

 private:
  static constexpr Complex i{0, 1};
  static constexpr long most_looks = 1 << 20;

  Complex driven(double t) const { return steady_ * std::exp(i * speed_ * t); }
  Complex forward(double t) const { return a_ * std::exp((i * frequency_ - decay_) * t); }
  Complex backward(double t) const { return b_ * std::exp(-(i * frequency_ + decay_) * t); }
  double reach_from(double t) const {
    return steady() + (std::abs(a_) + std::abs(b_)) * std::exp(-decay_ * t);
  }
  /// A sixty-fourth of a period of the faster motion, s.
  double look() const { return std::numbers::pi / 32 / std::max(speed_, frequency_); }

  double speed_, clearance_;
  Complex steady_, a_, b_;
  double decay_, frequency_;
};

}  // namespace rotor
