/// Integration with error control, phase by phase, each ending at a located event: no step
/// straddles a jump, and every step has the full order of its Odeint stepper. Templated on the
/// scalar, for runs of higher precision.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "model/crossing.hpp"
#include "model/hermite.hpp"
#include "model/phases.hpp"
#include "model/simulation.hpp"
#include "model/verner.hpp"

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

template <class S, class Stepper = Verner87<std::array<S, 6>, S>>
class EventMethod {
 public:
  using Unknowns = std::array<S, 6>;

  /// `tolerance` is the error allowed in a step, in the units of the phases' scale().
  EventMethod(const Scenario& scenario, const S& tolerance, BasicObserver<S>& observer, Work& work)
      : tolerance_(tolerance),
        observer_(observer),
        work_(work),
        around_(Surroundings<S>::of(scenario)) {}

  /// As many whole steps as end before `until_s`, and before the ring is touched, so that the
  /// run-up has the same steps whoever leaves it when.
  BasicInstant<S> run_up(const BasicInstant<S>& from, const S& until_s) {
    return advance(from, until_s, Extent::whole_steps);
  }

  /// All the way to `until_s`, in contact or not.
  BasicInstant<S> rub(const BasicInstant<S>& from, const S& until_s) {
    const BasicInstant<S> end = advance(from, until_s, Extent::everything);
    observer_.see(end);
    return end;
  }

 private:
  /// The unknowns at a time after the start of a step.
  struct Point {
    S time{};
    Unknowns x{}, rates{};
  };

  enum class Extent { everything, whole_steps };
  template <class Phase>
  class Path;

  static constexpr long most_steps = 20'000'000;  ///< that only a run in trouble takes

  BasicInstant<S> advance(BasicInstant<S> at, const S& until_s, Extent extent) {
    start(at);
    while (at.time_s < until_s) {
      const std::optional<Guard> guard = integrate(at, until_s, extent);
      if (!guard) break;
      ++work_.located_events;
      limit_switches(at);
      observer_.see(at);
      follow_up(*guard, at);
      observer_.see(at);
      at.event = Event::none;
    }
    at.next_step_s = flight_step_;
    return at;
  }

  void start(BasicInstant<S>& at) {
    around_.body = at.body;
    around_.motor_on = at.motor_on;
    at.event = Event::none;
    steps_ = 0;
    switch_limit_.restart(at.time_s);
    flight_step_ =
        at.next_step_s > 0 ? at.next_step_s : S(0.01) / Flight<S>::frequency(around_, at.state[5]);
    if (!(rub_step_ > 0)) rub_step_ = S(0.1) / Rub<S>::frequency(around_, at.state[5]);
    if (at.contact != ContactState::free) take_up(begin_again(around_, at.state, at.contact), at);
  }

  void follow_up(Guard guard, BasicInstant<S>& at) {
    if (guard == Guard::motor) {
      around_.motor_on = at.motor_on = false;
      at.event = Event::motor_off;
      from_rest_ = false;
    } else {
      take_up(follow(guard, around_, at.state), at);
    }
  }

  void take_up(const Begin& begin, BasicInstant<S>& at) {
    at.contact = begin.contact;
    at.event = begin.event;
    direction_ = begin.direction;
    from_rest_ = begin.from_rest;
  }

  /// To the end of the phase, or of the extent. Says which guard ended the phase.
  std::optional<Guard> integrate(BasicInstant<S>& at, const S& until_s, Extent extent) {
    switch (at.contact) {
      case ContactState::free:
        return integrate(FreeFlight<S>(around_, at.state), at, until_s, extent, flight_step_);
      case ContactState::indented:
        return integrate(IndentedFlight<S>(around_, at.state), at, until_s, extent, rub_step_);
      case ContactState::sliding:
        return integrate(Sliding<S>(around_, at.state, direction_, from_rest_), at, until_s, extent,
                         rub_step_);
      case ContactState::rolling:
        return integrate(Rolling<S>(around_, at.state), at, until_s, extent, rub_step_);
    }
    return std::nullopt;
  }

  template <class Phase>
  std::optional<Guard> integrate(Phase phase, BasicInstant<S>& at, const S& until_s, Extent extent,
                                 S& step) {
    Point a{.time = S(0), .x = phase.unknowns(at.state)};
    evaluate(phase, a);
    std::optional<Guards<Phase>> guards;  // at a, once they have been needed
    for (;;) {
      const bool last = !(at.time_s + step < until_s);
      if (last && extent == Extent::whole_steps) break;
      // As long as the time's digits say, so that times add up without rounding.
      const S length = (last ? until_s : S(at.time_s + step)) - at.time_s;
      Point b{.time = length};
      const double error = take_step(phase, a, b);
      const S factor = static_cast<S>(step_factor(error));
      if (!(error <= 1)) {
        step = length * factor;
        require_progress(at, step);
        continue;
      }
      evaluate(phase, b);

      Path<Phase> path(*this, phase, a, b);
      const std::optional<Guard> guard = first_guard(path, guards, b);
      if (guard == Guard::touch_down && extent == Extent::whole_steps) break;
      count_step(at);
      if (!last) step = length * factor;
      show(path, at, b.time);
      at.time_s = last && !guard ? until_s : at.time_s + b.time;
      if (guard || last) {
        at.state = phase.state(b.x);
        return guard;
      }
      a = {.time = S(0), .x = b.x, .rates = b.rates};
      if (extent == Extent::whole_steps) {  // may be taken up from here, with the same bits
        at.state = phase.state(a.x);
        phase.lay_axes(at.state);
        a.x = phase.unknowns(at.state);
        evaluate(phase, a);
      } else if (phase.start_step(a.x)) {
        evaluate(phase, a);
      }
    }
    return std::nullopt;
  }

  template <class Phase>
  void evaluate(const Phase& phase, Point& point) {
    System<Phase>{phase, work_}(point.x, point.rates, S(0));
  }

  /// Steps from a to the time of b. Returns the error in units of the tolerance.
  template <class Phase>
  double take_step(const Phase& phase, const Point& a, Point& b) {
    using std::abs;
    Unknowns errors;
    stepper_.do_step(System<Phase>{phase, work_}, a.x, a.rates, S(0), b.x, S(b.time - a.time),
                     errors);
    const Unknowns scale = phase.scale(a.x);
    const S rounding = 32 * std::numeric_limits<S>::epsilon();  // of the sums in a step
    double largest = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const S allowed = scale[i] * tolerance_ + rounding * abs(b.x[i]);
      const double error = static_cast<double>(S(abs(errors[i]) / allowed));
      if (std::isnan(error)) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, error);
    }
    return largest;
  }

  /// By how much the next step is to be longer.
  static double step_factor(double error) {
    constexpr double caution = 0.9, least = 0.2, most = 4;
    if (!(error < std::numeric_limits<double>::infinity())) return least;
    const double exponent = -1. / Stepper::stepper_order_value;
    return std::clamp(caution * std::pow(error, exponent), least, most);
  }

  template <class Phase>
  using Guards = std::array<Ordinate<S>, Phase::guard_names.size()>;

  /// The guard that becomes negative first on a path, if any. Moves `end`, which is the path's at
  /// first, there, and takes the guards on to it.
  template <class Phase>
  std::optional<Guard> first_guard(Path<Phase>& path, std::optional<Guards<Phase>>& guards,
                                   Point& end) {
    const Phase& phase = path.phase();
    const Point& start = path.start();
    if (phase.passes(start.x, end.x, end.time)) {
      guards.reset();
      return std::nullopt;
    }
    Guards<Phase> before = guards ? *guards : all_guards(phase, start, end.time);
    guards = all_guards(phase, end, end.time);
    std::optional<Guard> first;
    for (std::size_t i = 0; i < before.size(); ++i) {
      before[i].time = 0;
      const auto guard = [&](const Unknowns& x) { return guards_at(phase, x)[i]; };
      const auto curvature = phase.greatest_curvature(i, start.x, end.time);
      // Up to the end, which an earlier guard may have moved already.
      if (const auto crossing = path.crossing(guard, before[i], (*guards)[i], curvature)) {
        end = *crossing;
        guards = all_guards(phase, end, end.time);
        first = Phase::guard_names[i];
      }
    }
    return first;
  }

  template <class Phase>
  Guards<Phase> all_guards(const Phase& phase, const Point& point, const S& length) {
    const S ahead = look_ahead(length);
    const auto here = guards_at(phase, point.x), there = guards_at(phase, moved(point, ahead));
    Guards<Phase> all;
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = {point.time, here[i], (there[i] - here[i]) / ahead};
    return all;
  }

  template <class Phase>
  typename Phase::Guards guards_at(const Phase& phase, const Unknowns& x) {
    if constexpr (Phase::contact_in_guards) ++work_.contact_evaluations;
    return phase.guards(x);
  }

  /// Over which time a slope is taken as a difference.
  static S look_ahead(const S& length) {
    using std::sqrt;
    return length * sqrt(std::numeric_limits<S>::epsilon());
  }

  static Unknowns moved(const Point& point, const S& time) {
    Unknowns x = point.x;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += time * point.rates[i];
    return x;
  }

  /// Shows the observer what it wants to see of a path, the maxima in their places.
  template <class Phase>
  void show(Path<Phase>& path, const BasicInstant<S>& start, const S& length) {
    const S until_s = start.time_s + length;
    const bool pieces = observer_.wants_pieces(start.time_s, until_s);
    S from_s = start.time_s;
    const auto show_piece = [&](const S& to_s) {
      if (pieces && to_s > from_s)
        observer_.see(PieceOf<Phase>(from_s, to_s, path.phase().arcs(path.start().x, to_s - from_s),
                                     path.phase(), start, path.polynomial()));
      from_s = to_s;
    };
    for (const Point& maximum : find_maxima(path, start, length)) {
      BasicInstant<S> at = start;
      at.time_s += maximum.time;
      at.state = path.phase().state(maximum.x);
      show_piece(at.time_s);
      observer_.see(at);
    }
    show_piece(until_s);
  }

  /// The maxima on a path that the observer wants, in order.
  template <class Phase>
  std::vector<Point> find_maxima(Path<Phase>& path, const BasicInstant<S>& start, const S& length) {
    std::vector<Point> found;
    if constexpr (Phase::has_maxima) {
      const Phase& phase = path.phase();
      const auto wanted = [&](Extreme of, const S& bound, const S& from, const S& until) {
        return observer_.wants(of, bound, start.time_s + from, start.time_s + until);
      };
      const S anything = std::numeric_limits<S>::infinity();
      if (!wanted(Extreme::displacement, anything, S(0), length) &&
          !wanted(Extreme::normal_force, anything, S(0), length))
        return found;
      const auto reach = path.reach();
      if (reach && !wanted(Extreme::displacement, *reach, S(0), length)) return found;
      // In contact the ends of a step have to tell, or every step would cost an interpolation: at
      // loose tolerances it may swing by more than an arc, and hide a maximum.
      const int arcs = Phase::contact_in_rates ? 1 : phase.arcs(path.start().x, length);
      Point left = path.start();
      for (int n = 1; n <= arcs; ++n) {
        const Point right = path.interpolated(length * S(n) / S(arcs));
        const auto at_left = phase.maxima(left.x, left.rates);
        const auto at_right = phase.maxima(right.x, right.rates);
        for (std::size_t i = 0; i < at_left.size(); ++i) {
          const Maximum<S>&l = at_left[i], &r = at_right[i];
          if (!(l.rate > 0 && r.rate < 0)) continue;
          if (!wanted(l.of, where_tangents_meet(l, r, S(right.time - left.time)), left.time,
                      right.time))
            continue;
          const auto rate = [&](const Unknowns& x) {
            Point point{.x = x};
            evaluate(phase, point);
            return phase.maxima(x, point.rates)[i].rate;
          };
          if (const auto maximum = path.crossing(rate, left.time, right.time))
            found.push_back(*maximum);
        }
        left = right;
      }
      std::ranges::sort(found, {}, &Point::time);
    }
    return found;
  }

  /// A bound of what an arc reaches that is curved to one side.
  static S where_tangents_meet(const Maximum<S>& a, const Maximum<S>& b, const S& h) {
    return a.value + a.rate * (b.value - a.value - b.rate * h) / (a.rate - b.rate);
  }

  using Polynomial = HermitePolynomial<S, Unknowns, 4>;

  /// A step that has been taken, to be looked into.
  template <class Phase>
  class Path {
   public:
    Path(EventMethod& method, const Phase& phase, const Point& start, const Point& end)
        : method_(method), phase_(phase), start_(start), end_(end) {}

    const Phase& phase() const { return phase_; }
    const Point& start() const { return start_; }
    std::optional<S> reach() const { return phase_.reach(start_.x, end_.x, end_.time); }

    /// As accurate as the step: of its order, through two points between its ends.
    const Polynomial& polynomial() {
      if (!polynomial_) {
        std::array<typename Polynomial::Node, 4> nodes;
        Point point = start_;
        for (std::size_t i = 0; i < 3; ++i) {
          nodes[i] = {point.time, point.x, point.rates};
          if (i < 2) point = step(point, end_.time * S(i + 1) / 3);
        }
        nodes[3] = {end_.time, end_.x, end_.rates};
        polynomial_.emplace(nodes);
      }
      return *polynomial_;
    }

    Point interpolated(const S& time) {
      if (time == end_.time) return end_;
      Point point{.time = time, .x = polynomial()(time)};
      method_.evaluate(phase_, point);
      return point;
    }

    /// Where value(x) first becomes negative between two times, if it does.
    template <class Value>
    std::optional<Point> crossing(const Value& value, const S& from, const S& until) {
      const auto f = ordinate_of(value);
      return crossing(value, f(from), f(until), std::nullopt);
    }

    template <class Value>
    std::optional<Point> crossing(const Value& value, const Ordinate<S>& from,
                                  const Ordinate<S>& until, const std::optional<S>& curvature) {
      // Found on the polynomial, which costs no right-hand sides; then polished.
      const auto time =
          first_crossing(from, until, S(look_ahead(end_.time)), curvature, ordinate_of(value));
      if (!time) return std::nullopt;
      if (*time == 0) return start_;
      return polished(step(start_, *time), value);
    }

   private:
    template <class Value>
    auto ordinate_of(const Value& value) {
      return [this, &value, ahead = look_ahead(end_.time)](const S& time) -> Ordinate<S> {
        const S here = value(polynomial()(time)), there = value(polynomial()(time + ahead));
        return {time, here, (there - here) / ahead};
      };
    }

    Point step(const Point& from, const S& time) {
      Point to{.time = time};
      method_.take_step(phase_, from, to);
      method_.evaluate(phase_, to);
      return to;
    }

    /// Newton's method from near the zero: by steps, and by the tangent once that is as exact. Ends
    /// on the far side, where value < 0, to rounding.
    template <class Value>
    Point polished(Point point, const Value& value) {
      using std::abs;
      const S tangent = look_ahead(end_.time);
      const S resolution = 8 * end_.time * std::numeric_limits<S>::epsilon();
      for (int n = 0; n < 8; ++n) {
        const S here = value(point.x);
        const S slope = (value(moved(point, tangent)) - here) / tangent;
        const S correction = -here / slope;
        if (!(slope < 0) || abs(correction) > end_.time / 8) break;  // it only touches zero
        if (here < 0 && abs(correction) <= resolution) break;
        const S time = point.time + correction + resolution / 2;
        if (abs(correction) > tangent) {
          point = step(point, time);
        } else {
          point.x = moved(point, time - point.time);
          point.time = time;
          method_.evaluate(phase_, point);
        }
      }
      return point;
    }

    EventMethod& method_;
    const Phase& phase_;
    const Point& start_;
    const Point end_;  ///< a copy: the end of what is kept of the step may be moved back
    std::optional<Polynomial> polynomial_;
  };

  template <class Phase>
  class PieceOf : public BasicPiece<S> {
   public:
    PieceOf(const S& from, const S& until, int arcs_in_it, const Phase& phase,
            const BasicInstant<S>& start, const Polynomial& polynomial)
        : BasicPiece<S>(from, until, arcs_in_it),
          phase_(phase),
          start_(start),
          polynomial_(polynomial) {}

    BasicInstant<S> at(const S& time_s) const override {
      BasicInstant<S> instant = start_;
      instant.time_s = time_s;
      instant.state = phase_.state(polynomial_(time_s - start_.time_s));
      return instant;
    }

   private:
    const Phase& phase_;
    const BasicInstant<S>& start_;
    const Polynomial& polynomial_;
  };

  void count_step(const BasicInstant<S>& at) {
    ++work_.steps;
    if (++steps_ > most_steps)
      fail(at, fmt::format("{} steps have been taken, which is more than any run should need",
                           most_steps));
  }

  void require_progress(const BasicInstant<S>& at, const S& step) const {
    if (!(at.time_s + step > at.time_s))
      fail(at, fmt::format("no step is short enough: the motion is not finite, or the tolerance {} "
                           "is below rounding",
                           static_cast<double>(tolerance_)));
  }

  void limit_switches(const BasicInstant<S>& at) {
    const S period = boost::math::constants::two_pi<S>() / Rub<S>::frequency(around_, at.state[5]);
    if (switch_limit_.exceeded(at.time_s, period))
      fail(at, fmt::format("more than {} changes between free, sliding and rolling within {} s",
                           SwitchLimit<S>::most, static_cast<double>(period)));
  }

  [[noreturn]] static void fail(const BasicInstant<S>& at, const std::string& reason) {
    throw std::runtime_error(fmt::format("the event run ends at t = {:.9f} s: {}",
                                         static_cast<double>(at.time_s), reason));
  }

  /// The right-hand side of a phase, counted.
  template <class Phase>
  struct System {
    const Phase& phase;
    Work& work;

    void operator()(const Unknowns& x, Unknowns& rates, const S& time) const {
      ++work.right_hand_sides;
      if constexpr (Phase::contact_in_rates) ++work.contact_evaluations;
      phase(x, rates, time);
    }
  };

  const S tolerance_;
  BasicObserver<S>& observer_;
  Work& work_;
  Surroundings<S> around_;
  Stepper stepper_{};
  S flight_step_{0}, rub_step_{0};
  int direction_ = 0;  ///< of the slip, while sliding
  bool from_rest_ = false;
  long steps_ = 0;  ///< since the method was last called
  SwitchLimit<S> switch_limit_;
};

}  // namespace rotor
