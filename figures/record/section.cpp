#include "figures/record/section.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "model/results/quadrature.hpp"

namespace rotor {

void require_equal_turns(const Scenario& scenario) {
  if (scenario.parameters.drive != Drive::constant_speed)
    throw ScenarioError({"needs drive = constant_speed, which makes all turns equally long"});
  if (scenario.method == Method::rk4)
    throw ScenarioError({"needs method = event, which knows the motion between its steps"});
}

long whole_turns(const Scenario& scenario) {
  require_equal_turns(scenario);
  constexpr double rounding = 1e-9;  // in which O moves by less than its place is known to
  const double turns = scenario.until * scenario.start_speed_Hz + rounding;
  if (!(turns >= 1))
    throw ScenarioError({mention_of(scenario, "until"), " is before the end of the first turn at ",
                         mention_of(scenario, "start_speed_Hz"), ": state a later one"});
  return static_cast<long>(turns);
}

Section::Section(const Scenario& scenario, long turns, RowSink sink)
    : last_turn_(whole_turns(scenario)),
      turns_(std::min(turns, last_turn_)),
      turn_s_(1 / scenario.start_speed_Hz),
      near_(1e-6 * Ring<double>(scenario.parameters).clearance),
      means_(1),
      points_(static_cast<double>(last_turn_ - turns_ + 1) * turn_s_,
              std::min(scenario.until, static_cast<double>(last_turn_) * turn_s_), turn_s_,
              columns(), scenario, [this, sink = std::move(sink)](std::span<const double> row) {
                const Vector<double> velocity(row[3], row[4]);
                places_.push_back({{row[1], row[2]}, velocity * (turn_s_ / two_pi)});
                sink(row);
              }) {}

std::vector<const Column*> Section::columns() {
  std::vector<const Column*> all;
  for (const char* name :
       {"time_s", "x_a_m", "y_a_m", "x_a_rate_m_per_s", "y_a_rate_m_per_s", "normal_force_N"})
    all.push_back(find_column(name));
  return all;
}

double Section::end_of_turn_s() const {
  return static_cast<double>(last_turn_ - turns_ + static_cast<long>(means_.size())) * turn_s_;
}

bool Section::wants_dense_output(const double& from_s, const double& until_s) const {
  return (until_s > end_of_turn_s() - turn_s_ && !is_complete_) ||
         points_.wants_dense_output(from_s, until_s);
}

void Section::on_step(const DenseOutput& motion) {
  points_.on_step(motion);
  double from_s = std::max(motion.from_s, end_of_turn_s() - turn_s_);
  while (from_s < motion.until_s && !is_complete_) {
    const double end_s = end_of_turn_s(), until_s = std::min(motion.until_s, end_s);
    integrate(motion, from_s, until_s, means_.back());
    from_s = until_s;
    if (until_s < end_s) return;
    is_complete_ = static_cast<long>(means_.size()) == turns_;
    if (!is_complete_) means_.emplace_back();
  }
}

/// Parts of a radian of the rotation, in which the order 2 and the motion's own arcs swing by three
/// at most: the error of the rule is then some 1e-11 of the displacement.
void Section::integrate(const DenseOutput& motion, double from_s, double until_s,
                        Means& into) const {
  const double radians = two_pi * (until_s - from_s) / turn_s_,
               share = (until_s - from_s) / (motion.until_s - motion.from_s);
  const double parts = std::max(radians, share * static_cast<double>(motion.arcs));
  gauss_nodes(from_s, until_s, static_cast<long>(std::ceil(parts)), [&](double t, double weight) {
    const State<double> state = motion.at(t).state;
    const std::complex<double> in_rotor(state[0], state[1]);  // z exp(-i phi)
    for (std::size_t n = 0; n < orders.size(); ++n) {
      const double order = orders[n].multiple;
      into[n].forward += weight / turn_s_ * in_rotor * std::polar(1., (1 - order) * state[2]);
      into[n].backward += weight / turn_s_ * in_rotor * std::polar(1., (1 + order) * state[2]);
    }
  });
}

std::optional<long> Section::repeats_after_turns() const {
  const auto turns = static_cast<long>(places_.size());
  for (long n = 1; n <= std::min(SectionSummary::longest_period, turns / 2); ++n)
    if (std::equal(places_.begin() + n, places_.end(), places_.begin(),
                   [&](const Place& a, const Place& b) {
                     return (a.position - b.position).norm() <= near_ &&
                            (a.velocity - b.velocity).norm() <= near_;
                   }))
      return n;
  return std::nullopt;
}

SectionSummary Section::summary() const {
  SectionSummary all;
  all.turns = points_.rows();
  all.repeats_after_turns = repeats_after_turns();
  constexpr long of_all_orders = 6;
  const auto whole = [&](long of) { return all.turns / of * of; };
  all.orders_over_turns = whole(std::lcm(of_all_orders, all.repeats_after_turns.value_or(1)));
  all.orders_over_whole_periods = all.repeats_after_turns && all.orders_over_turns > 0;
  if (!all.orders_over_whole_periods) all.orders_over_turns = whole(of_all_orders);
  for (auto turn = means_.end() - all.orders_over_turns; turn != means_.end(); ++turn)
    for (std::size_t n = 0; n < orders.size(); ++n) {
      const auto over = static_cast<double>(all.orders_over_turns);
      all.means[n].forward += (*turn)[n].forward / over;
      all.means[n].backward += (*turn)[n].backward / over;
    }
  double largest = 0;
  for (const Place& place : places_) largest = std::max(largest, place.position.norm());
  for (const OrderMeans& mean : all.means)
    largest = std::max({largest, std::abs(mean.forward), std::abs(mean.backward)});
  for (OrderMeans& mean : all.means)
    for (std::complex<double>* const part : {&mean.forward, &mean.backward})
      if (std::abs(*part) < 1e-9 * largest) *part = 0;
  return all;
}

}  // namespace rotor
