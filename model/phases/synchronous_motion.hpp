/// The motion that a rotor's unbalance and weight maintain while its speed changes slowly: what is
/// left of a run-up when all vibration has died out.
///
/// Let the angle theta and the speed W of a rotor be free of ripple: theta' = W, W' = alpha(W).
/// Then the rotor's own angle phi and speed w, and its mass centre C, are
///   phi = theta + 2 atan(kappa / 2),   kappa = Re sum K_n e^(i n theta)
///   w = W + eta,                         eta = Re sum H_n e^(i n theta)
///   O_a C = sum A_n e^(i n theta),  (O_a C)' = sum B_n e^(i n theta),   n = 1, 2
/// with complex functions of W. A_1 is the response to the unbalance, which lags behind a changing
/// speed; the others come from gravity's moment. They are computed term by term in the change of
/// speed per turn, and to the second order of the ripple, as polynomials of W about one speed.
///
/// To subtract this motion from another is an exact change of unknowns, whatever the functions are,
/// as long as theta and W follow from phi and w. The functions need only leave little motion that
/// turns with the rotor.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "model/phases/plane_series.hpp"
#include "model/phases/rotor_system.hpp"

namespace rotor {

template <class S>
class SynchronousMotion {
 public:
  /// None.
  SynchronousMotion() = default;

  /// About a speed, in axes in which gravity has the direction `down`.
  SynchronousMotion(const RotorSystem<S>& rotor, const S& speed, const Vector<S>& down)
      : exists_(true), centre_(speed) {
    using std::abs;
    if (rotor.motor_on) centre_ += range() * abs(speed);
    expand(rotor, down);
  }

  bool exists() const { return exists_; }
  /// Whether the ripple of the angle in radians is less than range().
  bool ripples_little() const { return ripples_little_; }

  /// The relative change of speed for which the polynomials are accurate.
  static S range() { return S(1) / 100; }

  /// Whether the polynomials are accurate at that speed.
  bool holds(const S& speed) const {
    using std::abs, std::max;
    return abs(speed - centre_) <= range() * max<S>(abs(speed), abs(centre_));
  }

  /// Turns the axes by the angle with this cosine and sine.
  void turn_axes(const S& cosine, const S& sine) {
    first_.turn(angle_ripple, cosine, sine);
    first_.turn(speed_ripple, cosine, sine);
    for (const Function f : {displacement, velocity, angle_ripple, speed_ripple})
      second_.turn(f, cosine, sine);
    second_.turn(angle_ripple, cosine, sine);
    second_.turn(speed_ripple, cosine, sine);
  }

  /// Functions of theta and W: O_a C (m), its time derivative (m/s), and those with the real parts
  /// kappa and eta (rad/s).
  enum Function { displacement, velocity, angle_ripple, speed_ripple, functions };

  /// All four of them, in arrays whose loops a compiler packs into registers.
  struct Vectors {
    std::array<S, functions> x, y;

    Vector<S> operator()(Function f) const { return {x[f], y[f]}; }
    S real(Function f) const { return x[f]; }
    friend Vectors quarter_turn(const Vectors& a) {
      Vectors turned;
      turned.y = a.x;
      for (std::size_t f = 0; f < functions; ++f) turned.x[f] = -a.y[f];
      return turned;
    }
    friend Vectors operator+(Vectors a, const Vectors& b) {
      for (std::size_t f = 0; f < functions; ++f) {
        a.x[f] += b.x[f];
        a.y[f] += b.y[f];
      }
      return a;
    }
    /// Adds the next term of a polynomial, for a speed that is x away.
    void add_term(const S& x_away, const Vectors& term) {
      for (std::size_t f = 0; f < functions; ++f) {
        x[f] = term.x[f] + x_away * x[f];
        y[f] = term.y[f] + x_away * y[f];
      }
    }
    friend Vectors product(const Vectors& a, const Vector<S>& b) {
      Vectors all;
      for (std::size_t f = 0; f < functions; ++f) {
        all.x[f] = b.x() * a.x[f] - b.y() * a.y[f];
        all.y[f] = b.y() * a.x[f] + b.x() * a.y[f];
      }
      return all;
    }
  };
  struct Value {
    Vectors value, by_angle, by_speed;
  };

  /// Values at the angle with that direction and a speed W.
  Value at(const Vector<S>& direction, const S& speed) const {
    const auto once = first_.at(speed - centre_, direction);
    if (!has_ripple_) return {once.value, quarter_turn(once.value), once.slope};
    const auto twice = second_.at(speed - centre_, complex_product(direction, direction));
    return {once.value + twice.value, quarter_turn(once.value + twice.value + twice.value),
            once.slope + twice.slope};
  }

  /// Bounds of the motion at a speed, whatever the angle.
  struct Amplitudes {
    S displacement;  ///< of C, m
    S velocity;      ///< of C, m/s
    S speed_ripple;  ///< rad/s
  };
  Amplitudes amplitudes(const S& speed) const {
    const Vectors once = first_.coefficients(speed - centre_);
    const Vectors twice = second_.coefficients(speed - centre_);
    const auto bound = [&](Function f) { return S(once(f).norm() + twice(f).norm()); };
    return {bound(displacement), bound(velocity), bound(speed_ripple)};
  }

 private:
  using Series = PlaneSeries<S>;
  static constexpr std::size_t degree = Series::degree;

  /// A_n, B_n, K_n and H_n as polynomials.
  template <std::size_t Degree>
  class Harmonic {
   public:
    void set(Function f, const Series& series) {
      for (std::size_t n = 0; n <= Degree; ++n) {
        terms_[n].x[f] = series[n].x();
        terms_[n].y[f] = series[n].y();
      }
    }
    void turn(Function f, const S& cosine, const S& sine) {
      for (Vectors& term : terms_) {
        const Vector<S> by = turned(term(f), cosine, sine);
        term.x[f] = by.x();
        term.y[f] = by.y();
      }
    }

    /// At a speed that is x away from the centre.
    Vectors coefficients(const S& x) const {
      Vectors value = terms_[Degree];
      for (std::size_t n = Degree; n-- > 0;) value.add_term(x, terms_[n]);
      return value;
    }

    struct ValueAndSlope {
      Vectors value, slope;
    };
    ValueAndSlope at(const S& x, const Vector<S>& direction) const {
      Vectors value = terms_[Degree], slope{};
      for (std::size_t n = Degree; n-- > 0;) {
        slope.add_term(x, value);
        value.add_term(x, terms_[n]);
      }
      return {product(value, direction), product(slope, direction)};
    }

   private:
    std::array<Vectors, Degree + 1> terms_{};
  };

  /// Time derivatives of functions c(W) as factors of e^(i n theta).
  struct Rate {
    S centre;
    RealSeries<S> alpha{};

    Series operator()(int n, const Series& c) const {
      Series result;
      for (std::size_t j = 0; j <= degree; ++j) {
        Vector<S> by_angle = centre * c[j];
        if (j > 0) by_angle += c[j - 1];
        result[j] = S(n) * rotor::quarter_turn(by_angle);
        for (std::size_t k = 1; k <= degree && k <= j + 1; ++k)
          result[j] += (S(static_cast<double>(k)) * alpha[j + 1 - k]) * c[k];
      }
      return result;
    }
  };

  /// Adds terms until one is negligible, or no longer much smaller than the last: the series is
  /// asymptotic.
  template <class Next>
  static void add_terms(Series& sum, const S& enough, const Next& next) {
    for (S last = sum[0].norm();;) {
      const Series term = next();
      const S size = term[0].norm();
      if (!(size < last / 2)) return;
      sum = sum + term;
      if (size <= enough * sum[0].norm()) return;
      last = size;
    }
  }

  void expand(const RotorSystem<S>& rotor, const Vector<S>& down) {
    using std::sqrt;
    const Weight<S>& weight = rotor.acting.weight;
    const S k = rotor.acting.supports.stiffness, d = rotor.acting.supports.damping;
    const S m = rotor.body.mass;
    const S e = rotor.body.eccentricity, inertia = rotor.body.inertia;
    const S rounding = 100 * std::numeric_limits<S>::epsilon();
    Rate rate{centre_};

    // The response to a force(W) e^(i n theta), and its residual because the speed changes.
    const auto impedance = [&](int n) -> typename Series::Quadratic {
      const S slope = static_cast<S>(n), w = slope * centre_;
      return {Vector<S>(k - m * w * w, d * w), Vector<S>(-2 * m * w * slope, d * slope),
              Vector<S>(-m * slope * slope, 0)};
    };
    const auto lacking = [&](int n, const Series& force, const Series& response) {
      const Series change = rate(n, response);
      return (force - (m * rate(n, change) + d * change + k * response)) / impedance(n);
    };

    const Series force = Series::linear(e * Vector<S>(k, d * centre_), e * Vector<S>(S(0), d));
    Series A = force / impedance(1);
    add_terms(A, rounding, [&] {
      const Series B = rate(1, A);
      for (std::size_t j = 0; j <= degree; ++j)
        rate.alpha[j] = e * (k * A[j].y() + d * B[j].y()) / inertia;
      rate.alpha[0] += rotor.constant_moment() / inertia;
      rate.alpha[0] -= d * e * e * centre_ / inertia;
      rate.alpha[1] -= d * e * e / inertia;
      return lacking(1, force, A);
    });
    first_.set(displacement, A);
    first_.set(velocity, rate(1, A));
    has_ripple_ = weight.gravity != 0;
    if (!has_ripple_) return;

    // Gravity's moment has an arm p e^(i n theta). Its angular acceleration makes the speed ripple,
    // and the speed the angle.
    const auto integral = [&](int n, const Series& g) {
      const typename Series::Quadratic turn = {Vector<S>(0, S(n) * centre_), Vector<S>(0, S(n)),
                                               Vector<S>(0, 0)};
      Series sum = g / turn;
      add_terms(sum, sqrt(rounding), [&] { return (g - rate(n, sum)) / turn; });
      return sum;
    };
    const auto make_ripple = [&](int n, auto& harmonic, const Series& arm) {
      const S pull_down = m * weight.gravity / inertia;
      const Series g = pull_down * (Vector<S>(down.y(), down.x()) * arm);
      Series H = integral(n, g), K = integral(n, H);
      // The moment of the ripple itself: of the damping, and of the springs while C is at rest.
      const S drag = d * e * e / inertia, pull = k * e * e / (2 * inertia);
      H = integral(n, g + pull * K - drag * H);
      K = integral(n, H);
      // K is the ripple of the angle, in radians; that of the speed, relative to it, is n times as
      // large.
      ripples_little_ = ripples_little_ && K[0].norm() < range();
      if (!ripples_little_) return Series();
      harmonic.set(speed_ripple, H);
      harmonic.set(angle_ripple, K);
      return K;
    };
    const bool balanced = weight.balanced_by_springs;
    const Series unbalance = Series::linear(Vector<S>(e, 0), Vector<S>(0, 0));
    const Series K = make_ripple(1, first_, balanced ? unbalance : A);
    // The difference between the unbalance at phi and at theta, and the response to it.
    const Series shift = Vector<S>(0, e / 2) * K;
    const Series force_of_shift = k * shift + d * rate(2, shift);
    Series A2 = force_of_shift / impedance(2);
    add_terms(A2, sqrt(rounding), [&] { return lacking(2, force_of_shift, A2); });
    second_.set(displacement, A2);
    second_.set(velocity, rate(2, A2));
    make_ripple(2, second_, balanced ? shift : A2);
  }

  bool exists_ = false, ripples_little_ = true, has_ripple_ = false;
  S centre_{0};
  Harmonic<degree> first_;
  Harmonic<2> second_;  ///< smaller by the ripple
};

}  // namespace rotor
