#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures/data/files.hpp"
#include "figures/program/commands.hpp"
#include "figures/program/progress.hpp"
#include "figures/results/estimated_result.hpp"
#include "figures/results/event_log.hpp"
#include "figures/results/provenance.hpp"
#include "figures/results/section_result.hpp"

namespace rotor {
namespace {

bool has_run_with_digits(const Scene& scene) {
  return std::any_of(scene.runs.begin(), scene.runs.end(),
                     [](const SceneRun& run) { return run.stated.digits.has_value(); });
}

/// Refuses options that have no meaning with digits.
void require_digits_to_be_known(const RunOptions& options, const SceneRun& run) {
  const auto refuse = [](bool is_asked, std::string_view what) {
    if (is_asked) throw InputError("digits: {}", what);
  };
  if (!run.stated.digits) return;
  if (options.budget_s) require_budget("--budget", *options.budget_s);
  refuse(options.stop_on.has_value(), "excludes --stop-on: where a run stops depends on its steps");
  refuse(!options.trace.empty(), "are not estimated in a --trace");
  refuse(!options.events.empty(), "excludes --events; --json has the events");
  refuse(!options.section.empty(), "are not estimated in a --section");
  refuse(options.energy, "are not estimated for --energy");
}

/// Refuses a section of a motion that has no turns of one length up to its end.
void require_turns(const RunOptions& options, const SceneRun& run, bool is_alone) {
  if (options.section.empty()) return;
  if (options.stop_on)
    throw InputError("--section: excludes --stop-on: it has the last turns before until");
  try {
    whole_turns(run.scenario);
  } catch (const ScenarioError& error) {
    throw InputError("--section: {}{}", is_alone ? "" : run.name + ": ",
                     as_stated(error.message(), run.stated).text());
  }
}

/// The scene, with everything that the options state.
Scene requested_scene(const RunOptions& options, RunUps& run_ups) {
  Scene result = scene_of(options, run_ups);
  if (result.runs.size() > 1 && !options.json && options.energy)
    throw InputError("{}: with several runs, --energy needs --json, or --run", options.scene);
  if (options.budget_s && !has_run_with_digits(result))
    throw InputError("digits: --budget needs a number of --digits");
  for (const SceneRun& run : result.runs) {
    if (!options.events.empty() && run.scenario.method == Method::rk4)
      throw InputError("--events: only --method event locates events");
    if (options.energy && run.scenario.method == Method::rk4)
      throw InputError("--energy: only --method event knows the motion between its steps");
    require_digits_to_be_known(options, run);
    require_turns(options, run, result.runs.size() == 1);
  }
  result.window = stated_window(result.window, options.from_s, std::nullopt, result.runs);
  if (!options.columns.empty()) try {
      result.columns = parse_columns(options.columns);
    } catch (const InputError& error) {
      throw InputError("--columns: {}", error.what());
    }
  if (result.columns.empty()) result.columns = all_columns();
  return result;
}

double end_of(const Scene& scene) {
  return std::min(scene.runs.front().scenario.until, scene.window.from_s + scene.window.length_s);
}

[[noreturn]] void refuse_empty_trace(const RunOptions& options) {
  throw InputError("--trace {}: no part of a run lies in the window", shown(options.trace));
}

/// The interval between the rows of a trace, if it is to be constant.
std::optional<double> distance(const RunOptions& options, const Scene& scene) {
  if (!options.every_s) return std::nullopt;
  if (scene.runs.front().scenario.method == Method::rk4)
    throw InputError("--every: only --method event knows the motion between its steps");
  if (scene.window.from_rolling_onset)
    throw InputError("--every: needs a window that starts at a stated time");
  const double length_s = end_of(scene) - scene.window.from_s;
  constexpr double most_rows = 1e7;
  if (!(length_s > 0)) refuse_empty_trace(options);
  if (!(*options.every_s > 0 && length_s / *options.every_s < most_rows))
    throw InputError("--every {}: must be above 0 s, and large enough for less than {} rows",
                     *options.every_s, most_rows);
  return options.every_s;
}

/// What is printed about a run.
struct RunReport {
  Json summary{};
  std::vector<Remark> remarks{};
  std::string short_of_digits{};  ///< the reason; empty if it has all digits
};

/// A run to so many digits.
RunReport run_with_digits(const RunOptions& options, const SceneRun& run) {
  const int digits = *run.stated.digits;
  const Interruptible monitor(options.budget_s.value_or(usual_budget_s));
  ProgressLine line;
  double last_s = 0;
  int computation = 1;
  const Comparison found = comparison_to_digits(run.scenario, digits, monitor, [&](double time_s) {
    if (time_s < last_s) ++computation;
    last_s = time_s;
    line.update([&](double elapsed_s) {
      return fmt::format("computation {} for {} digits is at {:.6g} s of {:.6g} s after {}",
                         computation, digits, time_s, run.scenario.until, duration(elapsed_s));
    });
  });
  return {to_json(found, run.scenario, digits), remarks(result_of(found, run.scenario)),
          complaint(found, digits, monitor)};
}

void say_what_is_traced(const RunOptions& options, const Scene& scene, long rows) {
  const bool is_all = options.from_s || scene.window.from_s == 0;
  print_message(fmt::format(
      "rotor: --trace {}: {} rows of {} columns{}", shown(options.trace), rows,
      scene.columns.size() + 1,
      is_all
          ? ""
          : fmt::format(", from {:.6g} s on; --from 0 writes the whole run", scene.window.from_s)));
}

/// The files that the runs of a scene write: rows as they are computed, so that a long trace needs
/// no memory.
class Files {
 public:
  FileTransaction all;
  OutputFile *trace = nullptr, *events = nullptr, *section = nullptr;
  long rows = 0;  ///< of the trace

  Files(const RunOptions& options, const Scene& scene) : all(options.scene) {
    const std::string of_run =
        (scene.runs.size() > 1 ? " of runs" : " of a run") +
        (options.stop_on ? fmt::format(" until {}", name_of(*options.stop_on)) : "");
    const auto open = [&](const std::string& file, const char* what,
                          std::vector<const Column*> columns, std::string_view names) {
      if (file.empty()) return static_cast<OutputFile*>(nullptr);
      Scene log = scene;
      log.columns = std::move(columns);
      OutputFile& opened = all.open(file);
      opened.write(shortened(csv_head(what + of_run, log, names), options.header));
      return &opened;
    };
    trace = open(options.trace, "Trace", scene.columns, "run");
    events = open(options.events, "Events", EventLog::columns(), "run,event");
    section = open(options.section, "Last turns", Section::columns(), "run");
  }

 private:
  static std::string shortened(const std::string& head, std::optional<CsvHeader> header) {
    if (!header || header == CsvHeader::full) return head;
    return header == CsvHeader::none ? "" : head.substr(start_of_header_row(head));
  }
};

/// One run, which adds to the files. Throws Interrupted.
RunReport run_one(const RunOptions& options, const Scene& scene, Files& files, RunUps& run_ups) {
  const std::string& name = scene.runs.front().name;
  const Scenario& scenario = scene.runs.front().scenario;
  RunProgress progress(scenario.until, options.stop_on);
  ObserverGroup observers = {&progress};
  std::optional<EnergyObserver> energy;
  if (options.energy) observers.add(energy.emplace(scenario));
  std::optional<Recorder> trace;
  std::optional<Sampler> samples;
  if (files.trace) {
    const RowSink sink = [&](auto row) {
      files.trace->write(csv_row(name, row));
      ++files.rows;
    };
    if (const auto every_s = distance(options, scene))
      observers.add(samples.emplace(scene.window.from_s, end_of(scene), *every_s, scene.columns,
                                    scenario, sink));
    else
      observers.add(trace.emplace(scene.window, scene.columns, scenario, sampling, sink));
  }
  std::optional<EventLog> events;
  if (files.events) {
    events.emplace(scenario, [&](std::string_view event, auto row) {
      files.events->write(csv_field(name) + ',' + csv_row(event, row));
    });
    observers.add(*events);
  }

  std::optional<Section> section;
  if (files.section)
    observers.add(section.emplace(scenario, options.section_turns,
                                  [&](auto row) { files.section->write(csv_row(name, row)); }));

  // A run that writes files starts at its beginning, so that observers see all of it.
  const bool writes = files.trace || files.events || files.section;
  RunResult result = complete_run(
      writes ? RunUpCheckpoint(scenario) : run_ups.checkpoint_before(scenario, progress), scenario,
      options.stop_on, observers);
  if (is_interrupted()) throw Interrupted();
  if ((trace && trace->rows() == 0) || (samples && samples->rows() == 0))
    refuse_empty_trace(options);
  RunReport report{to_json(result), remarks(result)};
  if (energy) report.summary["energy_J"] = to_json(*energy);
  if (energy && result.early.leaves_rest_open()) report.summary["energy_J"]["until_end"] = nullptr;
  if (section) report.summary["section"] = to_json(section->summary());
  return report;
}

}  // namespace

void run_rotor(const RunOptions& options) {
  if (options.columns == std::vector<std::string>{"help"}) {
    for (const Column* column : all_columns())
      fmt::print("{}", wrapped(fmt::format("{:<24}", column->name), std::string(column->meaning)));
    return;
  }
  if (options.json_schema) return fmt::print("{}\n", summary_schema().dump(2));
  if (!options.columns.empty() && options.trace.empty())
    throw InputError("--columns requires --trace, or is help");
  if (options.header && options.trace.empty() && options.events.empty() && options.section.empty())
    throw InputError("--header requires --trace, --events or --section");
  RunUps run_ups;
  const Scene scene = requested_scene(options, run_ups);
  const bool one_of_many = scene.runs.size() > 1;
  const bool all = options.all || has_run_with_digits(scene),  // which were asked of every result
      is_brief = !one_of_many && !all && !options.json;
  Files files(options, scene);
  auto runs = Json::array();
  std::vector<std::string> messages, failures;
  bool in_rpm = false;
  for (const SceneRun& run : scene.runs) {
    const auto of_run = [&](const std::string& sentence) {
      return one_of_many ? run.name + ": " + sentence : sentence;
    };
    Scene alone = scene;
    alone.runs = {run};
    RunReport report;
    try {
      report = run.stated.digits ? run_with_digits(options, run)
                                 : run_one(options, alone, files, run_ups);
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {  // the other runs are not affected
      failures.push_back(of_run(error.what()));
      continue;
    }
    for (std::size_t n = 0; n < report.remarks.size(); ++n) {
      const std::string sentence = as_stated(report.remarks[n].message, run.stated).text();
      if (!options.json) report.summary["remarks"][n] = sentence;
      if (!is_brief &&  // which shows them, as a table does not
          (report.remarks[n].of == Remark::Of::missed_stop ||
           report.remarks[n].of == Remark::Of::missed_loss || (one_of_many && !options.json)))
        messages.push_back(of_run(sentence));
    }
    in_rpm = in_rpm || run.stated.states_rpm();
    if (!report.short_of_digits.empty()) failures.push_back(of_run(report.short_of_digits));
    Json row;
    if (one_of_many) row["run"] = run.name;
    row.update(report.summary);
    runs.push_back(row);
  }
  if (failures.empty()) {
    files.all.commit();
    if (files.trace && !is_standard_output(options.trace))
      say_what_is_traced(options, scene, files.rows);
  }
  const bool standard_output_is_taken = is_standard_output(options.trace) ||
                                        is_standard_output(options.events) ||
                                        is_standard_output(options.section);
  std::FILE* const to = standard_output_is_taken ? stderr : stdout;
  if (options.json && !runs.empty())
    fmt::print(to, "{}\n", (one_of_many ? Json{{"runs", runs}} : runs.front()).dump(2));
  else if (one_of_many && !options.all && !runs.empty())
    print_table(runs, in_rpm, to);
  else
    for (const Json& run : runs) is_brief ? print_brief(run, in_rpm, to) : print_all(run, to);
  print_before_messages();
  for (const std::string& message : messages) print_message("rotor: " + message);
  if (!runs.empty()) say_what_is_assumed(scene);
  if (options.scene.empty() && options.stated == ScenarioSpec())
    print_message(
        "rotor: as printed in the paper: --equations published; that gives other numbers");
  report_failures(failures);
}

}  // namespace rotor
