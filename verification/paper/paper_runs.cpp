#include "verification/paper/paper_runs.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "figures/results/run_result.hpp"
#include "model/results/energy.hpp"
#include "model/results/stop_on.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/place_of_loss.hpp"

namespace rotor {
constexpr double early_s = 5e-3;  ///< of rolling that is measured

void PaperInputs::set(const std::string& input, double value) {
  using In = PaperInputs;
  using Own = std::map<std::string, double In::*>;
  static const Own own = {{"mu_high", &In::mu_high},
                          {"mu_intermediate", &In::mu_intermediate},
                          {"mu_low", &In::mu_low},
                          {"t_operating", &In::t_operating},
                          {"t_100", &In::t_100},
                          {"t_75", &In::t_75},
                          {"t_50", &In::t_50},
                          {"t_critical", &In::t_critical},
                          {"rolling_Hz", &In::rolling_Hz},
                          {"rolling_rho", &In::rolling_rho},
                          {"onset_Hz", &In::onset_Hz},
                          {"energy_left", &In::energy_left},
                          {"energy_before", &In::energy_before},
                          {"shortest_s", &In::shortest_s},
                          {"longest_s", &In::longest_s}};
  const auto found = own.find(input);
  if (found != own.end())
    this->*(found->second) = value;
  else
    spec.numbers.insert_or_assign(input, value);
}

/// Records what a run shows. The method with fixed steps shows no events; they follow from the
/// changes of its contact state.
class PaperWatch : public Observer {
 public:
  explicit PaperWatch(PaperRun& run) : run_(run), ring_(run.scenario_.parameters) {}

  void on_instant(const Instant& at) override {
    if (at.mass_lost && !last_.mass_lost) {
      run_.before_loss_ = last_;
      run_.after_loss_ = at;
    }
    if (touch_downs_.begins_with(at.contact)) run_.touch_downs_.push_back(at);
    if (last_.touches() && !at.touches()) run_.releases_.push_back(at);
    if (at.contact == ContactState::rolling && !run_.onset_) run_.onset_ = at;
    note_force(at);
    if (run_.scenario_.method == Method::rk4) sample(at);
    last_ = at;
  }
  double threshold(Extreme of, const double& from_s, const double& until_s) const override {
    return of == Extreme::normal_force ? greatest_ : Observer::threshold(of, from_s, until_s);
  }
  void on_maximum(const Maximum& maximum) override {
    if (maximum.of == Extreme::normal_force) note_force(maximum.at);
  }
  bool wants_dense_output(const double& from_s, const double&) const override {
    return run_.onset_ && from_s < run_.onset_->time_s + early_s;
  }
  void on_step(const DenseOutput& motion) override {
    constexpr int parts = 16;  // of a step of a turn at most
    for (int i = 0; i < parts; ++i)
      sample(motion.at(motion.from_s + (motion.until_s - motion.from_s) * i / parts));
  }

 private:
  void note_force(const Instant& at) {
    if (!at.touches()) return;
    const double force = at.contact_force(ring_, at.motion());
    if (force <= greatest_) return;
    greatest_ = force;
    run_.peak_ = at;
    run_.forces_.emplace_back(at.time_s, force);
  }
  void sample(const Instant& at) {
    if (!run_.onset_ || at.time_s > run_.onset_->time_s + 1.2 * early_s) return;
    const double angle = std::atan2(at.state[1], at.state[0]);
    if (!run_.samples_.empty()) turned_ += std::remainder(angle - angle_, two_pi);
    angle_ = angle;
    run_.samples_.push_back(
        {at.time_s, std::hypot(at.state[0], at.state[1]), turned_, at.state[2]});
  }

  PaperRun& run_;
  Ring<double> ring_;
  TouchDowns touch_downs_;
  Instant last_;
  double greatest_ = 0, angle_ = 0, turned_ = 0;
};

PaperRun::PaperRun(const Scenario& scenario, RunUps& run_ups) : scenario_(scenario) {
  PaperWatch watch(*this);
  const RunResult result =
      complete_run(run_ups.checkpoint_before(scenario, nobody), scenario, std::nullopt, watch);
  summary_ = result.summary;
  last_ = result.end.last;
}

std::size_t PaperRun::touch_downs_before_rolling() const {
  if (!onset_) return 0;
  const auto after = std::ranges::upper_bound(touch_downs_, onset_->time_s, {}, &Instant::time_s);
  return static_cast<std::size_t>(after - touch_downs_.begin());
}

std::optional<Instant> PaperRun::touch_down_before_rolling(std::size_t from_last) const {
  const std::size_t before = touch_downs_before_rolling();
  if (before <= from_last) return std::nullopt;
  return touch_downs_[before - 1 - from_last];
}

std::vector<PaperRun::Collision> PaperRun::collisions() const {
  std::vector<Collision> all;
  for (const Instant& release : releases_) {
    const auto next = std::ranges::upper_bound(touch_downs_, release.time_s, {}, &Instant::time_s);
    if (next != touch_downs_.begin())
      all.push_back(
          {release.time_s - std::prev(next)->time_s, release.state[5] - std::prev(next)->state[5]});
  }
  return all;
}

double PaperRun::change_of_speed_in_flight() const {
  double greatest = 0;
  for (const Instant& release : releases_) {
    const auto next = std::ranges::upper_bound(touch_downs_, release.time_s, {}, &Instant::time_s);
    if (next != touch_downs_.end())
      greatest = std::max(greatest, std::abs(next->state[5] / release.state[5] - 1));
  }
  return greatest;
}

std::optional<double> PaperRun::relative_peak() const {
  const Parameters& p = scenario_.parameters;
  if (!summary_.peak_normal_force_N) return std::nullopt;
  return *summary_.peak_normal_force_N /
         (p.mass * std::pow(before_loss_.state[5], 2) * (p.stator_radius - p.rotor_radius));
}

double PaperRun::peak_until(double time_s) const {
  double greatest = 0;
  for (const auto& [at_s, force] : forces_)
    if (at_s <= time_s) greatest = std::max(greatest, force);
  return greatest;
}

std::optional<PaperRun::Rolling> PaperRun::first_turn() const {
  for (const Sample& sample : samples_) {
    const double whirl = sample.turned + sample.q3 - samples_.front().q3;
    if (std::abs(whirl) > two_pi) return measured(sample.time_s - samples_.front().time_s);
  }
  return std::nullopt;
}

double PaperRun::off_sine(Samples from, Samples until) {
  const double rate = ((until->turned - from->turned) / (until->time_s - from->time_s));
  // Least squares of q1 by cosine and sine.
  double cc = 0, cs = 0, ss = 0, cq = 0, sq = 0, qq = 0;
  for (auto s = from; s != until; ++s) {
    const double weight = (s + 1)->time_s - s->time_s, phase = rate * (s->time_s - from->time_s);
    const double c = std::cos(phase), sine = std::sin(phase), q1 = s->rho * std::cos(s->turned);
    cc += weight * c * c, cs += weight * c * sine, ss += weight * sine * sine;
    cq += weight * c * q1, sq += weight * sine * q1, qq += weight * q1 * q1;
  }
  const double determinant = cc * ss - cs * cs;
  const double a = (cq * ss - sq * cs) / determinant, b = (sq * cc - cq * cs) / determinant;
  return std::sqrt(std::max(0., qq - a * cq - b * sq) / qq);
}

std::optional<PaperRun::Rolling> PaperRun::measured(double duration_s) const {
  const auto end = std::find_if(samples_.begin(), samples_.end(), [&](const Sample& sample) {
    return sample.time_s >= samples_.front().time_s + duration_s;
  });
  if (end == samples_.end()) return std::nullopt;
  const Sample &a = samples_.front(), &b = *end;
  const double time_s = b.time_s - a.time_s;
  const auto whirl_turns = [&](const Sample& s) {
    return std::abs(s.turned + s.q3 - a.q3) / two_pi;
  };
  double least = a.rho, greatest = a.rho, integral = 0;
  double first = 0, last = 0, first_s = 0, last_s = 0;
  for (auto s = samples_.begin(); s != end; ++s) {
    least = std::min(least, s->rho);
    greatest = std::max(greatest, s->rho);
    const double weight = (s + 1)->time_s - s->time_s;
    integral += s->rho * weight;
    if (whirl_turns(*s) < 1) {
      first += s->rho * weight;
      first_s += weight;
    }
    if (whirl_turns(*s) > whirl_turns(b) - 1) {
      last += s->rho * weight;
      last_s += weight;
    }
  }
  const double turns = std::max(1., whirl_turns(b) - 1);
  return Rolling{whirl_turns(b) / time_s, std::abs(b.turned) / two_pi / time_s,
                 (greatest - least) / (integral / time_s), off_sine(samples_.begin(), end),
                 (first / first_s - last / last_s) / (first / first_s) / turns};
}

/// The work of friction until each touch-down.
class FrictionWatch : public EnergyObserver {
 public:
  using EnergyObserver::EnergyObserver;

  void on_instant(const Instant& at) override {
    EnergyObserver::on_instant(at);
    if (at.event == Event::touch_down) until_touch_downs.push_back(-balance().work.friction);
  }

  std::vector<double> until_touch_downs;
};

const std::optional<PaperRuns::FrictionWork>& PaperRuns::friction_work() {
  if (friction_work_) return *friction_work_;
  friction_work_.emplace();
  const PaperRun& run = high();
  if (run.scenario().method == Method::event && run.onset()) {
    Scenario until_rolling = run.scenario();
    until_rolling.until = run.onset()->time_s;
    FrictionWatch watch(until_rolling);
    complete_run(run_ups_.checkpoint_before(until_rolling, nobody), until_rolling, std::nullopt,
                 watch);
    *friction_work_ = FrictionWork{watch.until_touch_downs, -watch.balance().work.friction};
  }
  return *friction_work_;
}

const Summary& PaperRuns::lost_at(double angle) {
  const auto found = lost_at_.find(angle);
  if (found != lost_at_.end()) return found->second;
  const PaperRun& opposite = high();
  Scenario scenario = opposite.scenario();
  scenario.tolerance = std::max(scenario.tolerance, 1e-8);  // there are many, and of few digits
  const Instant from =
      PlaceOfLoss(scenario.parameters, angle).lose_mass(opposite.before_loss(), scenario.equations);
  SummaryObserver observer(scenario);
  StopObserver stop(StopOn::outcome, scenario);
  ObserverGroup both{&observer, &stop};
  run(scenario, from, both);
  return lost_at_.emplace(angle, observer.summary()).first->second;
}

std::optional<double> PaperRuns::time_at_critical_speed() {
  const Parameters p = parameters();
  return run_ups_
      .time_at_speed(high().scenario(), in_Hz(std::sqrt(p.support_stiffness / p.mass)),
                     inputs_.t_operating, nobody)
      .time_s;
}

Parameters PaperRuns::parameters() {
  return scenario_of(at_operating_speed(inputs_.mu_high), run_ups_).parameters;
}

ScenarioSpec PaperRuns::spec_with(const std::map<std::string, double>& numbers) const {
  ScenarioSpec spec = inputs_.spec;
  for (const auto& [name, value] : numbers) spec.numbers[name] = value;
  return spec;
}

ScenarioSpec PaperRuns::at_operating_speed(double friction) const {
  return spec_with({{"friction", friction}, {"mass_loss_time", inputs_.t_operating}});
}

const PaperRun& PaperRuns::rub(double friction) { return get(at_operating_speed(friction)); }

const PaperRun& PaperRuns::high_by(Method method) {
  ScenarioSpec spec = at_operating_speed(inputs_.mu_high);
  spec.method = method;
  return get(spec);
}

const PaperRun& PaperRuns::changed(double friction, const char* quantity, double factor) {
  const PaperRun& as_it_is = rub(friction);
  ScenarioSpec spec = at_operating_speed(friction);
  spec.numbers[quantity] = factor * find_input_quantity(quantity)->quantity.of(as_it_is.scenario());
  return get(spec);
}

const PaperRun& PaperRuns::with(double friction, const std::map<std::string, double>& numbers) {
  ScenarioSpec spec = at_operating_speed(friction);
  for (const auto& [name, value] : numbers) spec.numbers[name] = value;
  return get(spec);
}

const PaperRun& PaperRuns::from_steady(double part) {
  const Parameters p = parameters();
  return get(spec_with({{"friction", inputs_.mu_high},
                        {"torque", 0},
                        {"start_speed_Hz", part * p.motor_off_Hz},
                        {"support_stiffness", part * part * p.support_stiffness}}));
}

const PaperRun& PaperRuns::loss_at(double time_s, double rub_s) {
  return get(spec_with(
      {{"friction", inputs_.mu_high}, {"mass_loss_time", time_s}, {"until", time_s + rub_s}}));
}

const PaperRun& PaperRuns::get(const ScenarioSpec& spec) {
  const Scenario scenario = scenario_of(spec, run_ups_);
  const auto found = std::find_if(runs_.begin(), runs_.end(),
                                  [&](const PaperRun& run) { return run.scenario() == scenario; });
  return found != runs_.end() ? *found : runs_.emplace_back(scenario, run_ups_);
}

}  // namespace rotor
