/// Numbers in Markdown that are computed: between a comment that names one and an empty comment, as
/// in `<!--published.mu_03.peak_normal_force_N.k1-->454.8<!---->`. Names and forms are those of
/// `with_numbers`; `make approve` writes them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "figures/input/names.hpp"
#include "model/mechanics/mass_loss.hpp"
#include "model/theory/accident.hpp"
#include "verification/report/page.hpp"
#include "verification/support/approved.hpp"
#include "verification/support/onset_speed.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

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

/// What can be named: `values_json`, and beside it claims, reasons, laws, contact_laws, limits.
Json markable_values(const std::vector<Number>& judged, const fs::path& reference_data) {
  Json values = values_json(judged);
  values["claims"] = verdicts_json(claims_json(judged));
  values["reasons"] = rows_by(reference_data / "reasons-tried.csv", {"reason", "equations"});
  values["laws"] =
      rows_by(reference_data / "laws.csv", {"equations", "quantity", "share_from", "share_to"});
  values["contact_laws"] = rows_by(reference_data / "contact-laws.csv",
                                   {"equations", "mu", "same_indentation", "exponent"});
  values["limits"] = limits_json();
  return values;
}

/// From the root of the sources.
std::vector<std::string> markdown_files() {
  std::vector<std::string> files;
  for (fs::recursive_directory_iterator at(ROTOR_SOURCES), end; at != end; ++at) {
    const std::string name = at->path().filename();
    if (at->is_directory() && (name.starts_with('.') || name.starts_with("build")))
      at.disable_recursion_pending();
    else if (at->path().extension() == ".md")
      files.push_back(fs::relative(at->path(), ROTOR_SOURCES));
  }
  return files;
}

TEST(MarkedNumbers, ArePutBetweenTheirMarks) {
  const Json values = {{"peak", {{"N", 454836.}}}, {"says", "holds, 3 of 3"}};
  EXPECT_EQ(
      with_marked_numbers("| <!--peak.N.k1-->?<!----> kN | <!--says--><!----> | <!--x-->", values),
      "| <!--peak.N.k1-->454.8<!----> kN | <!--says-->holds, 3 of 3<!----> | <!--x-->");
  EXPECT_THROW(with_marked_numbers("<!--peak.MN.k1-->0.5<!---->", values), std::invalid_argument);
}

TEST(ApprovedNumbers, OfMarkdownAreThoseThatAreComputed) {
  const Json values = markable_values(judged(), ROTOR_REFERENCE_DATA);
  for (const std::string& file : markdown_files())
    expect_approved(file, with_marked_numbers(content_of(fs::path(ROTOR_SOURCES) / file), values));
}

}  // namespace
}  // namespace rotor
