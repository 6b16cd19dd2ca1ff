/// What the program does. All throw std::exception, saying what is wrong, where, and what would be
/// right; then nothing is written.
#pragma once

#include "figures/input/scene.hpp"
#include "figures/program/options.hpp"

namespace rotor {

/// `rotor figure` writes the data of the paper's figures.
void write_figures(const FigureOptions& options);

/// `rotor plot` draws a scene.
void plot_scene(const PlotOptions& options);

/// `rotor sweep` runs many rotors.
void run_sweep(const SweepOptions& options);

/// `rotor run` runs any rotor.
void run_rotor(const RunOptions& options);

/// `rotor estimate` answers by closed forms alone.
void estimate_rotor(const CaseOptions& options);

/// The scene with the runs that are asked for.
Scene scene_of(const CaseOptions& options);

}  // namespace rotor
