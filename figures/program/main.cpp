/// The command line: `rotor figure` writes the data of the paper's figures, `rotor run` runs any
/// rotor. What it states ends in the structures of options.hpp.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "figures/program/commands.hpp"
#include "figures/scenes/scene.hpp"

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

/// Figures are numbered 02, 03 and so on, which is not octal.
CLI::Validator without_leading_zeros() {
  return {[](std::string& text) -> std::string {
            text.erase(0, std::min(text.find_first_not_of('0'), text.size() - 1));
            return "";
          },
          ""};
}

CLI::Validator allowed_by(const Quantity& quantity) {
  return {[&quantity](const std::string& text) -> std::string {
            double value = 0;
            const bool number = CLI::detail::lexical_cast(text, value);
            return number && quantity.allows(value)
                       ? ""
                       : fmt::format("must be {}, not {}", quantity.range(), text);
          },
          "", ""};
}

void add_options(CLI::App& command, CommonOptions& options) {
  command
      .add_option("--equations", options.equations,
                  "published (as printed) or consistent (the velocity jump counted once, the "
                  "moment of gravity balanced)")
      ->check(parsed_by(parse_equations))
      ->default_str(std::string(name_of(Scenario{}.equations)));
  command
      .add_option("--method", options.method,
                  "event (located contacts, error control) or rk4 (the paper's fixed steps)")
      ->check(parsed_by(parse_method))
      ->default_str(std::string(name_of(Scenario{}.method)));
}

void add_options(CLI::App& command, FigureOptions& options) {
  options.scenes = ROTOR_SCENES;
  command.add_option("numbers", options.numbers, "figures; all if none is given")
      ->transform(without_leading_zeros());
  command.add_option("--out", options.out, "folder for figNN.csv")->capture_default_str();
  command.add_option("--scenes", options.scenes, "folder with the scene files figNN.toml")
      ->capture_default_str();
  add_options(command, static_cast<CommonOptions&>(options));
  command.footer("The scenes' own equations and methods take precedence over these options.");
}

void add_options(CLI::App& command, RunOptions& options) {
  auto* scene = command.add_option("--scene", options.scene,
                                   "scene file (TOML); options override what it states");
  command.add_option("--run", options.run_name, "which [[run]] of the scene, if it has several")
      ->needs(scene);
  for (const Quantity& quantity : quantities()) {
    std::string option = "--" + std::string(quantity.name);
    std::ranges::replace(option, '_', '-');
    command
        .add_option_function<double>(
            option, [&](double value) { options.numbers[&quantity] = value; },
            fmt::format("{}{}{}", quantity.meaning, quantity.symbol.empty() ? "" : ", ",
                        quantity.symbol))
        ->type_name(quantity.unit.empty() ? "number" : std::string(quantity.unit))
        ->default_str(fmt::format("{}", quantity.of(Scenario{})))
        ->check(allowed_by(quantity));
  }
  command.add_flag("--no-separation", options.no_separation, "no mass is lost");
  add_options(command, static_cast<CommonOptions&>(options));
  auto* trace = command.add_option("--trace", options.trace,
                                   "write the motion inside the window to this CSV file");
  command
      .add_option("--columns", options.columns,
                  "columns of the trace, comma-separated; the scene's, or all, if not given")
      ->delimiter(',')
      ->needs(trace);
  command
      .add_option("--from", options.from_s,
                  "beginning of the trace; the scene's, or 0 s, if not given")
      ->type_name("s")
      ->needs(trace);
  command.add_option("--events", options.events,
                     "write time, kind, state, normal force and slip of the located events to "
                     "this CSV file");
  command.add_flag("--json", options.json, "print the summary as JSON");
}

/// A command whose options are filled in, and which is run then.
template <class Options>
void add_command(CLI::App& app, const char* name, const char* does, Options& options,
                 void (*run)(const Options&)) {
  CLI::App* command = app.add_subcommand(name, does);
  add_options(*command, options);
  command->callback([&options, run] { run(options); });
}

int main(int argc, char** argv) {
  CLI::App app("Overcritical rotor, mass loss, rub: the paper's figures, and any other case.");
  app.set_version_flag("--version", "rotor " ROTOR_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(36);
  FigureOptions figure;
  RunOptions run;
  add_command(app, "figure", "Write the data of the paper's figures as CSV", figure, write_figures);
  add_command(app, "run", "Run any rotor and mass loss", run, run_rotor);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const std::exception& error) {
    fmt::print(stderr, "rotor: {}\n", error.what());
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::main(argc, argv); }
