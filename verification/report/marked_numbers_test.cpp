/// Numbers in Markdown that are computed: between a comment that names one and an empty comment, as
/// in `<!--published.mu_03.peak_kN.f1-->454.8<!---->`. Names and forms are those of `with_numbers`;
/// `make approve` writes them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>

#include "figures/data/csv.hpp"
#include "figures/input/names.hpp"
#include "model/mechanics/mass_loss.hpp"
#include "model/theory/accident.hpp"
#include "verification/report/page.hpp"
#include "verification/support/onset_speed.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

/// How many claims have which verdict, in all and by figure.
void add_verdicts(Json& values, const std::vector<Number>& judged) {
  const Json claims = claims_json(judged);
  std::vector<const Json*> all;
  std::map<int, std::vector<const Json*>> by_figure;
  for (const Json& claim : claims) {
    all.push_back(&claim);
    for (const Json& figure : claim.at("figures")) by_figure[figure.get<int>()].push_back(&claim);
  }
  values["claims"] = verdicts_json(all);
  values["claims"]["numbers"] = judged.size();
  for (const auto& [figure, its] : by_figure)
    values["figures"][std::to_string(figure)] = verdicts_json(its);
}

/// The largest normal force with each correction on its own, kN, or no contact.
Json corrections_json() {
  Json all;
  for (const VelocityJump jump : {VelocityJump::twice, VelocityJump::once})
    for (const GravityMoment moment : {GravityMoment::whole, GravityMoment::balanced})
      for (const double loss_s : {29.1, 19.1, 14.15}) {
        Scenario scenario{.equations = {jump, moment}, .until = loss_s + 0.25};
        scenario.parameters.mass_loss_time = loss_s;
        const auto peak_N = summary_of(scenario).peak_normal_force_N;
        all[std::string(name_of(jump))][std::string(name_of(moment))]
           [fmt::format("t_{:.0f}", std::floor(loss_s))] =
               peak_N ? fmt::format("{:.2f}", 1e-3 * *peak_N) : "no contact";
      }
  return all;
}

/// A share in percent with its standard error, or how many cases there are if it is the same in
/// all.
std::string with_error(double percent, double cases) {
  if (percent == 0 || percent == 100) return fmt::format("{:.0f} % of {:.0f}", percent, cases);
  const double error = std::sqrt(percent * (100 - percent) / cases);
  return fmt::format("{:.{}f} +- {:.{}f} %", percent, error < 0.05 ? 2 : 1, error,
                     error < 0.05 ? 2 : 1);
}

/// The verdict on a statement about a trend; how often it holds, %, with the standard error.
Json reasons_json(const std::filesystem::path& tried) {
  Json all;
  for (const CsvRow& row : read_csv(tried)) {
    const double fails = 100 * static_cast<double>(row.number("share"));
    const auto pairs = static_cast<double>(row.number("apply"));
    all[row["reason"]][row["equations"]] = {{"verdict", row["verdict"]},
                                            {"fails", with_error(fails, pairs)},
                                            {"holds", with_error(100 - fails, pairs)}};
    if (!row["size"].empty())  // of the force where a statement fails, at the median
      all[row["reason"]][row["equations"]]["falls"] =
          100 * (1 - static_cast<double>(row.number("size")));
  }
  return all;
}

/// How well the laws of model/theory hold, with standard errors: `laws.EQUATIONS.QUANTITY`, by the
/// least share of the unbalance in %, as in `from_3`, or for `all`.
Json laws_json(const std::filesystem::path& laws) {
  Json all;
  for (const CsvRow& row : read_csv(laws)) {
    const std::string from = row["share_from"];
    const bool has_all = from.empty() || (from == "0" && row["share_to"].empty());
    const std::string which = has_all ? "all" : fmt::format("from_{:.0f}", 100 * std::stod(from));
    Json& its = all[row["equations"]][row["quantity"]][which];
    its["agree"] = with_error(100 * static_cast<double>(row.number("agree")),
                              static_cast<double>(row.number("runs")));
    for (const char* quantile : {"q05", "median", "q95"})
      if (!row[quantile].empty()) its[quantile] = static_cast<double>(row.number(quantile));
  }
  return all;
}

/// The share of the draws of population (c) that do not reach the operating speed before the loss,
/// %, for a motor without resistance.
double too_slow_percent(const std::filesystem::path& printed_inputs) {
  Sweep sweep;
  constexpr long draws = 4000;  // standard error 0.8 %
  sweep.sample.count = draws;
  sweep.sample.seed = 1;
  sweep.sample.method = Sampling::random;
  for (const auto& [input, least, greatest] : read_input_ranges(printed_inputs))
    sweep.sample.over.push_back({input, Distribution::uniform, least, greatest});
  const SweepPoints points(sweep);
  long slow = 0;
  for (long n = 0; n < draws; ++n) {
    auto of = points(n).spec.numbers;
    slow +=
        of.at("inertia") * two_pi * of.at("motor_off_hz") / of.at("torque") > of.at("t_operating");
  }
  return 100. * static_cast<double>(slow) / draws;
}

/// The accident in other rings: `contact_laws.EQUATIONS.mu_030.rolling.n_150_dashpot` of
/// contact-laws.csv, shares in %; the linear ring is `linear`.
Json contact_laws_json(const std::filesystem::path& table) {
  Json all;
  for (const CsvRow& row : read_csv(table)) {
    const auto number = [&](const char* column) {
      return row[column].empty() ? Json() : Json(static_cast<double>(row.number(column)));
    };
    const std::string same = row["same_indentation"];
    Json& its = all[row["equations"]]
                   [fmt::format("mu_{:03.0f}", 100 * static_cast<double>(row.number("mu")))];
    Json& ring = same.empty()
                     ? its["linear"]
                     : its[same][fmt::format("n_{:.0f}_{}", 100 * std::stod(row["exponent"]),
                                             row["damping"])];
    ring = {{"outcome", row["outcome"]},
            {"same", 100 * static_cast<double>(row.number("same_outcome"))},
            {"error", 100 * static_cast<double>(row.number("error"))}};
    for (const char* column : {"Delta_0_um", "touch_downs", "to_rolling_ms", "peak_kN", "force_p5",
                               "force", "force_p95", "time_p5", "time", "time_p95"})
      ring[column] = number(column);
  }
  return all;
}

/// How far the proofs of the paper's accident follow it after rolling has set in, ms.
Json proven_json(const std::filesystem::path& table) {
  static const std::regex accident(
      "build/prove --friction 0.3 --equations (\\w+) --until ([\\d.]+) .*");
  Json all;
  for (const CsvRow& row : read_csv(table)) {
    const std::string command = row["command"];
    if (std::smatch its;
        row["quantity"] == "rolling_onset_s" && std::regex_match(command, its, accident))
      all[its[1]]["of_rolling_ms"] =
          1e3 * (std::stod(its[2]) - static_cast<double>(row.number("lower")));
  }
  return all;
}

/// From where on the paper's rotor touches the ring after a loss in steady motion: the speed, how
/// many % it is above (1) of model/theory, and the turns until the mass centre has swung out.
Json limits_json() {
  Json all;
  const Parameters p;
  const double mass = MassLoss<double>(p).after.mass,
               natural = std::sqrt(p.support_stiffness / mass);
  const double zeta = p.support_damping / (2 * mass * natural);
  const double swing_s = std::acos(zeta) / (natural * std::sqrt(1 - zeta * zeta));
  for (const Equations& equations : {Equations::published, Equations::consistent}) {
    const double speed_Hz = onset_speed_Hz(equations, 0), speed = two_pi * speed_Hz;
    all[std::string(name_of(equations))] = {
        {"speed_Hz", speed_Hz},
        {"turns", speed_Hz * swing_s},
        {"above_law", 100 * (speed / Accident(p, equations, speed).contact_speed.value() - 1)}};
  }
  return all;
}

/// Orders of magnitude of what the model leaves out, for the paper's accident as printed.
Json left_out_json(double peak_kN) {
  const Parameters p;
  const MassLoss<double> loss(p);
  const double clearance = p.stator_radius - p.rotor_radius, peak_N = 1e3 * peak_kN;
  const double speed = two_pi * p.motor_off_Hz;
  const double raised = loss.lost_mass * p.gravity / p.support_stiffness;
  Parameters raised_by = p;
  raised_by.stator_radius -= raised;
  const double closer_N =
      *summary_of({.parameters = raised_by, .until = 29.35}).peak_normal_force_N;
  // The piece as a cube of steel, 7850 kg/m^3.
  const double cube = std::cbrt(loss.lost_mass / 7850);
  // Of steel: hardness 2 GPa, diffusivity 1.2e-5 m^2/s, heat capacity 3.6e6 J/(m^3 K); a contact
  // 10 mm wide, which half of friction's 2760 J heats for 23 ms.
  const double width = 0.01, half_chord = peak_N / (2 * 2e9 * width);
  const double plastic = half_chord * half_chord / 2 * (1 / p.rotor_radius - 1 / p.stator_radius);
  // The first impact, 5.1 N s in 0.23 ms and at most 34 kN, out of the plane of C tilts a disk, I_t
  // = I_C/2.
  const double off_plane = 1e-3, tilting = 5.1 * off_plane / (p.inertia / 2);  // m, rad/s
  const double layer = two_pi * p.stator_radius * width * std::sqrt(1.2e-5 * 0.023);
  return {{"raised_um", 1e6 * raised},
          {"raised_force", 100 * std::abs(closer_N / peak_N - 1)},
          {"piece_mm", 1e3 * cube},
          {"piece_clearances", cube / clearance},
          {"piece_N_s", loss.lost_mass * loss.piece_velocity(speed)},
          {"plastic_um", 1e6 * plastic},
          {"half_chord_mm", 1e3 * half_chord},
          {"warming_K", 1380 / (3.6e6 * layer)},
          {"tilt_um", 1e6 * tilting / 2 * 2.3e-4 * p.rotor_radius},
          {"gyroscopic_N_m", p.inertia * speed * tilting},
          {"tilting_N_m", 34e3 * off_plane},
          // Of the contact's vibration against a free ring of 1 kg, over that against a fixed one.
          {"ring_rate", std::sqrt(1 + p.mass)}};
}

/// The same text with the numbers as they are. Throws std::invalid_argument for an unknown name.
std::string with_marked_numbers(const std::string& markdown, const Json& values) {
  static const std::regex mark("<!--([\\w.]+)-->[^<]*<!---->");
  std::string text;
  auto rest = markdown.cbegin();
  for (std::sregex_iterator at(markdown.begin(), markdown.end(), mark), end; at != end; ++at) {
    const std::string name = (*at)[1];
    text.append(rest, (*at)[0].first);
    text += "<!--" + name + "-->" +
            with_numbers(Json("{{" + name + "}}"), values).get<std::string>() + "<!---->";
    rest = (*at)[0].second;
  }
  return text.append(rest, markdown.cend());
}

/// What can be named: `values_json`, and beside it claims, figures.3, corrections, reasons, laws,
/// population_c, contact_laws, left_out, proven, limits.
Json markable_values(const std::vector<Number>& judged,
                     const std::filesystem::path& reference_data) {
  Json values = values_json(judged);
  add_verdicts(values, judged);
  values["corrections"] = corrections_json();
  values["reasons"] = reasons_json(reference_data / "reasons-tried.csv");
  values["laws"] = laws_json(reference_data / "laws.csv");
  values["population_c"]["never_reach_the_speed"] =
      too_slow_percent(reference_data / "printed-inputs.csv");
  values["contact_laws"] = contact_laws_json(reference_data / "contact-laws.csv");
  values["left_out"] = left_out_json(values["published"]["mu_03"]["peak_kN"].get<double>());
  values["proven"] = proven_json(reference_data / "proven.csv");
  values["limits"] = limits_json();
  return values;
}

std::vector<fs::path> markdown_files() {
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator at(ROTOR_SOURCES), end; at != end; ++at) {
    const std::string name = at->path().filename();
    if (at->is_directory() && (name.starts_with('.') || name.starts_with("build")))
      at.disable_recursion_pending();
    else if (at->path().extension() == ".md")
      files.push_back(at->path());
  }
  return files;
}

TEST(MarkedNumbers, ArePutBetweenTheirMarks) {
  const Json values = {{"peak", {{"kN", 454.836}}}, {"says", "holds, 3 of 3"}};
  EXPECT_EQ(
      with_marked_numbers("| <!--peak.kN.f1-->?<!----> kN | <!--says--><!----> | <!--x-->", values),
      "| <!--peak.kN.f1-->454.8<!----> kN | <!--says-->holds, 3 of 3<!----> | <!--x-->");
  EXPECT_THROW(with_marked_numbers("<!--peak.MN.f1-->0.5<!---->", values), std::invalid_argument);
}

TEST(ApprovedNumbers, OfMarkdownAreThoseThatAreComputed) {
  const Json values = markable_values(judged(), ROTOR_REFERENCE_DATA);
  for (const fs::path& file : markdown_files()) {
    const std::string before = content_of(file), now = with_marked_numbers(before, values);
    if (std::getenv("ROTOR_APPROVE") && now != before)
      std::ofstream(file, std::ios::binary) << now;
    else
      EXPECT_EQ(before, now) << file << "\nIf this is as it should be: make approve";
  }
}

}  // namespace
}  // namespace rotor
