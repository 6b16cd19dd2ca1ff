/// The command line. What it states is stored in the structures of commands.hpp.
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <set>
#include <sstream>

#include "figures/program/commands.hpp"
#include "figures/results/estimated_result.hpp"
#include "figures/results/laws.hpp"
#include "figures/results/version.hpp"
#include "figures/sweep/join.hpp"

namespace rotor {
namespace {

/// Help whose lines fit a terminal of 80 columns.
class Help : public CLI::Formatter {
 public:
  Help() {
    column_width(29);
    label("TEXT", "NAME");
    label("INT", "N");
    label("FLOAT", "N");
  }

  /// A blank line before the footer, in every version of CLI11.
  std::string make_help(const CLI::App* command, std::string name,
                        CLI::AppFormatMode mode) const override {
    return make_description(command) + make_usage(command, std::move(name)) +
           make_positionals(command) + make_groups(command, mode) +
           make_subcommands(command, mode) + '\n' + make_footer(command);
  }

  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    std::string meaning = make_option_desc(option);
    const auto add = [&](std::string_view word, const std::set<CLI::Option*>& others) {
      std::vector<std::string> names;
      for (const CLI::Option* other : others) names.push_back(other->get_name());
      if (!names.empty()) meaning += fmt::format("; {} {}", word, fmt::join(names, ", "));
    };
    add("needs", option->get_needs());
    add("excludes", option->get_excludes());
    if (const std::string standard = option->get_default_str(); !standard.empty())
      meaning += fmt::format(" [{}]", standard);
    std::string name = make_option_name(option, is_positional);
    if (option->get_type_size() != 0 && !is_positional)
      name += ' ' + get_label(option->get_type_name());
    return entry(name, meaning);
  }

  std::string make_footer(const CLI::App* command) const override {
    std::istringstream lines(command->get_footer());
    std::string footer;
    for (std::string line; std::getline(lines, line);) {
      const std::size_t meaning = line.rfind("  ");  // after a key
      footer += line.size() < 80 || meaning == std::string::npos
                    ? line + '\n'
                    : wrapped(line.substr(0, meaning + 1), line.substr(meaning + 2));
    }
    return footer;
  }

  std::string make_subcommand(const CLI::App* command) const override {
    return entry(command->get_name(), command->get_description());
  }

 private:
  std::string entry(const std::string& name, const std::string& meaning) const {
    const std::string left = "  " + name;
    return left.size() < get_column_width()
               ? wrapped(fmt::format("{:<{}}", left, get_column_width() - 1), meaning)
               : left + '\n' + wrapped(std::string(get_column_width() - 1, ' '), meaning);
  }
};

/// An option whose text a function takes, or refuses by an InputError.
template <class Take>
CLI::Option* add_text(CLI::App& command, const std::string& option, const Take& take,
                      const std::string& meaning) {
  return command.add_option_function<std::string>(
      option,
      [option, take](const std::string& text) {
        try {
          take(text);
        } catch (const InputError& error) {
          throw CLI::ValidationError(option, error.what());
        }
      },
      meaning);
}

/// A whole decimal number; 02, a figure, is not octal.
CLI::Validator whole_number() {
  return {[](std::string& text) -> std::string {
            if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos)
              return fmt::format("must be a whole number, not \"{}\"", shown(text));
            text.erase(0, std::min(text.find_first_not_of('0'), text.size() - 1));
            constexpr std::size_t most_digits = 18;  // of a long
            return text.size() > most_digits ? fmt::format("{}: is too large", shown(text)) : "";
          },
          ""};
}

/// An option that is a whole number from 1 on.
template <class Number>
CLI::Option* add_count(CLI::App& command, const char* option, Number& into, long most,
                       const char* meaning) {
  return command.add_option(option, into, meaning)
      ->transform(whole_number())
      ->check({[most](const std::string& text) -> std::string {
                 const long number = std::stol(text);
                 return number >= 1 && number <= most
                            ? ""
                            : fmt::format("must be from 1 to {}, not {}", most, number);
               },
               "", ""});
}

/// An option whose text is a name, and not empty.
CLI::Option* add_name(CLI::App& command, const char* option, std::string& into, const char* meaning,
                      const char* what = "a file") {
  return command.add_option(option, into, meaning)
      ->type_name(what == std::string_view("a file") ? "FILE" : "NAME")
      ->check({[what](const std::string& text) -> std::string {
                 return text.empty() ? fmt::format("must name {}", what) : "";
               },
               "", ""});
}

CLI::Option* add_seconds(CLI::App& command, const char* option, std::optional<double>& into,
                         const char* meaning) {
  return command.add_option(option, into, meaning)->type_name("s")->check({unless_number, "", ""});
}

void add_options(CLI::App& command, ScenarioSpec& stated) {
  for (const NamedInput& input : named_inputs())
    add_text(
        command, option_of(input.name), [&](const std::string& name) { input.state(stated, name); },
        std::string(input.meaning))
        ->default_str(std::string(input.standard));
}

void add_options(CLI::App& command, FigureOptions& options) {
  options.scenes = (figures_folder() / "paper").string();
  command.add_option("numbers", options.numbers, "figures to write (default: all)")
      ->transform(whole_number());
  add_name(command, "--out", options.out,
           "existing folder for figNN.csv, and figNN.var for gnuplot")
      ->capture_default_str();
  command.add_option("--scenes", options.scenes, "folder with the scene files figNN.toml")
      ->default_str("the paper's");
  add_options(command, options.stated);
  command.footer(
      "What a [[run]] of a scene states takes precedence over these options.\n"
      "\nExamples:\n"
      "  rotor figure 3\n"
      "  rotor figure 8 13 --equations corrected");
}

void add_options(CLI::App& command, PlotOptions& options) {
  add_name(command, "file", options.file, "scene file (TOML), or results of a sweep (.csv)")
      ->required();
  add_name(command, "--out", options.out,
           "picture: .svg, .pdf or .png (default: the file's name with .svg)");
  add_seconds(command, "--from", options.from_s,
              "start of what is drawn (default: the scene's window, or shortly before the first "
              "mass loss; 0 if --until is before that)");
  add_seconds(command, "--until", options.until_s,
              "end of what is drawn (default: the end of the window or the run)");
  command
      .add_option("--columns", options.columns,
                  "results of a sweep to draw, comma-separated (default: outcome, largest force, "
                  "speed at the onset of rolling)")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_name(command, "--drafts", options.drafts,
           "write the data of a sweep's picture, and settings.gp for gnuplot, into this existing "
           "folder instead",
           "a folder");
  add_options(command, options.stated);
  command.footer(
      "Examples:\n"
      "  rotor plot my-rotor.toml --until 0.05\n"
      "  rotor plot damping.csv --columns outcome");
}

void add_options(CLI::App& command, SweepOptions& options) {
  add_name(command, "file", options.file,
           "sweep file (TOML): parameters, and the quantities that vary")
      ->required();
  add_name(command, "--out", options.out,
           "results, one row per point (default: the file's name with .csv)");
  add_count(command, "--jobs", options.jobs, 4096, "threads (default: one per core)");
  add_seconds(command, "--budget", options.budget_s,
              "time allowed for each point, instead of the file's budget")
      ->default_str(fmt::format("none; {} with digits", usual_budget_s));
  CLI::Option* const part = add_text(
      command, "--part",
      [&options](const std::string& text) {
        options.part = part_in(text);
        if (!options.part)
          throw InputError("must be K/N, such as 3/64, K from 1 to N and N at most {}, not \"{}\"",
                           Part::most, shown(text));
      },
      "compute only part K of N equal ones, into NAME.K-of-N.csv");
  part->type_name("K/N");
  CLI::Option* const retry =
      command.add_flag("--retry", options.retry,
                       "keep the rows of the results that are no refusals, and compute the others");
  command
      .add_flag("--join", options.join,
                "write the results from those of all parts, which are next to them")
      ->excludes(part)
      ->excludes(retry)
      ->excludes("--jobs")
      ->excludes("--budget");
  command.add_flag(
      "--force", options.force,
      "replace results that are complete or of another sweep; its own journal is resumed");
  command.footer(
      "Example:\n"
      "  rotor sweep friction.toml --out results.csv");
}

/// Headings of the quantities in the help, each from the quantity on that it names.
constexpr const char* heading_of_loss = "Mass loss";
constexpr const char* heading_of_run = "Run and method";
constexpr std::array<std::pair<std::string_view, const char*>, 4> headings = {
    {{"mass", "Rotor"},
     {"contact_stiffness", "Contact and ring"},
     {"unbalance_factor", heading_of_loss},
     {"start_speed_Hz", heading_of_run}}};

void add_options(CLI::App& command, CaseOptions& options) {
  auto* scene = add_name(command, "scene", options.scene,
                         "scene file (TOML); options override what it states");
  add_name(command, "--run", options.run_name, "the [[run]] of the scene to run (default: all)",
           "a run")
      ->needs(scene);
  std::string heading;
  for (const auto& [quantity, instead_of, of_start] : input_quantities()) {
    for (const auto& [first, text] : headings)
      if (first == quantity.name) heading = text;
    std::string meaning(quantity.meaning);
    if (!quantity.symbol.empty()) meaning += fmt::format(", {}", quantity.symbol);
    if (!instead_of.empty()) meaning += ", instead of " + option_of(instead_of);
    CLI::Option* const added = command.add_option_function<std::string>(
        option_of(quantity.name),
        [&options, &of = quantity](const std::string& text) {
          state_number(options.stated, of, text);
        },
        meaning);
    added->type_name(quantity.unit.empty() ? "N" : std::string(quantity.unit))->group(heading);
    if (quantity.name == "until")
      added->default_str(default_end_in_words());
    else if (quantity.name == "mass_loss_time")
      added->default_str(fmt::format("{}, or 0 if the start has a speed", quantity.of(Scenario{})));
    else if (quantity.in)
      added->default_str(fmt::format("{}", quantity.of(Scenario{})));
  }
  command
      .add_flag_callback(
          "--no-mass-loss", [&options] { options.stated.loses_mass = false; }, "no mass is lost")
      ->group(heading_of_loss);
  command.option_defaults()->group(heading_of_run);
  add_options(command, options.stated);
  command.option_defaults()->group("Output");
  command.add_flag("--json", options.json, "print the results as JSON");
  command.add_flag("--all", options.all, "print every result by its key, in SI units");
}

void add_options(CLI::App& command, RunOptions& options) {
  add_options(command, static_cast<CaseOptions&>(options));
  add_text(
      command, "--stop-on",
      [&options](const std::string& text) { options.stop_on = parse_name<StopOn>(text); },
      "end the run early: outcome (once an event decides it), rolling (at the first maximum of "
      "the force in rolling) or rest (after a second below 0.1 Hz)")
      ->group(heading_of_run);
  auto* trace = add_name(
      command, "--trace", options.trace,
      "write the motion within the window to this CSV file, replacing it; - is standard output");
  command
      .add_option(
          "--columns", options.columns,
          "columns of the trace, comma-separated (default: the scene's, or all); help lists them")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_seconds(command, "--from", options.from_s,
              "start of the trace, which then extends to the end of the run (default: the scene's "
              "window, or from shortly before the mass loss)")
      ->needs(trace);
  add_seconds(command, "--every", options.every_s,
              "interval between rows of the trace, as spectra need it (default: as many rows as "
              "the curves need)")
      ->needs(trace);
  add_name(command, "--events", options.events,
           "write time, kind, state, normal force and slip of the located events to this CSV file");
  auto* section = add_name(
      command, "--section", options.section,
      "at constant speed, write position, velocity and normal force once a turn, when e_x points "
      "down, in the last turns to this CSV file, and add to the summary after how many turns the "
      "motion repeats, and its orders: parts at 1/3 to 2 times the rotation");
  add_count(command, "--section-turns", options.section_turns, Section::most_turns,
            "how many of the last turns it has")
      ->capture_default_str()
      ->needs(section);
  add_text(
      command, "--header",
      [&options](const std::string& text) { options.header = parse_name<CsvHeader>(text); },
      "what is above the rows of these files: full (provenance in lines with #, and the names of "
      "columns), names (for NumPy and spreadsheets) or none")
      ->default_str("full");
  auto* digits = command.add_option_function<double>(
      "--digits", [&options](double number) { options.stated.digits = parse_digits(number); },
      "estimated significant digits of every value and event, instead of --tolerance; --json adds "
      "errors and events");
  digits->check({unless_number, "", ""});
  add_seconds(command, "--budget", options.budget_s, "time allowed for the --digits of each run")
      ->default_str(fmt::format("{}", usual_budget_s));
  command.add_flag("--json-schema", options.json_schema,
                   "print the JSON schema of the summary instead, with the meaning of each key");
  command.add_flag(
      "--energy", options.energy,
      "add to the summary where the energy goes, from the mass loss or else the start on, "
      "until rolling and until the end");
  command.footer(
      "Examples:\n"
      "  rotor run --friction 0.15\n"
      "  rotor run --equations published\n"
      "  rotor run --mass-loss-speed-Hz 75 --trace motion.csv --columns time_s,rho_m");
}

/// A message about unknown words, with what was probably meant.
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
  if (!word.starts_with('-'))
    return fmt::format("{}: is one word too many for rotor {}", shown(word),
                       commands.front()->get_name());
  for (const CLI::Option* option : commands.front()->get_options()) {
    const std::string name = option->get_name();
    if (name.starts_with('-')) names.push_back(name);
  }
  const std::string option = word.substr(0, word.find('='));
  const std::string meant =
      option.starts_with("--") ? option_of(name_of_symbol(option.substr(2))) : option;
  return fmt::format("{}: there is no such option of {}{}; rotor {} --help lists them",
                     shown(option), commands.front()->get_name(), suggestion(meant, names),
                     commands.front()->get_name());
}

/// Files must not get the descriptors of closed standard streams, or output would end in them. A
/// read-only device takes their place.
void occupy_standard_streams() {
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor)
    if (::fcntl(descriptor, F_GETFD) < 0 && ::open("/dev/null", O_RDONLY) < 0) std::abort();
}

int main(int argc, char** argv) {
  occupy_standard_streams();
  for (const int signal : {SIGPIPE, SIGXFSZ})  // a lost reader or a limit is an error of a write
    static_cast<void>(std::signal(signal, SIG_IGN));
  note_interruptions();
  CLI::App app(
      "Simulates an overcritical rotor that loses mass and rubs: the paper's figures,\n"
      "or your own case.",
      "rotor");
  app.set_version_flag("--version", fmt::format("rotor {}", version()));
  app.require_subcommand(1);
  app.formatter(std::make_shared<Help>());
  app.footer(
      "rotor COMMAND --help lists the options of a command.\n\nExamples:\n"
      "  rotor run --friction 0.15\n"
      "  rotor run --equations published\n"
      "  rotor plot figures/paper/fig08.toml");
  FigureOptions figure;
  PlotOptions plot_options;
  RunOptions run_options;
  CaseOptions estimate;
  SweepOptions sweep;
  const std::set<std::string_view> words(argv, argv + argc);
  // Options take time to add, and so only a command that is called has them.
  const auto add_command = [&]<class Options>(const char* name, const char* does, Options& options,
                                              void (*run)(const Options&)) {
    CLI::App* const command = app.add_subcommand(name, does);
    if (words.contains(name)) add_options(*command, options);
    command->callback([&options, run] { run(options); });
  };
  add_command("figure", "Write the data of the paper's figures as CSV", figure, write_figures);
  add_command("plot", "Draw the motions of a scene, or the results of a sweep", plot_options, plot);
  add_command("run", "Run any rotor and mass loss", run_options, run_rotor);
  add_command("estimate", "Evaluate closed forms of the accident, without a run", estimate,
              estimate_rotor);
  if (words.contains("estimate"))
    app.get_subcommand("estimate")
        ->footer(
            "Results; null: the formula has no value, as some without contact. Numbers in\n"
            "brackets are the equations of model/theory/README.md:\n" +
            meanings_of_laws() +
            "\nExamples:\n"
            "  rotor estimate --mass-loss-speed-Hz 75 --equations corrected\n"
            "  rotor estimate my-rotor.toml");
  add_command("sweep", "Run many rotors, varying some quantities", sweep, run_sweep);
  if (argc == 1) {
    fmt::print("{}", app.help());
    return 1;
  }
  constexpr int without_reader = 128 + SIGPIPE;  // the convention of shells
  int status = 0;
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // help, version
    status = app.exit(success);
  } catch (const CLI::ParseError& error) {
    const std::string extras = about_extras(app);
    std::string message = extras.empty() ? error.what() : extras;
    if (message.ends_with(" missing") && extras.empty())  // "--mass: 1 required kg missing"
      message = message.substr(0, message.find(':')) + ": needs a value";
    if (message.find("At Most 1 required") != std::string::npos)
      message = message.substr(0, message.find(':')) + ": is stated more than once";
    constexpr std::size_t line = 400;
    print_message("rotor: " + message.substr(0, line));
    status = 1;
  } catch (const ReaderGone&) {
    status = without_reader;
  } catch (const Interrupted& error) {
    print_message(fmt::format("rotor: {}", error.what()));
    status = 128 + interrupting_signal();
  } catch (const std::system_error& error) {  // of fmt
    status = error.code() == std::errc::broken_pipe ? without_reader : 1;
    if (status == 1) print_message(fmt::format("rotor: {}", error.what()));
  } catch (const std::exception& error) {
    print_message(fmt::format("rotor: {}", error.what()));
    status = 1;
  }
  if (status == 0 && (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)) {
    if (errno == EPIPE) return without_reader;
    print_message(
        fmt::format("rotor: standard output cannot be written: {}", std::strerror(errno)));
    status = 1;
  }
  return status;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::main(argc, argv); }
