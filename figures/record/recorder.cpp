#include "figures/record/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rotor {

Recorder::Recorder(const Window& window, std::vector<const Column*> columns,
                   const Scenario& scenario, double tolerance, RowSink sink)
    : window_(window),
      open_(!window.from_rolling_onset),
      columns_(std::move(columns)),
      tolerance_(tolerance),
      context_(scenario),
      sink_(std::move(sink)),
      least_(columns_.size(), std::numeric_limits<double>::infinity()),
      greatest_(columns_.size(), -std::numeric_limits<double>::infinity()) {}

bool Recorder::contains(double time_s) const {
  constexpr double rounding_s = 1e-11;
  const double since = time_s - window_.from_s;
  return open_ && since >= -rounding_s && since <= window_.length_s + rounding_s;
}

void Recorder::on_instant(const Instant& at) {
  if (!open_ && at.contact == ContactState::rolling) {
    window_ = {.from_s = at.time_s, .length_s = window_.length_s};
    open_ = true;
  }
  if (!contains(at.time_s)) return;
  add(row(at));
  note_extremes(at);
}

void Recorder::on_maximum(const Maximum& maximum) {
  if (!contains(maximum.at.time_s)) return;
  maxima_.push_back(maximum.at);
  note_extremes(maximum.at);
}

void Recorder::note_extremes(const Instant& at) {
  InstantView view(at, context_);
  for (const Column* column : columns_)
    if (column->extreme) {
      double& largest = largest_[static_cast<std::size_t>(*column->extreme)];
      largest = std::max(largest, std::abs(column->value(view)));
    }
}

bool Recorder::wants_dense_output(const double& from_s, const double& until_s) const {
  return open_ && until_s > window_.from_s && from_s < window_.from_s + window_.length_s;
}

void Recorder::on_step(const DenseOutput& motion) {
  double from = std::max(motion.from_s, window_.from_s);
  const double until = std::min(motion.until_s, window_.from_s + window_.length_s);
  const std::vector<Instant> maxima = std::exchange(maxima_, {});
  if (!(until > from)) return;
  Row left = row(motion.at(from));
  add(left);
  const auto sample_until = [&](double time_s, const Instant& at) {
    if (!(time_s > from && time_s <= until)) return;
    const Row right = row(at);
    sample(motion, from, left, time_s, right);
    from = time_s;
    left = right;
  };
  for (const Instant& maximum : maxima) sample_until(maximum.time_s, maximum);
  sample_until(until, motion.at(until));
}

void Recorder::sample(const DenseOutput& motion, double from_s, const Row& from, double until_s,
                      const Row& until) {
  const double share = (until_s - from_s) / (motion.until_s - motion.from_s);
  const auto parts = static_cast<long>(std::ceil(share * static_cast<double>(motion.arcs)));
  double left_s = from_s;
  Row left = from;
  for (long n = 1; n <= parts; ++n) {
    const double part = static_cast<double>(n) / static_cast<double>(parts);
    const double right_s = n == parts ? until_s : from_s + (until_s - from_s) * part;
    const Row right = n == parts ? until : row(motion.at(right_s));
    refine(motion, left_s, left, right_s, right, 0);
    add(right);
    left_s = right_s;
    left = right;
  }
}

void Recorder::refine(const DenseOutput& motion, double from_s, const Row& from, double until_s,
                      const Row& until, int depth) {
  constexpr int least_depth = 1, greatest_depth = 6;  // an arc may have an inflection
  if (depth == greatest_depth) return;
  const double middle_s = (from_s + until_s) / 2;
  const Row middle = row(motion.at(middle_s));
  if (depth > least_depth && is_straight(from, middle, until)) return;
  refine(motion, from_s, from, middle_s, middle, depth + 1);
  add(middle);
  refine(motion, middle_s, middle, until_s, until, depth + 1);
}

bool Recorder::is_straight(const Row& from, const Row& middle, const Row& until) const {
  for (std::size_t i = 0; i < middle.size(); ++i)
    if (std::abs(middle[i] - (from[i] + until[i]) / 2) > tolerance_ * (greatest_[i] - least_[i]))
      return false;
  return true;
}

double Recorder::threshold(Extreme of, const double& from_s, const double& until_s) const {
  const bool records = std::any_of(columns_.begin(), columns_.end(),
                                   [of](const Column* c) { return c->extreme == of; });
  if (!records || !wants_dense_output(from_s, until_s))
    return Observer::threshold(of, from_s, until_s);
  return largest_[static_cast<std::size_t>(of)];
}

Recorder::Row Recorder::row(const Instant& at) const {
  InstantView view(at, context_);
  Row values;
  values.reserve(columns_.size());
  for (const Column* column : columns_) values.push_back(column->value(view));
  return values;
}

void Recorder::add(const Row& row) {
  const auto is_same = [](double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
  };
  if (std::equal(row.begin(), row.end(), last_.begin(), last_.end(), is_same))
    return;  // the end of one step is the start of the next
  last_ = row;
  for (std::size_t i = 0; i < row.size(); ++i) {
    least_[i] = std::min(least_[i], row[i]);
    greatest_[i] = std::max(greatest_[i], row[i]);
  }
  sink_({row.data(), row.size()});
  ++rows_;
}

Sampler::Sampler(double from_s, double until_s, double every_s, std::vector<const Column*> columns,
                 const Scenario& scenario, RowSink sink)
    : from_s_(from_s),
      end_s_(until_s),
      until_s_(until_s + every_s / 1e6),  // allows for rounding
      every_s_(every_s),
      columns_(std::move(columns)),
      context_(scenario),
      sink_(std::move(sink)) {}

bool Sampler::wants_dense_output(const double& from_s, const double& until_s) const {
  const double time = time_s(next_);
  return time <= until_s_ && from_s <= time && time <= until_s + every_s_ / 1e6;
}

void Sampler::on_step(const DenseOutput& motion) {
  std::vector<double> row(columns_.size());
  for (; wants_dense_output(motion.from_s, motion.until_s); ++next_) {
    const double time = std::min(time_s(next_), end_s_);
    Instant at = motion.at(std::min(time, motion.until_s));
    at.time_s = time;
    InstantView view(at, context_);
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = columns_[i]->value(view);
    sink_(row);
  }
}

}  // namespace rotor
