/// The command line: `rotor figure` writes the data of the paper's figures, `rotor run` runs any
/// rotor. What it states ends in the structures of options.hpp.
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "figures/data/interruption.hpp"
#include "figures/data/text.hpp"
#include "figures/input/scene.hpp"
#include "figures/program/commands.hpp"

namespace rotor {
namespace {

/// A text that a function can parse, or which it refuses by an InputError.
template <class Parse>
CLI::Validator parsed_by(Parse parse) {
  return {[parse](const std::string& text) -> std::string {
            try {
              return parse(text), "";
            } catch (const InputError& error) {
              return error.what();
            }
          },
          "", ""};
}

/// Such as 02, the number of a figure, which is not octal.
CLI::Validator whole_number() {
  return {[](std::string& text) -> std::string {
            if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos)
              return fmt::format("must be a whole number, not \"{}\"", shown(text));
            text.erase(0, std::min(text.find_first_not_of('0'), text.size() - 1));
            constexpr std::size_t most_digits = 18;  // that a long can have
            return text.size() > most_digits ? fmt::format("{}: is too large", shown(text)) : "";
          },
          ""};
}

CLI::Validator a_number() { return {unless_number, "", ""}; }

CLI::Validator not_empty(const char* what = "a file") {
  return {[what](const std::string& text) -> std::string {
            return text.empty() ? fmt::format("must name {}", what) : "";
          },
          "", ""};
}

/// An option whose text names something.
template <class Kind>
void add_named(CLI::App& command, const char* option, std::optional<Kind>& into,
               Kind (*parse)(std::string_view), Kind standard, const char* meaning) {
  command
      .add_option_function<std::string>(
          option, [&into, parse](const std::string& text) { into = parse(text); }, meaning)
      ->check(parsed_by(parse))
      ->default_str(std::string(name_of(standard)));
}

void add_options(CLI::App& command, CommonOptions& options) {
  ScenarioSpec& stated = options.equations_and_method;
  const Scenario standard;
  add_named(command, "--equations", stated.equations, parse_equations, standard.equations,
            "published (as printed: twice, whole) or consistent (once, balanced)");
  add_named(command, "--velocity-jump", stated.velocity_jump, parse_velocity_jump,
            standard.equations.velocity_jump,
            "once or twice: how often the mass loss adds Delta_vy to the velocity of C");
  add_named(command, "--gravity-moment", stated.gravity_moment, parse_gravity_moment,
            standard.equations.gravity_moment,
            "whole (as printed) or balanced by the springs but for the part of the eccentricity");
  add_named(command, "--method", stated.method, parse_method, standard.method,
            "event (located contacts, error control) or rk4 (the paper's fixed steps)");
}

constexpr const char* precedence =
    "What a [[run]] of a scene states itself takes precedence over these options.";

void add_options(CLI::App& command, FigureOptions& options) {
  options.scenes = ROTOR_SCENES;
  command.add_option("numbers", options.numbers, "figures; all if none is given")
      ->transform(whole_number());
  command.add_option("--out", options.out, "folder for figNN.csv")
      ->check(not_empty())
      ->capture_default_str();
  command.add_option("--scenes", options.scenes, "folder with the scene files figNN.toml")
      ->default_str("the paper's");
  add_options(command, static_cast<CommonOptions&>(options));
  command.footer(precedence);
}

void add_options(CLI::App& command, PlotOptions& options) {
  command
      .add_option("file", options.file,
                  "scene or sweep file (TOML), or the results of a sweep (CSV)")
      ->required()
      ->check(not_empty());
  command
      .add_option("--out", options.out,
                  "picture, svg, pdf or png by its ending; the file's name with .svg, if not given")
      ->check(not_empty());
  const auto add_time = [&](const char* name, std::optional<double>& time, const char* meaning) {
    command.add_option(name, time, meaning)->type_name("s")->check(a_number());
  };
  add_time("--from", options.from_s,
           "beginning of what is drawn; the scene's window, or shortly before the first mass loss, "
           "if not given");
  add_time("--until", options.until_s, "end of what is drawn, instead of the run's");
  command.add_flag("--spectrum", options.spectrum,
                   "draw the spectrum of displacement and force in the stator's frame over that "
                   "time, with f, 2f, f_n and the whirl marked");
  command
      .add_option("--column", options.column,
                  "result of a sweep that is drawn beside the outcome; the largest normal force, "
                  "if not given")
      ->check(not_empty("a column"));
  add_options(command, static_cast<CommonOptions&>(options));
  command.footer(precedence);
}

void add_options(CLI::App& command, SweepOptions& options) {
  command
      .add_option("file", options.file, "sweep file (TOML): a scene's parameters and what varies")
      ->required()
      ->check(not_empty());
  auto* out =
      command
          .add_option("--out", options.out, "write the results, a row a point, to this CSV file")
          ->check(not_empty());
  command.add_option("--jobs", options.jobs, "threads; as many as there are cores, if not given")
      ->transform(whole_number())
      ->check(CLI::Range(1, 4096));
  command
      .add_flag("--dry-run", options.dry_run,
                "say how many points there are, and about how long they take")
      ->excludes(out);
}

void add_options(CLI::App& command, CaseOptions& options) {
  auto* scene = command
                    .add_option("--scene", options.scene,
                                "scene file (TOML); options override what it states")
                    ->check(not_empty());
  command.add_option("--run", options.run_name, "which [[run]] of the scene, if it has several")
      ->check(not_empty("a run"))
      ->needs(scene);
  for (const InputQuantity& input_quantity : input_quantities()) {
    const Quantity& quantity = input_quantity.quantity;
    const std::string option = option_of(quantity.name);
    const std::string meaning = fmt::format(
        "{}{}{}{}", quantity.meaning, quantity.symbol.empty() ? "" : ", ", quantity.symbol,
        input_quantity.instead_of.empty() ? ""
                                          : ", instead of " + option_of(input_quantity.instead_of));
    CLI::Option* const added = command.add_option_function<std::string>(
        option,
        [&options, &quantity](const std::string& text) {
          state_number(options.numbers, quantity, text);
        },
        meaning);
    added->type_name(quantity.unit.empty() ? "number" : std::string(quantity.unit));
    if (quantity.name == "until")
      added->default_str("0.25 s after the mass loss");
    else if (quantity.name == "mass_loss_time")
      added->default_str(fmt::format("{}, or 0 with --start-speed-hz", quantity.of(Scenario{})));
    else if (quantity.in)
      added->default_str(fmt::format("{}", quantity.of(Scenario{})));
  }
  command.add_flag_callback(
      "--no-mass-loss", [&options] { options.numbers.loses_mass = false; }, "no mass is lost");
  add_options(command, static_cast<CommonOptions&>(options));
  command.add_flag("--json", options.json, "print the results as JSON");
}

void add_options(CLI::App& command, RunOptions& options) {
  add_options(command, static_cast<CaseOptions&>(options));
  command
      .add_option_function<std::string>(
          "--stop-on",
          [&options](const std::string& text) { options.stop_on = parse_stop_on(text); },
          "end at the outcome, once an event decides it, at rolling (and the force's first maximum "
          "then), or at rest (a second below 0.1 Hz), if that comes before --until")
      ->check(parsed_by(parse_stop_on));
  auto* trace = command
                    .add_option("--trace", options.trace,
                                "write the motion inside the window to this CSV file; - is "
                                "standard output")
                    ->check(not_empty());
  command
      .add_option("--columns", options.columns,
                  "columns of the trace, comma-separated; the scene's, or all, if not given; "
                  "help lists them")
      ->delimiter(',');
  command
      .add_option("--from", options.from_s,
                  "beginning of the trace, which then extends to the end of the run; the "
                  "scene's window, or shortly before the mass loss, if not given")
      ->type_name("s")
      ->check(a_number())
      ->needs(trace);
  auto* every =
      command
          .add_option("--every", options.every_s,
                      "rows of the trace at this distance, as spectra want it; if neither "
                      "this nor --rows is given, as many as the curves need")
          ->type_name("s")
          ->check(a_number())
          ->needs(trace);
  command
      .add_option("--rows", options.rows,
                  "so many rows of the trace at equal distances, the first and the last instant "
                  "included; fewer if the run stops early")
      ->transform(whole_number())
      ->needs(trace)
      ->excludes(every);
  command
      .add_option("--events", options.events,
                  "write time, kind, state, normal force and slip of the located events to this "
                  "CSV file")
      ->check(not_empty());
  auto* digits = command.add_option_function<double>(
      "--digits", [&options](double number) { options.numbers.digits = parse_digits(number); },
      "significant digits that every value, event and the end are to have for certain, instead of "
      "--tolerance; --json adds errors and events");
  digits->check(a_number());
  command.add_option("--budget", options.budget_s, "how long to look for the digits of a run")
      ->type_name("s")
      ->check(a_number())
      ->default_str(fmt::format("{}", RunOptions::usual_budget_s));
  command
      .add_flag("--estimate-error", options.estimate_error,
                "estimate the relative error of the summary, by another run")
      ->excludes(digits);
  command.add_flag("--json-schema", options.json_schema,
                   "print the JSON schema of the summary instead: what each key means");
  command.add_flag(
      "--energy", options.energy,
      "say in the summary where the energy goes from the mass loss on, until rolling and "
      "until the end");
  command.add_flag("--keep-partial", options.keep_partial,
                   "when interrupted, write what was computed until then, marked as cut short");
}

/// A command whose options are filled in, and which is run then.
template <class Options>
void add_command(CLI::App& app, const char* name, const char* does, Options& options,
                 void (*run)(const Options&)) {
  CLI::App* command = app.add_subcommand(name, does);
  add_options(*command, options);
  command->callback([&options, run] { run(options); });
}

/// What to say of words that mean nothing here: what they probably should have been.
std::string about_extras(const CLI::App& app) {
  const std::vector<std::string> extras = app.remaining(true);
  const auto commands = app.get_subcommands();
  if (extras.empty()) return "";
  const std::string& word = extras.front();
  std::vector<std::string> names;
  if (commands.empty()) {
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    return fmt::format("{}: there is no such command{}; the commands are: {}", shown(word),
                       suggestion(word, names), fmt::join(names, ", "));
  }
  for (const CLI::Option* option : commands.front()->get_options()) {
    const std::string name = option->get_name();
    if (name.starts_with('-')) names.push_back(name);
  }
  const std::string option = word.substr(0, word.find('='));
  return fmt::format("{}: there is no such option of {}{}; rotor {} --help lists them",
                     shown(option), commands.front()->get_name(), suggestion(option, names),
                     commands.front()->get_name());
}

/// Files must not be opened in the place of standard streams that were closed: what is printed
/// would end in them. What takes their place cannot be written.
void occupy_standard_streams() {
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor)
    if (::fcntl(descriptor, F_GETFD) < 0 && ::open("/dev/null", O_RDONLY) < 0) std::abort();
}

int main(int argc, char** argv) {
  occupy_standard_streams();
  static_cast<void>(std::signal(SIGPIPE, SIG_IGN));  // a lost reader is an error like any other
  note_interruptions();
  CLI::App app("Overcritical rotor, mass loss, rub: the paper's figures, and any other case.");
  app.set_version_flag("--version", "rotor " ROTOR_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(36);
  FigureOptions figure;
  PlotOptions plot_options;
  RunOptions run;
  CaseOptions estimate;
  SweepOptions sweep;
  add_command(app, "figure", "Write the data of the paper's figures as CSV", figure, write_figures);
  add_command(app, "plot", "Draw the motions of a scene, their spectrum, or a sweep", plot_options,
              plot);
  add_command(app, "run", "Run any rotor and mass loss", run, run_rotor);
  add_command(app, "estimate", "Estimate by closed forms, without a run, what happens to a rotor",
              estimate, estimate_rotor);
  add_command(app, "sweep", "Run many, of which some quantities vary", sweep, run_sweep);
  int status = 0;
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // help, version
    status = app.exit(success);
  } catch (const CLI::ParseError& error) {
    const std::string extras = about_extras(app);
    const std::string message = extras.empty() ? error.what() : extras;
    constexpr std::size_t line = 400;
    print_message("rotor: " + message.substr(0, line));
    status = error.get_exit_code();
  } catch (const Interrupted& error) {
    print_message(fmt::format("rotor: {}", error.what()));
    status = 128 + interrupting_signal();  // as shells have it
  } catch (const std::exception& error) {
    print_message(fmt::format("rotor: {}", error.what()));
    status = 1;
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    print_message(
        fmt::format("rotor: standard output cannot be written: {}", std::strerror(errno)));
    status = status == 0 ? 1 : status;
  }
  return status;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::main(argc, argv); }
