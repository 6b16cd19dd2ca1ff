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
#include "verification/report/page.hpp"
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
/// population_c.
Json markable_values(const std::vector<Number>& judged,
                     const std::filesystem::path& reference_data) {
  Json values = values_json(judged);
  add_verdicts(values, judged);
  values["corrections"] = corrections_json();
  values["reasons"] = reasons_json(reference_data / "reasons-tried.csv");
  values["laws"] = laws_json(reference_data / "laws.csv");
  values["population_c"]["never_reach_the_speed"] =
      too_slow_percent(reference_data / "printed-inputs.csv");
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
