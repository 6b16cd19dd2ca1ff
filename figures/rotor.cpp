/// The command line: `rotor figure` writes the data of the paper's figures, `rotor run` runs any
/// rotor.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <ranges>

#include "figures/audience.hpp"
#include "figures/csv.hpp"
#include "figures/event_log.hpp"
#include "figures/production.hpp"
#include "figures/scene.hpp"
#include "model/summary.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

std::string describe(const Quantity& quantity, const Scenario& scenario) {
  return fmt::format("{} = {}{}{}", quantity.name, quantity.of(scenario),
                     quantity.unit.empty() ? "" : " ", quantity.unit);
}

/// What a run states beyond, or against, the defaults.
std::string differences(const Scenario& scenario) {
  std::vector<std::string> all;
  for (const Quantity& quantity : quantities())
    if (quantity.of(scenario) != quantity.of(Scenario{}))
      all.push_back(describe(quantity, scenario));
  if (!scenario.parameters.separates) all.push_back("no mass loss");
  return all.empty() ? "the paper's parameters" : fmt::format("{}", fmt::join(all, ", "));
}

std::vector<std::string> provenance(const std::string& title, const Scene& scene) {
  std::vector<std::string> lines = {title, "rotor " ROTOR_VERSION};
  for (const auto& [name, scenario] : scene.runs)
    lines.push_back(fmt::format("{}: equations {}, method {}, {}", name,
                                name_of(scenario.equations), name_of(scenario.method),
                                differences(scenario)));
  for (const Column* column : scene.columns)
    lines.push_back(fmt::format("{}: {}", column->name, column->meaning));
  return lines;
}

/// Options that both commands have.
struct CommonOptions {
  std::string equations;
  std::string method;

  void add_to(CLI::App& app) {
    const auto named = [](auto parse) {
      return CLI::Validator(
          [parse](const std::string& name) -> std::string {
            try {
              return parse(name), "";
            } catch (const InputError& error) {
              return error.what();
            }
          },
          "", "");
    };
    app.add_option("--equations", equations,
                   "published (as printed) or consistent (the velocity jump counted once, the "
                   "moment of gravity balanced)")
        ->check(named(parse_equations))
        ->default_str(std::string(name_of(Scenario{}.equations)));
    app.add_option("--method", method,
                   "event (located contacts, error control) or rk4 (the paper's fixed steps)")
        ->check(named(parse_method))
        ->default_str(std::string(name_of(Scenario{}.method)));
  }

  void apply_to(Scenario& scenario) const {
    if (!equations.empty()) scenario.equations = parse_equations(equations);
    if (!method.empty()) scenario.method = parse_method(method);
  }
};

class FigureCommand {
 public:
  explicit FigureCommand(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("figure", "Write the data of the paper's figures as CSV");
    command->add_option("numbers", numbers_, "figures; all if none is given")
        ->transform(CLI::Validator(
            [](std::string& text) -> std::string {  // 05 is not octal
              text.erase(0, std::min(text.find_first_not_of('0'), text.size() - 1));
              return "";
            },
            ""));
    command->add_option("--out", out_, "folder for figNN.csv")->capture_default_str();
    command->add_option("--scenes", scenes_, "folder with the scene files figNN.toml")
        ->capture_default_str();
    common_.add_to(*command);
    command->footer("The scenes' own equations and methods go before these options.");
    command->callback([this] { run(); });
  }

 private:
  void run() const {
    std::map<int, Scene> scenes = read_scenes();

    std::map<int, std::vector<Recorder>> recorders;
    std::vector<Request> requests;
    for (const auto& [number, scene] : scenes) {
      auto& own = recorders[number];
      own.reserve(scene.runs.size());  // the requests refer to them
      for (const SceneRun& scene_run : scene.runs) {
        Recorder& recorder =
            own.emplace_back(scene.window, scene.columns, scene_run.scenario, sampling);
        requests.push_back({scene_run.scenario, recorder});
      }
    }
    const ProductionReport report = produce(requests);

    FileTransaction files;
    for (const auto& [number, scene] : scenes)
      files.write(fs::path(out_) / fmt::format("fig{:02}.csv", number),
                  csv(number, scene, recorders.at(number)));
    files.commit();
    fmt::print(stderr,
               "data of {} figure(s): {} run-up(s) in {:.3f} s, {} run(s) after it in {:.3f} s, {} "
               "right-hand sides\n",
               scenes.size(), report.run_ups, report.run_up_s, report.runs, report.rub_s,
               report.work.right_hand_sides);
  }

  /// Those that are asked for. A scene may state equations and methods of its own.
  std::map<int, Scene> read_scenes() const {
    const std::map<int, fs::path> files = scene_files();
    Scenario defaults;
    common_.apply_to(defaults);
    std::vector<int> numbers = numbers_;
    if (numbers.empty()) std::ranges::copy(files | std::views::keys, std::back_inserter(numbers));
    std::map<int, Scene> scenes;
    for (const int number : numbers) {
      if (!files.contains(number))
        throw InputError(fmt::format("figure {}: there is no {}; the figures are {}", number,
                                     (fs::path(scenes_) / "figNN.toml").string(),
                                     fmt::join(files | std::views::keys, ", ")));
      scenes.emplace(number, read_scene(files.at(number), defaults));
    }
    return scenes;
  }

  std::map<int, fs::path> scene_files() const {
    std::map<int, fs::path> files;
    if (!fs::is_directory(scenes_))
      throw InputError(fmt::format("--scenes {}: there is no such folder", scenes_));
    for (const auto& entry : fs::directory_iterator(scenes_)) {
      int number = 0;
      const std::string name = entry.path().filename();
      if (std::sscanf(name.c_str(), "fig%d.toml", &number) == 1 &&
          name == fmt::format("fig{:02}.toml", number))
        files[number] = entry.path();
    }
    return files;
  }

  static std::string csv(int number, const Scene& scene, const std::vector<Recorder>& recorders) {
    std::vector<NamedTable> tables;
    for (std::size_t i = 0; i < recorders.size(); ++i) {
      if (recorders[i].table().rows() == 0)
        throw InputError(fmt::format("figure {}: nothing of the run \"{}\" lies in the window",
                                     number, scene.runs[i].name));
      tables.push_back({scene.runs[i].name, thinned(recorders[i].table(), thinning)});
    }
    return to_csv(provenance(fmt::format("Fig. {}: {}", number, scene.title), scene), "run",
                  scene.columns, tables);
  }

  std::vector<int> numbers_;
  std::string out_ = "build/figures";
  std::string scenes_ = ROTOR_SCENES;
  CommonOptions common_;
};

nlohmann::ordered_json to_json(const Summary& summary, const Work& work, const Scenario& scenario) {
  nlohmann::ordered_json json;
  const auto put = [&json](const char* key, const std::optional<double>& value) {
    if (value)
      json[key] = *value;
    else
      json[key] = nullptr;
  };
  put("first_contact_s", summary.first_contact_s);
  json["collisions"] = summary.collisions;
  put("rolling_onset_s", summary.rolling_onset_s);
  put("rolling_onset_speed_Hz", summary.rolling_onset_speed_Hz);
  put("rolling_onset_force_N", summary.rolling_onset_force_N);
  put("peak_normal_force_N", summary.peak_normal_force_N);
  put("peak_time_s", summary.peak_time_s);
  put("max_displacement_m", summary.max_displacement_m);
  put("motor_off_s", summary.motor_off_s);
  put("speed_at_separation_Hz", summary.speed_at_separation_Hz);
  put("final_speed_Hz", summary.final_speed_Hz);
  put("final_kinetic_energy_J", summary.final_kinetic_energy_J);
  put("final_q1_m", summary.final_q1_m);
  put("final_q2_m", summary.final_q2_m);
  json["right_hand_sides"] = work.right_hand_sides;
  json["contact_evaluations"] = work.contact_evaluations;
  json["steps"] = work.steps;
  json["located_events"] = work.located_events;
  json["equations"] = name_of(scenario.equations);
  json["method"] = name_of(scenario.method);
  if (scenario.method == Method::event)
    json["tolerance"] = scenario.tolerance;
  else
    json["tolerance"] = nullptr;
  return json;
}

class RunCommand {
 public:
  explicit RunCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand("run", "Run any rotor and mass loss");
    auto* scene = command->add_option("--scene", scene_,
                                      "scene file (TOML); options override what it states");
    command->add_option("--run", run_name_, "which [[run]] of the scene, if it has several")
        ->needs(scene);
    for (const Quantity& quantity : quantities()) add_number(*command, quantity);
    command->add_flag("--no-separation", no_separation_, "no mass is lost");
    common_.add_to(*command);
    auto* trace = command->add_option("--trace", trace_,
                                      "write the motion inside the window to this CSV file");
    command
        ->add_option("--columns", columns_,
                     "columns of the trace, comma-separated; the scene's, or all, if not given")
        ->delimiter(',')
        ->needs(trace);
    command->add_option("--from", from_, "begin of the trace; the scene's, or 0 s, if not given")
        ->type_name("s")
        ->needs(trace);
    command->add_option("--events", events_,
                        "write time, kind, state, normal force and slip of the located events to "
                        "this CSV file");
    command->add_flag("--json", json_, "print the summary as JSON");
    command->callback([this] { run(); });
  }

 private:
  void add_number(CLI::App& command, const Quantity& quantity) {
    std::string option = "--" + std::string(quantity.name);
    std::ranges::replace(option, '_', '-');
    command
        .add_option_function<double>(
            option, [this, &quantity](double value) { given_[&quantity] = value; },
            fmt::format("{}{}{}", quantity.meaning, quantity.symbol.empty() ? "" : ", ",
                        quantity.symbol))
        ->type_name(quantity.unit.empty() ? "number" : std::string(quantity.unit))
        ->default_str(fmt::format("{}", quantity.of(Scenario{})))
        ->check(CLI::Validator(
            [&quantity](const std::string& text) -> std::string {
              double value = 0;
              const bool number = CLI::detail::lexical_cast(text, value);
              return number && quantity.allows(value)
                         ? ""
                         : fmt::format("must be {}, not {}", quantity.range(), text);
            },
            "", ""));
  }

  /// The scene with the one run that is asked for.
  Scene scene() const {
    if (scene_.empty()) return {.title = "", .window = {}, .columns = {}, .runs = {{"run", {}}}};
    Scene scene = read_scene(scene_);
    for (const SceneRun& run : scene.runs)
      if (run.name == run_name_ || (run_name_.empty() && scene.runs.size() == 1)) {
        scene.runs = {SceneRun(run)};
        return scene;
      }
    std::vector<std::string> names;
    for (const SceneRun& run : scene.runs) names.push_back(run.name);
    throw InputError(
        fmt::format("{}: choose one of its runs with --run: {}", scene_, fmt::join(names, ", ")));
  }

  Scene requested_scene() const {
    Scene result = scene();
    Scenario& scenario = result.runs.front().scenario;
    for (const auto& [quantity, value] : given_) quantity->in(scenario) = value;
    if (no_separation_) scenario.parameters.separates = false;
    common_.apply_to(scenario);
    check(scenario);
    if (!events_.empty() && scenario.method == Method::rk4)
      throw InputError("--events: only --method event locates events");
    if (!columns_.empty()) result.columns = parse_columns(columns_);
    if (result.columns.empty())
      for (const Column& column : all_columns()) result.columns.push_back(&column);
    if (from_) {
      if (!(*from_ >= 0 && *from_ < scenario.until))
        throw InputError(fmt::format("--from {}: must lie inside the run, from 0 s to {} s", *from_,
                                     scenario.until));
      result.window = {.from_s = *from_};
    }
    return result;
  }

  void run() const {
    Scene scene = requested_scene();
    const auto& [name, scenario] = scene.runs.front();
    Recorder trace(scene.window, scene.columns, scenario, sampling);
    EventLog events(scenario);
    SummaryObserver summary(scenario);
    Audience audience;
    audience.add(summary);
    if (!trace_.empty()) audience.add(trace);
    if (!events_.empty()) audience.add(events);
    Work work;
    const Instant first = start(scenario);
    audience.see(first);
    rotor::run(scenario, first, audience, work);

    FileTransaction files;
    if (!trace_.empty() && trace.table().rows() == 0)
      throw InputError(fmt::format("--trace {}: nothing of the run lies in the window", trace_));
    if (!trace_.empty())
      files.write(trace_, to_csv(provenance("Trace of a run", scene), "run", scene.columns,
                                 {{name, trace.table()}}));
    if (!events_.empty()) {
      scene.columns = events.columns();
      files.write(events_, to_csv(provenance("Events of a run", scene), "event", scene.columns,
                                  events.tables()));
    }
    files.commit();
    print(to_json(summary.summary(), work, scenario));
  }

  void print(const nlohmann::ordered_json& summary) const {
    if (json_) {
      fmt::print("{}\n", summary.dump(2));
    } else {
      for (const auto& [key, value] : summary.items())
        fmt::print("{:<24} {}\n", key, value.is_null() ? "-" : value.dump());
    }
  }

  std::string scene_, run_name_, trace_, events_;
  std::vector<std::string> columns_;
  std::map<const Quantity*, double> given_;
  std::optional<double> from_;
  bool no_separation_ = false, json_ = false;
  CommonOptions common_;
};

int main(int argc, char** argv) {
  CLI::App app("Overcritical rotor, mass loss, rub: the paper's figures, and runs of one's own.");
  app.set_version_flag("--version", "rotor " ROTOR_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(36);
  const FigureCommand figure(app);
  const RunCommand run(app);
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
