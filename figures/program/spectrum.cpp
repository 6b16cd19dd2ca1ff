#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

#include "figures/program/commands.hpp"
#include "figures/program/progress.hpp"

namespace rotor {
namespace {

using Complex = std::complex<double>;
using Signal = std::vector<Complex>;

/// Amplitude at each frequency n / T: first n below half the number of samples, then the negative
/// ones. A steady rotation on a circle has the circle's radius as its amplitude. Hann's window
/// suppresses leakage from the ends of the time.
std::vector<double> amplitudes(Signal signal) {
  const auto count = static_cast<double>(signal.size());
  constexpr double mean_of_window = 0.5;
  for (std::size_t k = 0; k < signal.size(); ++k)
    signal[k] *= (1 - std::cos(two_pi * static_cast<double>(k) / count)) / 2;
  Signal transformed;
  Eigen::FFT<double>().fwd(transformed, signal);
  std::vector<double> all;
  for (const Complex& value : transformed)
    all.push_back(std::abs(value) / (mean_of_window * count));
  return all;
}

/// Displacement of O from O_a, and contact force on the rotor, in the stator's frame.
struct Signals {
  Signal displacement, force;
  double turns = 0;    ///< of O about O_a, while the rim rolls,
  long rows = 0;       ///< within this number of rows
  bool rolls = false;  ///< whether it does
  double least_Hz = std::numeric_limits<double>::infinity(), greatest_Hz = 0, sum_Hz = 0;

  static std::vector<const Column*> columns() {
    return parse_columns(
        {"x_a_m", "y_a_m", "normal_force_N", "friction_force_N", "speed_Hz", "contact_state"});
  }
  void add(std::span<const double> row) {
    const Complex place(row[0], row[1]);
    const Complex outwards = place == 0. ? 1. : place / std::abs(place);
    const bool rolls_now = row[5] == static_cast<double>(ContactState::rolling);
    if (rolls_now && !rolls) {
      rolls = true;
    } else if (rolls_now) {
      turns += std::arg(place * std::conj(displacement.back())) / two_pi;
      ++rows;
    }
    displacement.push_back(place);
    force.push_back(Complex(row[2], row[3]) * outwards);
    least_Hz = std::min(least_Hz, row[4]);
    greatest_Hz = std::max(greatest_Hz, row[4]);
    sum_Hz += row[4];
  }
};

/// The largest amplitude in each step of frequency that a logarithmic axis can show, backward whirl
/// at negative frequencies.
std::string spectrum(const Signals& signals, double length_s) {
  constexpr double step = 1.004;
  const std::vector<double> displacement = amplitudes(signals.displacement),
                            force = amplitudes(signals.force);
  const std::size_t count = displacement.size();
  std::string csv = "frequency_Hz,displacement_m,force_N\n";
  for (const bool backward : {true, false})
    for (std::size_t n = 1; n < count / 2;) {
      const double from_Hz = static_cast<double>(n) / length_s;
      double its_displacement = 0, its_force = 0, at_Hz = from_Hz;
      for (; n < count / 2 && static_cast<double>(n) / length_s < step * from_Hz; ++n) {
        const std::size_t at = backward ? count - n : n;
        if (displacement[at] > its_displacement) at_Hz = static_cast<double>(n) / length_s;
        its_displacement = std::max(its_displacement, displacement[at]);
        its_force = std::max(its_force, force[at]);
      }
      csv += fmt::format("{},{},{}\n", backward ? -at_Hz : at_Hz, its_displacement, its_force);
    }
  return csv;
}

}  // namespace

void plot_spectrum(const Scene& scene, const Drawing& drawing) {
  if (scene.window.from_rolling_onset)
    throw InputError("--spectrum: needs a window that starts at a stated time; state --from");
  constexpr double samples_a_period = 16, most_samples = 1 << 22;
  std::string settings = fmt::format("heading = {}; runs = {}\n",
                                     numbered(drawing.heading(scene.title)), scene.runs.size());
  for (std::size_t n = 1; n <= scene.runs.size(); ++n) {
    const auto& [name, scenario] = std::tie(scene.runs[n - 1].name, scene.runs[n - 1].scenario);
    const Parameters& p = scenario.parameters;
    if (scenario.method == Method::rk4)
      throw InputError("--spectrum: only method event knows the motion between its steps");
    const double from_s = scene.window.from_s;
    const double length_s = std::min(scene.window.length_s, scenario.until - from_s);
    const double contact_Hz = in_Hz(std::sqrt(p.contact_stiffness / p.mass));
    const double wanted = samples_a_period * length_s *
                          std::max({contact_Hz, p.motor_off_Hz, scenario.start_speed_Hz});
    const double samples = std::exp2(std::ceil(std::log2(std::max(wanted, 1024.))));
    if (samples > most_samples)
      throw InputError(
          "--spectrum: {} s need {:.2g} samples, and the limit is {:.2g}; state --from and --until",
          length_s, wanted, most_samples);
    Signals signals;
    Sampler sampler(from_s, from_s + length_s, length_s / samples, Signals::columns(), scenario,
                    [&](auto row) { signals.add(row); });
    RunProgress progress(scenario.until);
    ObserverGroup observers = {&progress, &sampler};
    static_cast<void>(run(scenario, observers));
    if (is_interrupted()) throw Interrupted();
    const auto rows = static_cast<double>(signals.force.size());
    const double critical = std::sqrt(SupportSprings<double>(p).tangent_stiffness(0) / p.mass);
    const double whirl_s = static_cast<double>(signals.rows) * length_s / samples;
    signals.displacement.resize(static_cast<std::size_t>(samples));
    signals.force.resize(static_cast<std::size_t>(samples));
    drawing.write(fmt::format("run{}.csv", n), spectrum(signals, length_s));
    settings += fmt::format(
        "run{0} = {1}; from_s{0} = {2}; until_s{0} = {3}; samples{0} = {4}; whirl{0} = {5}; f{0} = "
        "{6}; f_least{0} = {7}; f_greatest{0} = {8}; f_n{0} = {9}; rolls{0} = {10}\n",
        n, numbered(name), from_s, from_s + length_s, samples,
        whirl_s > 0 ? signals.turns / whirl_s : 0, signals.sum_Hz / rows, signals.least_Hz,
        signals.greatest_Hz, in_Hz(critical), signals.rolls ? 1 : 0);
  }
  drawing.finish(settings, "spectrum.gp");
}

}  // namespace rotor
