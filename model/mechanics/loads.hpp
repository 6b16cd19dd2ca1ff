/// What acts on the rotor while it is clear of the ring. Each load states here, and nowhere else,
/// its force and moment, bounds of them, and the energy that it gives, takes or stores; everything
/// that needs these asks the list of all loads. Source: "Overcritical high-speed rotor systems,
/// full annular rub and accident", Sec. 2.1, Eq. (4).
#pragma once

#include <array>
#include <concepts>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>

#include "model/mechanics/rotor.hpp"

namespace rotor {

/// A moment without a force, N m.
template <class S>
struct Couple {
  S moment;
};

template <class S>
Loads<S>& operator+=(Loads<S>& loads, const Couple<S>& couple) {
  loads.moment += couple.moment;
  return loads;
}

/// Bounds of the magnitudes of a motion.
template <class S>
struct MotionBound {
  S displacement;  ///< of O from O_a, m
  S mass_centre;   ///< of C from O_a, m
  S velocity;      ///< of O, m/s
};

/// Upper bounds of the magnitudes of a load.
template <class S>
struct LoadBound {
  S force;   ///< at O, N
  S couple;  ///< what its moment is beside that of the force, N m

  LoadBound operator+(const LoadBound& other) const {
    return {force + other.force, couple + other.couple};
  }
  /// Of the moment about C, N m.
  S moment_about_centre(const Body<S>& body) const { return couple + body.eccentricity * force; }
};

/// A load that depends on the motion.
template <class T, class S>
concept VaryingLoad = requires(const T& load, const Body<S>& body, const Motion<S>& motion,
                               const MotionBound<S>& within, const S& distance, Loads<S>& all) {
  { T::name } -> std::convertible_to<std::string_view>;  // of its work in the balance of energy
  { all += load.loads(body, motion) } -> std::same_as<Loads<S>&>;
  { load.bound(body, within) } -> std::same_as<LoadBound<S>>;
  // What it gives the rotor, W; of the supports without what their springs give.
  { load.power(body, motion) } -> std::same_as<S>;
  // The energy that it stores, J, and by how much this can change while O is within a distance.
  { load.potential(body, motion) } -> std::same_as<S>;
  { load.potential_range(body, distance) } -> std::same_as<S>;
  // An upper bound, within a distance, of the moment that can drive the rotor for ever, N m.
  { load.moment_without_potential(body, distance) } -> std::same_as<S>;
};

/// A load that is constant between two events: a moment.
template <class T, class S>
concept ConstantLoad = requires(const T& load, const Motion<S>& motion, bool motor_on) {
  { T::name } -> std::convertible_to<std::string_view>;
  { load.moment(motor_on) } -> std::same_as<S>;         // N m
  { load.power(motion, motor_on) } -> std::same_as<S>;  // W
};

/// Springs and dampers. A ring that is off centre moves O_a, and not the point to which the springs
/// pull O: to their force -k r_O adds the constant -k b of the offset b, at O.
template <class S>
struct Supports {
  static constexpr std::string_view name = "support_damping";
  S stiffness;      ///< k, N/m
  S damping;        ///< d, N s/m
  Vector<S> rest;   ///< -b: position of rest of O from O_a, along x_a and y_a, m
  S rest_distance;  ///< |b|, m
  bool is_centred;  ///< whether the ring is

  explicit Supports(const Parameters& p)
      : stiffness(as_typed<S>(p.support_stiffness)),
        damping(as_typed<S>(p.support_damping)),
        rest(S(0) - as_typed<S>(p.ring_offset_x), S(0) - as_typed<S>(p.ring_offset_y)),
        rest_distance(rest.norm()),
        is_centred(rest_distance == 0) {}

  /// For the closed forms. Throws std::domain_error for a ring that is off centre.
  const Supports& required_centred() const {
    if (!is_centred)
      throw std::domain_error("the closed forms need ring_offset_x = 0 and ring_offset_y = 0");
    return *this;
  }

  /// Of O, m.
  Vector<S> from_rest(const Motion<S>& motion) const {
    return is_centred ? motion.displacement
                      : Vector<S>(motion.displacement - motion.from_stator(rest));
  }

  /// Force on the supports at a distance from rest and a velocity of O, N; by their magnitudes, an
  /// upper bound of its own; by velocity and acceleration, its rate, N/s.
  template <class T>
  T bearing_force(const T& from_rest, const T& velocity) const {
    return stiffness * from_rest + damping * velocity;
  }
  Vector<S> bearing_force(const Motion<S>& motion) const {
    return bearing_force(from_rest(motion), motion.velocity);
  }

  Loads<S> loads(const Body<S>& /*body*/, const Motion<S>& motion) const {
    const Vector<S> force = -damping * motion.velocity - stiffness * motion.displacement;
    Loads<S> all = {force, -damping * cross(motion.displacement, motion.velocity)};  // Eq. (4)
    if (is_centred) return all;
    const Vector<S> pull = stiffness * motion.from_stator(rest);
    return all += {pull, cross(motion.displacement, pull)};
  }
  LoadBound<S> bound(const Body<S>& /*body*/, const MotionBound<S>& within) const {
    return {bearing_force<S>(within.displacement + rest_distance, within.velocity), S(0)};
  }
  S power(const Body<S>& /*body*/, const Motion<S>& motion) const {
    return -damping * motion.velocity.squaredNorm();
  }
  S potential(const Body<S>& /*body*/, const Motion<S>& motion) const {
    return spring_energy(from_rest(motion).squaredNorm());
  }
  S potential_range(const Body<S>& /*body*/, const S& distance) const {
    const S farthest = distance + rest_distance;
    return spring_energy(farthest * farthest);
  }
  S moment_without_potential(const Body<S>& /*body*/, const S& /*distance*/) const { return S(0); }

  /// The steady response to the unbalance at a constant speed in rad/s, gravity's moment left out:
  /// C from the position of rest of O, e_x (k + i w d) / (k - m w^2 + i w d) in the rotating axes,
  /// as complex numbers, m.
  Vector<S> unbalance_response(const Body<S>& body, const S& speed) const {
    if (speed == 0) return {body.eccentricity, S(0)};  // without springs, too
    const Vector<S> force(stiffness, damping * speed);
    const Vector<S> impedance = force - Vector<S>(body.mass * speed * speed, S(0));
    const Vector<S> inverse =
        Vector<S>(impedance.x(), -impedance.y()) * (body.eccentricity / impedance.squaredNorm());
    return complex_product(force, inverse);
  }
  /// Its derivative by the speed, e_x m w (2 k + i w d) / (k - m w^2 + i w d)^2, m s.
  Vector<S> unbalance_response_by_speed(const Body<S>& body, const S& speed) const {
    if (speed == 0) return {S(0), S(0)};
    const Vector<S> impedance(stiffness - body.mass * speed * speed, damping * speed);
    const Vector<S> inverse =
        Vector<S>(impedance.x(), -impedance.y()) * (1 / impedance.squaredNorm());
    const Vector<S> driven =
        body.eccentricity * body.mass * speed * Vector<S>(2 * stiffness, damping * speed);
    return complex_product(driven, complex_product(inverse, inverse));
  }

 private:
  S spring_energy(const S& square) const { return stiffness * square / 2; }
};

/// Q_1 and Q_2 leave the weight out because the springs carry it at equilibrium; as printed, Q_3
/// nevertheless keeps the moment of the whole weight. The springs' preload balances all of it but
/// the part due to the eccentricity, which has a potential; the rest has none.
template <class S>
struct Weight {
  static constexpr std::string_view name = "gravity";
  S gravity;                 ///< g, m/s^2
  bool balanced_by_springs;  ///< whether the springs' preload takes its share of the moment

  Weight(const Parameters& p, Equations equations)
      : gravity(as_typed<S>(p.gravity)),
        balanced_by_springs(equations.gravity_moment == GravityMoment::balanced) {}

  Couple<S> loads(const Body<S>& body, const Motion<S>& motion) const {
    const Vector<S> arm = balanced_by_springs ? motion.eccentricity : motion.mass_centre();
    return {body.mass * gravity * cross(arm, motion.down)};  // Eq. (4)
  }
  LoadBound<S> bound(const Body<S>& body, const MotionBound<S>& within) const {
    return {S(0),
            body.mass * gravity * (balanced_by_springs ? body.eccentricity : within.mass_centre)};
  }
  S power(const Body<S>& body, const Motion<S>& motion) const {
    return loads(body, motion).moment * motion.speed;
  }
  S potential(const Body<S>& body, const Motion<S>& motion) const {
    return body.mass * gravity * (body.eccentricity - motion.eccentricity.dot(motion.down));
  }
  S potential_range(const Body<S>& body, const S& /*distance*/) const {
    return 2 * (body.mass * gravity) * body.eccentricity;
  }
  S moment_without_potential(const Body<S>& body, const S& distance) const {
    return balanced_by_springs ? S(0) : S(body.mass * gravity * distance);
  }
};

/// The paper's motor. A drive that holds the speed needs none.
template <class S>
struct Motor {
  static constexpr std::string_view name = "motor";
  S torque;  ///< M_mot until it is switched off, N m

  explicit Motor(const Parameters& p)
      : torque(p.drive == Drive::motor ? as_typed<S>(p.torque) : S(0)) {}

  S moment(bool motor_on) const { return motor_on ? torque : S(0); }
  S power(const Motion<S>& motion, bool motor_on) const {
    return motor_on ? S(torque * motion.speed) : S(0);
  }
};

/// All loads. A new one is a member, and stands in one of the two lists; a program may specialise
/// this for loads of its own.
template <class S>
struct LoadList {
  Supports<S> supports;
  Weight<S> weight;
  Motor<S> motor;

  LoadList(const Parameters& p, Equations equations)
      : supports(p), weight(p, equations), motor(p) {}

  auto varying() const {
    return std::tie(supports, weight);
  }                                                  ///< each a VaryingLoad; first a force
  auto constant() const { return std::tie(motor); }  ///< each a ConstantLoad
};

/// The names of the loads in a tuple of references.
template <class Tuple>
inline constexpr std::array<std::string_view, 0> load_names = {};
template <class... Each>
inline constexpr std::array<std::string_view, sizeof...(Each)> load_names<std::tuple<Each&...>> = {
    Each::name...};

/// What the loads of a rotor do together.
template <class S>
struct ActingLoads : LoadList<S> {
  using List = LoadList<S>;
  using List::List, List::varying, List::constant;

  /// In the order of powers().
  static constexpr auto& names = load_names<decltype(std::tuple_cat(
      std::declval<const List&>().varying(), std::declval<const List&>().constant()))>;

  Loads<S> loads(const Body<S>& body, const Motion<S>& motion, bool motor_on) const {
    return std::apply(
        [&](const VaryingLoad<S> auto& first, const VaryingLoad<S> auto&... others) {
          Loads<S> all = first.loads(body, motion);
          (all += ... += others.loads(body, motion));
          all.moment += constant_moment(motor_on);
          return all;
        },
        varying());
  }
  /// What stays the same until the next event, N m.
  S constant_moment(bool motor_on) const {
    return std::apply(
        [&](const ConstantLoad<S> auto&... load) { return S((... + load.moment(motor_on))); },
        constant());
  }

  /// Of the loads that vary; and of all.
  LoadBound<S> bound(const Body<S>& body, const MotionBound<S>& within) const {
    return sum<LoadBound<S>>([&](const auto& load) { return load.bound(body, within); });
  }
  LoadBound<S> bound(const Body<S>& body, const MotionBound<S>& within, bool motor_on) const {
    using std::abs;
    return LoadBound<S>{S(0), abs(constant_moment(motor_on))} + bound(body, within);
  }

  S potential(const Body<S>& body, const Motion<S>& motion) const {
    return sum<S>([&](const auto& load) { return load.potential(body, motion); });
  }
  S potential_range(const Body<S>& body, const S& distance) const {
    return sum<S>([&](const auto& load) { return load.potential_range(body, distance); });
  }
  S moment_without_potential(const Body<S>& body, const S& distance) const {
    return sum<S>([&](const auto& load) { return load.moment_without_potential(body, distance); });
  }

  /// Of each load, W.
  std::array<S, names.size()> powers(const Body<S>& body, const Motion<S>& motion,
                                     bool motor_on) const {
    const auto power = [&](const auto& load) -> S {
      if constexpr (ConstantLoad<std::remove_cvref_t<decltype(load)>, S>)
        return load.power(motion, motor_on);
      else
        return load.power(body, motion);
    };
    return std::apply(
        [&](const auto&... load) { return std::array<S, names.size()>{power(load)...}; },
        std::tuple_cat(varying(), constant()));
  }

 private:
  /// Of the loads that vary, added from the first to the last.
  template <class Sum, class Of>
  Sum sum(const Of& of) const {
    return std::apply([&](const auto&... load) { return Sum((... + of(load))); }, varying());
  }
};

}  // namespace rotor
