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

/// What can be named: `values_json`, and beside it claims, corrections, reasons, laws,
/// contact_laws, proven, limits.
Json markable_values(const std::vector<Number>& judged, const fs::path& reference_data) {
  Json values = values_json(judged);
  values["claims"] = verdicts_json(claims_json(judged));
  values["corrections"] = corrections_json();
  values["reasons"] = rows_by(reference_data / "reasons-tried.csv", {"reason", "equations"});
  values["laws"] =
      rows_by(reference_data / "laws.csv", {"equations", "quantity", "share_from", "share_to"});
  values["contact_laws"] = rows_by(reference_data / "contact-laws.csv",
                                   {"equations", "mu", "same_indentation", "exponent"});
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
