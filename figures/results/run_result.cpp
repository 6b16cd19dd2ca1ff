#include "figures/results/run_result.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>
#include <type_traits>
#include <utility>

#include "figures/data/text.hpp"
#include "figures/input/names.hpp"
#include "figures/results/section_result.hpp"
#include "figures/results/version.hpp"
#include "model/mechanics/contact.hpp"

namespace rotor {
namespace {

constexpr int schema = 1;

using rotor::json_of;  // of numbers
Json json_of(Outcome outcome) { return name_of(outcome); }
Json json_of(long count) { return count; }
Json json_of(bool whether) { return whether; }

/// What a summary has besides the results.
struct Metadata {
  std::string_view key, meaning;
  Json allowed;  ///< in JSON schema
  Json (*value)(const RunResult&);
  Settled settled = Settled::once_known;
};

Json type(const char* name) { return {{"type", name}}; }
Json number_or_null() { return {{"type", {"number", "null"}}}; }
template <class Names>
Json one_of(const Names& names) {
  return {{"type", "string"}, {"enum", names}};
}

Json with(Json names, const Json& more) {
  names.push_back(more);
  return names;
}

Json remarks_of(const RunResult& result) {
  Json sentences = Json::array();
  for (const Remark& remark : remarks(result)) sentences.push_back(remark.message.text());
  return sentences;
}

const std::vector<Metadata>& metadata() {
  constexpr Settled stop = Settled::by_stop;
  static const std::vector<Metadata> all = {
      {"stop_on",
       "Where the run was to stop early. A run that stopped at its outcome or at rolling has null "
       "for values that the rest of the run could change",
       {{"enum", with(all_names<StopOn>(), nullptr)}},
       [](const RunResult& result) {
         return result.early.stop_on ? Json(name_of(*result.early.stop_on)) : Json();
       }},
      {"stop_reached", "Whether the run stopped there", type("boolean"),
       [](const RunResult& result) { return Json(result.early.stop_reached); }},
      {"remarks",
       "What a reader should know besides the numbers",
       {{"type", "array"}, {"items", type("string")}},
       remarks_of,
       Settled::by_end},
      {"right_hand_sides", "Cost: evaluations of the equations of motion", type("integer"),
       [](const RunResult& result) { return Json(result.end.counters.right_hand_sides); }, stop},
      {"contact_evaluations", "Cost: evaluations of the loads in contact, in equations and guards",
       type("integer"),
       [](const RunResult& result) { return Json(result.end.counters.contact_evaluations); }, stop},
      {"steps", "Cost: accepted steps", type("integer"),
       [](const RunResult& result) { return Json(result.end.counters.steps); }, stop},
      {"located_events", "Number of located events", type("integer"),
       [](const RunResult& result) { return Json(result.end.counters.located_events); }, stop},
      {"equations",
       "published (velocity jump twice, gravity moment whole), corrected (once, balanced) or "
       "mixed",
       one_of(with(all_names<Equations>(), "mixed")),
       [](const RunResult& result) { return Json(name_of(result.scenario.equations)); }},
      {"velocity_jump", "How often the mass loss adds Delta_vy to the velocity of C",
       one_of(all_names<VelocityJump>()),
       [](const RunResult& result) {
         return Json(name_of(result.scenario.equations.velocity_jump));
       }},
      {"gravity_moment",
       "balanced by the springs except for the part due to the eccentricity, or whole",
       one_of(all_names<GravityMoment>()),
       [](const RunResult& result) {
         return Json(name_of(result.scenario.equations.gravity_moment));
       }},
      {"method", "How the run was computed", one_of(all_names<Method>()),
       [](const RunResult& result) { return Json(name_of(result.scenario.method)); }},
      {"drive", "What turns the rotor", one_of(all_names<Drive>()),
       [](const RunResult& result) { return Json(name_of(result.scenario.parameters.drive)); }},
      {"tolerance", "Error allowed in a step by method event; null for rk4", number_or_null(),
       [](const RunResult& result) {
         return result.scenario.method == Method::event ? json_of(result.scenario.tolerance)
                                                        : Json();
       }},
      {"inputs", "All numbers of the scenario, in SI units; speeds in Hz", type("object"),
       [](const RunResult& result) { return inputs_of(result.scenario); }},
      {"version", "Version of rotor, and its commit", type("string"),
       [](const RunResult&) { return Json(version()); }},
      {"schema", "Version of this schema", {{"const", schema}}, [](const RunResult&) {
         return Json(schema);
       }}};
  return all;
}

/// What decides the value with this key. A closed form is known from the start.
Settled settled_by(std::string_view key) {
  for (const auto& field : summary_fields<double>)
    if (field.key == key) return field.settled;
  for (const Metadata& entry : metadata())
    if (entry.key == key) return entry.settled;
  return Settled::once_known;
}

/// In the order in which they are decided.
std::string meanings_of_outcomes() {
  std::vector<std::string> all(outcomes.size());
  for (const OutcomeInWords& words : outcomes)
    all[static_cast<std::size_t>(words.outcome)] =
        fmt::format("{} ({})", words.name, words.meaning);
  return fmt::format("{}", fmt::join(all, ", "));
}

/// The schema of a result of this type.
template <class T>
Json allowed(T Summary::* /*of*/, bool may_be_open) {
  if constexpr (std::is_same_v<T, Outcome>) return {{"enum", with(all_names<Outcome>(), nullptr)}};
  Json types = Json::array({std::is_same_v<T, bool>   ? "boolean"
                            : std::is_same_v<T, long> ? "integer"
                                                      : "number"});
  const bool counts = std::is_same_v<T, long>;  // which --digits may not know
  if (may_be_open || counts || std::is_same_v<T, std::optional<double>>) types.push_back("null");
  return {{"type", types}};
}

RunResult continued(RunUpCheckpoint run_so_far, const Scenario& scenario,
                    std::optional<StopObserver> stop, Observer& others) {
  Simulation& simulation = run_so_far.simulation;
  SummaryObserver& summary = run_so_far.summary;
  ObserverGroup observers = {&others};
  if (stop) observers.add(*stop);
  observers.on_instant(simulation.instant());
  observers.add(summary);  // the summary has seen the start
  if (!simulation.stopped())
    simulation.run_to_end(observers);
  else
    summary.on_instant(simulation.instant());
  const RunEnd end{simulation.instant(), simulation.counters(), simulation.stopped()};
  EarlyEnd early;
  if (stop) early = {stop->stop_on(), stop->is_reached()};
  early.interrupted = end.stopped && !early.stop_reached;
  return {scenario, summary.summary(), end, early};
}

}  // namespace

Json inputs_of(const Scenario& scenario) {
  const Parameters& p = scenario.parameters;
  Json inputs;
  for (const Quantity& quantity : quantities())
    inputs[std::string(quantity.name)] = quantity.of(scenario);
  if (const auto lost = p.stated_lost_mass(); lost && p.eccentricity == 0) {
    inputs["unbalance_factor"] = nullptr;  // as none describes it
    inputs["lost_mass"] = *lost;
  }
  for (const InputQuantity& input : input_quantities())
    if (input.of_start)
      inputs[std::string(input.quantity.name)] =
          scenario.start ? Json(*scenario.start.*input.of_start) : Json();
  inputs["no_mass_loss"] = !p.loses_mass;
  return inputs;
}

RunResult complete_run(RunUpCheckpoint run_so_far, const Scenario& scenario,
                       std::optional<StopOn> stop_on, Observer& others) {
  std::optional<StopObserver> stop;
  if (stop_on) stop.emplace(*stop_on, scenario);
  return continued(std::move(run_so_far), scenario, std::move(stop), others);
}

RunResult complete_run_for(const std::vector<std::string>& keys, RunUpCheckpoint run_so_far,
                           const Scenario& scenario, Observer& others) {
  Settled last = Settled::once_known;
  for (const std::string& key : keys) {
    const Settled settled = settled_by(key);
    const bool awaits_no_loss = settled == Settled::by_loss && !scenario.loses_mass();
    last = std::max(last, awaits_no_loss ? Settled::by_end : settled);
  }
  if (last != Settled::by_stop && !contains(keys, "peak_bearing_force_N"))
    run_so_far.summary.ignore_maxima_of(Extreme::bearing_force);
  std::optional<StopObserver> stop;
  if (last < Settled::by_end) stop.emplace(StopOn::outcome, scenario, last == Settled::by_contacts);
  return continued(std::move(run_so_far), scenario, std::move(stop), others);
}

Json to_json(const RunResult& result, const std::vector<std::string>* only) {
  Json json;
  const auto is_wanted = [&](std::string_view key) { return !only || contains(*only, key); };
  for (const auto& field : summary_fields<double>)
    if (is_wanted(field.key))
      json[std::string(field.key)] =
          !result.early.leaves_rest_open() || field.is_settled(result.summary)
              ? std::visit([&](auto of) { return json_of(result.summary.*of); }, field.value)
              : Json();
  for (const Metadata& entry : metadata())
    if (is_wanted(entry.key)) json[std::string(entry.key)] = entry.value(result);
  return json;
}

Json summary_schema() {
  Json properties, required;
  const auto describe = [&](std::string_view key, std::string_view meaning, Json allowed) {
    allowed["description"] = meaning;
    properties[std::string(key)] = std::move(allowed);
  };
  describe("run", "Name of the run, if there are several", type("string"));
  for (const auto& field : summary_fields<double>) {
    describe(
        field.key,
        std::holds_alternative<Outcome Summary::*>(field.value)
            ? fmt::format("{}, the first that holds: {}", field.meaning, meanings_of_outcomes())
            : std::string(field.meaning),
        std::visit(
            [&](auto member) {
              return allowed(member, field.settled != Settled::once_known &&
                                         field.settled != Settled::by_stop);
            },
            field.value));
    required.push_back(field.key);
  }
  for (const Metadata& entry : metadata()) {
    describe(entry.key, entry.meaning, entry.allowed);
    required.push_back(entry.key);
  }
  describe("digits",
           "Only with --digits: how many were asked for; which values have fewer, and how many; "
           "whether counts and outcome are estimated to be those of exact arithmetic (if not, "
           "nothing is known about values that depend on them); and the precision of the last "
           "computation",
           type("object"));
  describe("errors",
           "Only with --digits: the estimated error of each number; null if nothing is known about "
           "it, or there is no number",
           {{"type", "object"}, {"additionalProperties", number_or_null()}});
  describe("events",
           "Only with --digits: name, time and state of each event, and of the end, with errors",
           type("array"));
  describe("energy_J",
           "Only with --energy, from just before the mass loss on: work of each cause, negative "
           "where the rotor loses energy, and the energies stored at the end of each span; "
           "residual is the error of the balance",
           type("object"));
  properties["section"] = section_schema();
  return {
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", "Summary of a run, as `rotor run --json` prints it"},
      {"description", "Of a scene with several runs: {\"runs\": [...]}, with a summary of each"},
      {"type", "object"},
      {"properties", properties},
      {"required", required},
      {"additionalProperties", false}};
}

Json to_json(const EnergyObserver& energy) {
  const auto of = [](const EnergyBalance& b) {
    Json all = {{"initial", b.initial}};
    for (std::size_t i = 0; i < b.work.loads.size(); ++i)
      all[std::string(EnergyByCause::loads_by_name[i])] = b.work.loads[i];
    all.update(Json{{"drive", b.work.drive},
                    {"contact_damping", b.work.contact_damping},
                    {"friction", b.work.friction},
                    {"mass_loss", b.mass_loss},
                    {"kinetic", b.kinetic},
                    {"support_springs", b.support_springs},
                    {"contact_spring", b.contact_spring},
                    {"residual", b.residual()}});
    return all;
  };
  Json json;
  json["until_rolling"] = nullptr;
  if (energy.until_rolling()) json["until_rolling"] = of(*energy.until_rolling());
  json["until_end"] = nullptr;
  if (energy.has_begun()) json["until_end"] = of(energy.balance());
  return json;
}

std::vector<Remark> remarks(const RunResult& result) {
  using Of = Remark::Of;
  const Summary& summary = result.summary;
  const EarlyEnd& early = result.early;
  const Parameters& p = result.scenario.parameters;
  const auto the = [&](std::string_view name) { return mention_of(result.scenario, name); };
  std::vector<Remark> all;
  if (summary.lost_mass_kg == 0.)
    all.push_back({{"no mass is lost with ", the("unbalance_factor"), " and ", the("eccentricity")},
                   Of::missed_loss});
  else if (p.loses_mass && !summary.mass_loss_reached)
    all.push_back(
        {{fmt::format("the mass loss at {} s was not reached by {:.6g} s", p.mass_loss_time,
                      p.mass_loss_time > result.scenario.until ? result.scenario.until
                                                               : summary.final_time_s)},
         Of::missed_loss});
  if (early.stop_on && !early.stop_reached) {
    const ActingLoads<double> acting(p, result.scenario.equations);
    const bool spins_freely = early.stop_on == StopOn::rest && !result.end.last.touches();
    all.push_back(
        {{fmt::format("the run was to stop at {}, which was not reached by {:.6g} s{}",
                      name_of(*early.stop_on), summary.final_time_s,
                      !spins_freely ? ""
                      : acting.constant_moment(result.end.last.motor_on) > 0
                          ? "; the motor still drives"
                          : "; without contact only the damping of its whirl brakes the rotor")},
         Of::missed_stop});
  }
  using enum Outcome;
  const bool is_open = summary.outcome == sliding || summary.outcome == bouncing ||
                       summary.outcome == undecided || summary.outcome == stalled;
  if (is_open && !early.stop_on && !early.interrupted)
    all.push_back({{fmt::format("at {:.6g} s, the end of the run, the outcome may still change",
                                summary.final_time_s)}});
  if (const double start = result.scenario.start_speed_Hz;
      p.drive == Drive::motor && start > 0 && start != p.motor_off_Hz && p.torque > 0)
    all.push_back(
        {{"at ", the("start_speed_Hz"), " the motor ",
          start < p.motor_off_Hz ? "still drives (torque = 0 turns it off), up to " : "is off: ",
          the("motor_off_Hz")}});
  if (summary.touch_downs_before_loss > 0 && p.loses_mass)
    all.push_back(
        {{fmt::format("touch-downs before the mass loss: {}", summary.touch_downs_before_loss)}});
  // What turns with the rim, as the arm of friction and the rolling speed, has the radius r of a
  // rigid rotor; if the rotor and not the ring yields, it has r less the indentation.
  constexpr double deep = 0.05;
  const double deepest =
      std::max(summary.peak_displacement_m.value_or(0), summary.peak_displacement_before_loss_m) -
      Ring<double>(p).clearance;
  if (deepest > deep * p.rotor_radius)
    all.push_back(
        {{fmt::format("the largest indentation, {:.3g} m, is {:.2g} % of the rotor's radius, more "
                      "than {} %: rolling speeds and moments, which are those of a rigid rotor, "
                      "are uncertain by as much",
                      deepest, 100 * deepest / p.rotor_radius, 100 * deep)}});
  // Steps per half period of the contact; with ten, the error of the largest force is about 1 %.
  constexpr double few_steps = 10;
  const double steps = std::numbers::pi /
                       natural_frequency(Ring<double>(p).typical_stiffness(), p.mass) /
                       result.scenario.step_rub;
  if (result.scenario.method == Method::rk4 && summary.touch_downs > 0 && steps < few_steps)
    all.push_back({{fmt::format("a contact lasts about {:.2g} steps of ", steps), the("step_rub"),
                    fmt::format(": the published method needs at least {}", few_steps)}});
  // At mu = 0.05 each multiplies errors by 2.7 in the mean: so many use up the tolerance.
  const double many = -std::log(result.scenario.tolerance);
  if (!result.is_course_sure && static_cast<double>(summary.touch_downs) > many)
    all.push_back(
        {{fmt::format("with {} touch-downs, differences in the last digits may lead to another "
                      "course; a sample of runs shows it",
                      summary.touch_downs)}});
  const auto of_rotor = remarks_on_rotor(result.scenario, summary.speed_at_mass_loss_Hz);
  all.insert(all.end(), of_rotor.begin(), of_rotor.end());
  return all;
}

}  // namespace rotor
