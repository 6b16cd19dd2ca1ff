/// The commands. All throw std::exception, stating what is wrong, where, and what is allowed; then
/// nothing is written.
#pragma once

#include "figures/input/scene.hpp"
#include "figures/program/drawing.hpp"
#include "figures/program/options.hpp"
#include "figures/sweep/sweep.hpp"

namespace rotor {

/// `rotor figure` writes the data of the paper's figures.
void write_figures(const FigureOptions& options);

/// `rotor plot` draws a scene or a sweep.
void plot(const PlotOptions& options);
void plot_sweep(const PlotOptions& options);
/// Spectra of displacement and force in the stator's frame, over the scene's window.
void plot_spectrum(const Scene& scene, const Drawing& drawing);

/// `rotor sweep` runs many rotors.
void run_sweep(const SweepOptions& options);
/// The same for a sweep that has been read, on all cores.
void write_sweep(const Sweep& sweep, const std::string& out);

/// `rotor run` runs any rotor.
void run_rotor(const RunOptions& options);

/// `rotor estimate` evaluates closed forms only.
void estimate_rotor(const CaseOptions& options);

/// The scene with the runs that were requested.
Scene scene_of(const CaseOptions& options);

}  // namespace rotor
