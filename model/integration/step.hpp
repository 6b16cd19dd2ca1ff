/// Steps of an Odeint error stepper over a smooth autonomous system: their error, their dense
/// output, and the first event in them. Independent of the rotor.
#pragma once

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <cmath>
#include <concepts>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "model/integration/crossing.hpp"
#include "model/integration/hermite.hpp"

namespace rotor {

/// The unknowns at a time after the start of a step.
template <class S, class Unknowns_>
struct Point {
  using Unknowns = Unknowns_;
  S time{};
  Unknowns x{}, rates{};

  /// The unknowns some time later along the tangent.
  Unknowns ahead(const S& by) const {
    Unknowns later = x;
    for (std::size_t i = 0; i < later.size(); ++i) later[i] += by * rates[i];
    return later;
  }
};

/// What is known about an event function over a whole step.
template <class S>
struct EventBound {
  bool stays_positive = false;
  std::optional<S> curvature{};  ///< bound on its second derivative
};

/// A smooth autonomous system with event functions; an event is where one becomes negative.
template <class T, class S, class Unknowns = typename T::Unknowns>
concept SystemOf = requires(const T& system, const Unknowns& x, Unknowns& rates, const S& time,
                            const Point<S, Unknowns>& at, std::size_t i) {
  system(x, rates, time);
  { system.scale(x) } -> std::same_as<Unknowns>;  // sizes to which errors are relative
  { T::event_count } -> std::convertible_to<std::size_t>;
  { system.event(i, x) } -> std::same_as<S>;  // for i below their number
  { system.bounds(at, at).events[i] } -> std::convertible_to<EventBound<S>>;  // known beforehand
};

/// An error stepper of Odeint. It steps from x, whose rates are known, to a time later, and
/// estimates the errors, which are proportional to that power of the step's length.
template <class T, class S, class State = typename T::state_type>
concept StepperOf = requires(T stepper, void (*system)(const State&, State&, S), const State& x,
                             const State& rates, const S& time, State& later, State& errors) {
  stepper.do_step(system, x, rates, time, later, time, errors);
  { T::stepper_order_value } -> std::convertible_to<double>;
};

/// Takes steps and estimates their errors relative to what is allowed: the tolerance times the
/// system's scale, plus rounding.
template <class S, StepperOf<S> Stepper>
class ErrorControl {
 public:
  using Unknowns = typename Stepper::state_type;
  using Point = rotor::Point<S, Unknowns>;

  explicit ErrorControl(const S& tolerance) : tolerance_(tolerance) {}

  const S& tolerance() const { return tolerance_; }

  /// Steps from one point to the time of another and sets its unknowns. Returns the error, infinite
  /// if the motion is not finite.
  template <SystemOf<S> System>
  double step(const System& system, const Point& from, Point& to) {
    using std::abs;
    Unknowns errors;
    stepper_.do_step(std::cref(system), from.x, from.rates, S(0), to.x, S(to.time - from.time),
                     errors);
    const Unknowns scale = system.scale(from.x);
    const S rounding = 32 * std::numeric_limits<S>::epsilon();  // of the sums in a step
    double largest = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const S allowed = scale[i] * tolerance_ + rounding * abs(to.x[i]);
      const auto error = static_cast<double>(S(abs(errors[i]) / allowed));
      if (std::isnan(error)) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, error);
    }
    return largest;
  }

  /// The length of the next step, relative to a step with this error.
  static double step_factor(double error) {
    constexpr double safety = 0.9, least = 0.2, most = 4;
    if (!(error < std::numeric_limits<double>::infinity())) return least;
    constexpr int order = Stepper::stepper_order_value;
    const double root = order == 8 ? std::sqrt(std::sqrt(std::sqrt(error)))  // which is cheap
                                   : std::pow(error, 1. / order);
    return std::clamp(safety / root, least, most);
  }

 private:
  S tolerance_;
  Stepper stepper_{};
};

/// A step that has been taken, to its end or to where an event stops it. Keeps references to its
/// start and its end.
template <class S, StepperOf<S> Stepper, SystemOf<S> System>
class Step {
 public:
  using Control = ErrorControl<S, Stepper>;
  using Unknowns = typename Control::Unknowns;
  using Point = typename Control::Point;
  using DenseOutput = HermitePolynomial<S, Unknowns, 4>;
  using Bounds =
      decltype(std::declval<System>().bounds(std::declval<Point>(), std::declval<Point>()));

  /// Times count from the start of the step.
  Step(Control& control, const System& system, const Point& start, const Point& end)
      : control_(control), system_(system), start_(start), end_(end), stop_(end) {}

  const System& system() const { return system_; }
  const Point& start() const { return start_; }
  const Point& stop() const { return stop_; }
  void stop_at(const Point& point) { stop_ = point; }

  /// What the system knows about the step beforehand.
  const Bounds& bounds() {
    if (!bounds_) bounds_.emplace(system_.bounds(start_, end_));
    return *bounds_;
  }

  /// The polynomial through both ends and two points between them, as accurate as the step. Each of
  /// the two costs a step, unless it is the stop.
  const DenseOutput& dense_output() {
    if (dense_output_) return *dense_output_;
    if (is_inside(stop_.time))
      return dense_output_.emplace(curve(start_, step(start_, stop_.time / 2), stop_, end_));
    const Point third = step(start_, end_.time / 3);
    return dense_output_.emplace(curve(start_, third, step(third, end_.time * 2 / 3), end_));
  }

  Point at(const S& time) {
    using std::abs;
    const S rounding = 4 * std::numeric_limits<S>::epsilon();  // of times since the run began
    if (abs(time - end_.time) <= rounding * end_.time) return end_;
    Point point{.time = time, .x = dense_output()(time)};
    system_(point.x, point.rates, S(0));
    return point;
  }

  /// The time over which slopes are taken as differences.
  S look_ahead() const {
    using std::sqrt;
    return end_.time * sqrt(std::numeric_limits<S>::epsilon());
  }

  /// value(x) at a point, with its slope along the motion.
  template <class Value>
  ValueAndSlope<S> observe(const Value& value, const Point& at) const {
    const S here = value(at.x), later = value(at.ahead(look_ahead()));
    return {at.time, here, (later - here) / look_ahead()};
  }

  /// The same at a time on a curve such as the dense output.
  template <class Value, class Curve>
  ValueAndSlope<S> observe(const Value& value, const Curve& curve, const S& time) const {
    const S here = value(curve(time)), later = value(curve(time + look_ahead()));
    return {time, here, (later - here) / look_ahead()};
  }

  /// Where value(x) first becomes negative between two times, if it does. `curvature` bounds its
  /// second derivative, if a bound is known.
  template <class Value>
  std::optional<Point> crossing(const Value& value, const ValueAndSlope<S>& from,
                                const ValueAndSlope<S>& until,
                                const std::optional<S>& curvature = std::nullopt) {
    const auto first_on = [&](const auto& on, const std::optional<S>& bound) {
      return first_crossing(from, until, look_ahead(), bound,
                            [&](const S& time) { return observe(value, on, time); });
    };
    const auto found = [&](const S& time, const Point& near) -> Point {
      if (time == 0) return start_;
      return polished(step_past(near, time), value, from.time, until.time);
    };
    // If there must be a crossing, the curve through both ends shows nearly where; the curve
    // through a third point there shows which crossing is the first.
    if (until.value < 0)
      if (const auto guess = first_on(curve(start_, end_), std::nullopt);
          guess && is_inside(*guess)) {
        const Point near = step(start_, *guess);
        if (const auto time = first_on(curve(start_, near, end_), curvature))
          return found(*time, near);
      }
    // Otherwise the dense output is searched, which costs two steps.
    const auto time = first_on([this](const S& at) { return dense_output()(at); }, curvature);
    return time ? std::optional(found(*time, start_)) : std::nullopt;
  }

 private:
  /// The polynomial through points of the step.
  template <class... Points>
  static auto curve(const Points&... points) {
    return HermitePolynomial<S, Unknowns, sizeof...(points)>(std::array{points...});
  }

  /// Whether a time is far enough from both ends for a polynomial through all three.
  bool is_inside(const S& time) const {
    return 64 * time > end_.time && 64 * time < 63 * end_.time;
  }

  Point step(const Point& from, const S& time) {
    Point to{.time = time};
    control_.step(system_, from, to);
    system_(to.x, to.rates, S(0));
    return to;
  }

  /// The point at a time. From one so near to it, an error of fifth order in the way is far below
  /// the tolerance, and a fourth-order step costs a third.
  Point step_past(const Point& near, const S& time) {
    using std::abs, std::pow;
    const S way = time - near.time;
    if (abs(way) > end_.time * pow(control_.tolerance(), S(1) / 5) / 8) return step(start_, time);
    Point to{.time = time};
    boost::numeric::odeint::runge_kutta4<Unknowns, S> stepper;
    stepper.do_step(std::cref(system_), near.x, near.rates, S(0), to.x, way);
    system_(to.x, to.rates, S(0));
    return to;
  }

  /// Newton's method from near the zero, between two times: with steps, then along the tangent once
  /// that is as exact. Where rounding of the value hides its slope, so that corrections do not
  /// shrink, the secant through the last two points. Ends on the negative side, to rounding.
  template <class Value>
  Point polished(Point point, const Value& value, const S& least, const S& greatest) {
    using std::abs;
    const S resolution = 8 * end_.time * std::numeric_limits<S>::epsilon();
    ValueAndSlope<S> before{};
    for (int n = 0; n < 8; ++n) {
      const S here = value(point.x), way = point.time - before.time;
      S slope = (value(point.ahead(look_ahead())) - here) / look_ahead();
      S correction = -here / slope;
      if (n > 0 && abs(correction) > look_ahead() && 2 * abs(correction) > abs(way)) {
        slope = (here - before.value) / way;
        correction = -here / slope;
      }
      if (!(slope < 0) || abs(correction) > end_.time / 8) break;  // it only touches zero
      if (here < 0 && abs(correction) <= resolution) break;
      const S time = std::clamp<S>(point.time + correction + resolution / 2, least, greatest);
      if (time == point.time) break;
      before = {point.time, here, slope};
      if (abs(correction) > look_ahead()) {
        point = step(point, time);
      } else {
        point.x = point.ahead(time - point.time);
        point.time = time;
        system_(point.x, point.rates, S(0));
      }
    }
    return point;
  }

  Control& control_;
  const System& system_;
  const Point &start_, &end_;
  Point stop_;
  std::optional<Bounds> bounds_;
  std::optional<DenseOutput> dense_output_;
};

/// Which of the system's events ends a step, if one does. The step stops there.
template <class S, class Stepper, class System>
std::optional<std::size_t> first_event(Step<S, Stepper, System>& step) {
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < System::event_count; ++i) {
    const EventBound<S>& bound = step.bounds().events[i];
    if (bound.stays_positive) continue;
    const auto value = [&step, i](const auto& x) { return step.system().event(i, x); };
    // Only up to the stop, which an event found before may have moved.
    if (const auto crossing = step.crossing(value, step.observe(value, step.start()),
                                            step.observe(value, step.stop()), bound.curvature)) {
      step.stop_at(*crossing);
      first = i;
    }
  }
  return first;
}

}  // namespace rotor
