/// The commands, and what can be stated on the command line; empty: not stated. All throw
/// std::exception, stating what is wrong, where, and what is allowed; then nothing is written.
#pragma once

#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "figures/program/drawing.hpp"
#include "figures/record/section.hpp"
#include "figures/results/json.hpp"
#include "figures/runs/scene.hpp"
#include "figures/sweep/part.hpp"
#include "figures/sweep/sweep.hpp"

namespace rotor {

struct FigureOptions {
  ScenarioSpec stated;       ///< equations, method and drive
  std::vector<int> numbers;  ///< all if empty
  std::string out = ".";
  std::string scenes;  ///< folder with figNN.toml
};

struct PlotOptions {
  ScenarioSpec stated;
  std::string file;  ///< a scene, or the results of a sweep
  std::string out;   ///< if empty, the file's name with .svg
  std::optional<double> from_s, until_s;
  std::vector<std::string> columns;  ///< of a sweep; the usual ones if empty
  std::string drafts;                ///< folder for what gnuplot needs, instead of a picture
};

struct SweepOptions {
  std::string file;
  std::string out;                 ///< the file's name with .csv, and the part, if empty
  int jobs = 0;                    ///< threads; 0: as many as there are cores
  std::optional<double> budget_s;  ///< of each point
  std::optional<Part> part;        ///< the only one to compute
  bool join = false;               ///< write the results from those of all parts
  bool retry = false;              ///< keep the rows of earlier results that are no refusals
  bool force = false;              ///< compute results again that are complete
};

/// The case to run or estimate.
struct CaseOptions {
  ScenarioSpec stated;
  std::string scene, run_name;
  bool json = false;
  bool all = false;  ///< print every result as text
};

/// What is above the rows of a file: its provenance in lines that start with #, and the names of
/// its columns.
enum class CsvHeader { full, names, none };

template <>
inline constexpr auto names_of<CsvHeader> = std::to_array<Named<CsvHeader>>(
    {{"full", CsvHeader::full}, {"names", CsvHeader::names}, {"none", CsvHeader::none}});

struct RunOptions : CaseOptions {
  std::string trace, events, section;  ///< files to write
  long section_turns = Section::usual_turns;
  std::vector<std::string> columns;
  std::optional<double> from_s;
  std::optional<double> every_s;    ///< equal intervals; adaptive if it is not stated
  std::optional<CsvHeader> header;  ///< of these files; full
  std::optional<StopOn> stop_on;
  bool json_schema = false;
  std::optional<double> budget_s;  ///< of each run with digits
  bool energy = false;             ///< by cause, in the summary
};

void write_figures(const FigureOptions& options);
void plot(const PlotOptions& options);
void plot_sweep(const PlotOptions& options);
void run_sweep(const SweepOptions& stated);
void run_rotor(const RunOptions& options);
void estimate_rotor(const CaseOptions& options);

/// The scene with the runs that were requested.
Scene scene_of(const CaseOptions& options, RunUps& run_ups);

/// Names and values; those of a part follow its name. Inputs have fifteen digits.
void print_all(const Json& object, std::FILE* to, const std::string& indent = "",
               bool are_inputs = false);

/// What a person asks first: the outcome as a sentence, the remarks, and some results in ms, mm and
/// kN; speeds in revolutions per minute if they are stated so.
void print_brief(const Json& run, bool in_rpm, std::FILE* to);

/// The closed forms of one run or several in these units, each with its assumption.
void print_laws(const Json& runs, bool in_rpm, std::FILE* to);

/// Several runs: one row each, with the most important results in these units.
void print_table(const Json& runs, bool in_rpm, std::FILE* to);

/// Says on standard error which values are the paper's, if others are stated; not of its scenes.
void say_what_is_assumed(const Scene& scene);
void say_what_is_assumed(const Sweep& sweep);
/// Says on standard error how many points of a sweep have remarks, if any has.
void say_how_many_have_remarks(long remarked, long points);

}  // namespace rotor
