#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

#include "figures/sweep/mixed.hpp"
#include "figures/sweep/sweep.hpp"

namespace rotor {
namespace {

/// Computed in double alone: the same on every processor.
using Normal = boost::math::normal_distribution<
    double, boost::math::policies::policy<boost::math::policies::promote_double<false>>>;

/// A number between 0 and 1, without the ends, from 64 bits.
double share_of(std::uint64_t bits) {
  return (static_cast<double>(bits >> 12U) + 0.5) * std::ldexp(1., -52);
}

}  // namespace

double Range::at(long n) const {
  if (n == 0) return from;
  if (n == points - 1) return until;
  const double share = static_cast<double>(n) / static_cast<double>(points - 1);
  const double value =
      logarithmic ? from * std::pow(until / from, share) : from + (until - from) * share;
  const double decimal = number_in(fmt::format("{:.15g}", value)).value_or(value);
  const double rounding = 2 * std::numeric_limits<double>::epsilon() * std::abs(value);
  return std::abs(decimal - value) <= rounding ? decimal : value;  // 0.06, not 0.060000000000000005
}

long Axis::points() const {
  const std::size_t listed = names.size() + numbers.size();
  return listed > 0 ? static_cast<long>(listed) : range.points;
}

double Axis::number(long n) const {
  return numbers.empty() ? range.at(n) : numbers[static_cast<std::size_t>(n)];
}

std::pair<double, double> Axis::ends() const {
  if (numbers.empty()) return {range.from, range.until};
  const auto [least, greatest] = std::minmax_element(numbers.begin(), numbers.end());
  return {*least, *greatest};
}

double Draw::quantile(double share) const {
  switch (distribution) {
    case Distribution::uniform:
      return a + (b - a) * share;
    case Distribution::log_uniform:
      return a * std::pow(b / a, share);
    case Distribution::normal:
      return boost::math::quantile(Normal(a, b), share);
  }
  std::abort();
}

std::pair<double, double> Draw::ends(long count) const {
  if (distribution != Distribution::normal) return {a, b};
  const double share = 0.5e-3 / static_cast<double>(count);
  return {quantile(share), quantile(1 - share)};
}

long Sweep::points() const {
  long all = sample.count;
  for (const Axis& axis : axes) all *= axis.points();
  return all;
}

std::vector<std::string> Sweep::quantities() const {
  std::vector<std::string> all;
  for (const Axis& axis : axes) all.push_back(axis.quantity);
  for (const Draw& draw : sample.over) all.push_back(draw.quantity);
  return all;
}

SweepPoints::SweepPoints(const Sweep& sweep) : sweep_(sweep) {
  std::mt19937_64 random(sweep.sample.seed);
  for (std::size_t i = 0; i < sweep.sample.over.size(); ++i) shifts_.push_back(random());
}

std::vector<double> SweepPoints::shares(long draw) const {
  const std::size_t dimensions = sweep_.sample.over.size();
  const auto number = static_cast<std::uint64_t>(draw);
  std::vector<double> all;
  if (dimensions == 0) return all;
  if (sweep_.sample.method == Sampling::random) {  // the draws of a point need no others
    for (std::size_t i = 0; i < dimensions; ++i)
      all.push_back(share_of(mixed(shifts_[i] + number)));
    return all;
  }
  // The first point of the sequence is the origin; with its shift it is a point like any other.
  boost::random::sobol sequence(dimensions);
  if (number > 0) sequence.seed(number - 1);
  for (std::size_t i = 0; i < dimensions; ++i)
    all.push_back(share_of((number > 0 ? sequence() : 0) ^ shifts_[i]));
  return all;
}

SweepPoint SweepPoints::operator()(long n) const {
  SweepPoint point{sweep_.base, std::vector<std::string>(sweep_.axes.size())};
  const auto set = [&point](const std::string& quantity, double number) {
    point.spec.numbers.insert_or_assign(quantity, number);
    return fmt::format("{}", number);
  };
  long left = n / sweep_.sample.count;
  for (std::size_t i = sweep_.axes.size(); i-- > 0;) {
    const Axis& axis = sweep_.axes[i];
    const long of_axis = left % axis.points();
    left /= axis.points();
    if (axis.names.empty()) {
      point.values[i] = set(axis.quantity, axis.number(of_axis));
    } else {
      point.values[i] = axis.names[static_cast<std::size_t>(of_axis)];
      find_named_input(axis.quantity)->state(point.spec, point.values[i]);
    }
  }
  const std::vector<double> shares = this->shares(n % sweep_.sample.count);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Draw& draw = sweep_.sample.over[i];
    point.values.push_back(set(draw.quantity, draw.quantile(shares[i])));
  }
  return point;
}

}  // namespace rotor
