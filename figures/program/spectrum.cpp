#include "figures/program/spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

#include "figures/data/files.hpp"
#include "figures/program/commands.hpp"
#include "figures/program/progress.hpp"
#include "figures/results/provenance.hpp"
#include "model/mechanics/contact.hpp"

namespace rotor {
namespace {

using Complex = std::complex<double>;
using Signal = std::vector<Complex>;

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

constexpr std::array columns_of_spectrum = {
    Column{
        "frequency_Hz", "of the largest displacement within 0.4 %; negative: backward whirl", {}},
    Column{"displacement_m", "largest amplitude within 0.4 %: radius of a steady circle of O", {}},
    Column{"force_N", "the same of the contact force on the rotor in the stator's frame", {}}};

/// The largest amplitude in each step of frequency that a logarithmic axis can show.
Table spectrum(const Signals& signals, double length_s) {
  constexpr double step = 1.004;
  const std::vector<double> displacement = amplitudes(signals.displacement),
                            force = amplitudes(signals.force);
  const std::size_t count = displacement.size();
  Table table(columns_of_spectrum.size());
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
      table.add(std::array{backward ? -at_Hz : at_Hz, its_displacement, its_force});
    }
  return table;
}

}  // namespace

void plot_spectrum(const Scene& scene, const PlotOptions& options, const std::string& conditions) {
  if (scene.window.from_rolling_onset)
    throw InputError("--spectrum: needs a window that starts at a stated time; state --from");
  constexpr double samples_a_period = 16, most_samples = 1 << 22;
  Scene described = scene;
  described.columns.clear();
  for (const Column& column : columns_of_spectrum) described.columns.push_back(&column);
  const std::string title =
      fmt::format("Spectra from {} s {}, flat-top window{}{}", scene.window.from_s,
                  std::isfinite(scene.window.length_s)
                      ? fmt::format("to {} s", scene.window.from_s + scene.window.length_s)
                      : "on",
                  scene.title.empty() ? "" : ": ", scene.title);
  const std::string head = csv_head(title, described, "run");
  FileTransaction numbers(options.file);  // instead of a drawing
  std::optional<Drawing> drawing;
  std::string settings;
  if (const std::filesystem::path out = options.out; out.extension() == ".csv") {
    numbers.open(out).write(head);
  } else {
    drawing.emplace(options.file, options.out);
    settings = drawing->headings(scene.title, conditions) +
               fmt::format("known_runs = {}\n", scene.runs.size());
  }
  for (std::size_t n = 1; n <= scene.runs.size(); ++n) {
    const auto& [name, scenario] = std::tie(scene.runs[n - 1].name, scene.runs[n - 1].scenario);
    const Parameters& p = scenario.parameters;
    if (scenario.method == Method::rk4)
      throw InputError("--spectrum: only method event knows the motion between its steps");
    const double from_s = scene.window.from_s;
    const double length_s = std::min(scene.window.length_s, scenario.until - from_s);
    const double contact_Hz = in_Hz(std::sqrt(Ring<double>(p).typical_stiffness() / p.mass));
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
    const std::string of_run = csv_rows({{name, spectrum(signals, length_s)}});
    if (!drawing) {
      numbers.write_to_all(of_run);
      continue;
    }
    drawing->write(fmt::format("run{}.csv", n), head + of_run);
    settings += fmt::format(
        "run{0} = {1}; from_s{0} = {2}; until_s{0} = {3}; samples{0} = {4}; whirl{0} = {5}; f{0} = "
        "{6}; f_least{0} = {7}; f_greatest{0} = {8}; f_n{0} = {9}; rolls{0} = {10}\n",
        n, numbered(name), from_s, from_s + length_s, samples,
        whirl_s > 0 ? signals.turns / whirl_s : 0, signals.sum_Hz / rows, signals.least_Hz,
        signals.greatest_Hz, in_Hz(critical), signals.rolls ? 1 : 0);
  }
  if (drawing) drawing->finish(settings, "spectrum.gp");
  numbers.commit();
}

}  // namespace rotor
