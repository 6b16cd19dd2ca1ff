/// Tables of computed numbers in Markdown: a line such as `<!-- table: results -->` is followed by
/// the table of that name in tables.mustache, whose places are those of `with_numbers`; `make
/// approve` writes it.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "figures/data/read_csv.hpp"
#include "figures/input/names.hpp"
#include "model/mechanics/mass_loss.hpp"
#include "model/theory/accident.hpp"
#include "verification/report/page.hpp"
#include "verification/support/approved.hpp"
#include "verification/support/onset_speed.hpp"
#include "verification/support/pattern.hpp"

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
  for (const Equations& equations : {Equations::published, Equations::corrected}) {
    const double speed_Hz = onset_speed_Hz(equations, 0), speed = two_pi * speed_Hz;
    all[std::string(name_of(equations))] = {
        {"speed_Hz", speed_Hz},
        {"turns", speed_Hz * swing_s},
        {"above_law", 100 * (speed / Accident(p, equations, speed).contact_speed.value() - 1)}};
  }
  return all;
}

/// The rows of each table, by its name in the line before them.
std::map<std::string, std::string> tables_of(const std::string& templates) {
  std::map<std::string, std::string> tables;
  std::istringstream lines(templates);
  std::string* table = nullptr;
  for (std::string line; std::getline(lines, line);)
    if ((line.starts_with('|') || line.starts_with("{{")) && table != nullptr)
      *table += line + '\n';
    else
      table = &tables[line];
  return tables;
}

/// The same text with the tables as they are. Throws std::out_of_range for an unknown name.
std::string with_tables(const std::string& markdown,
                        const std::map<std::string, std::string>& tables, const Json& values) {
  std::string text;
  std::istringstream lines(markdown);
  bool replaces = false;
  for (std::string line; std::getline(lines, line);) {
    replaces = replaces && line.starts_with('|');
    if (replaces) continue;
    text += line + '\n';
    for (const Match& mark : matches(line, "^<!-- table: (.*) -->$")) {
      text += with_numbers(Json(tables.at(mark[1])), values).get<std::string>();
      replaces = true;
    }
  }
  return text;
}

/// A row for each run of proven.csv: its start, equations and end, what is proven of it, and within
/// how much of the printed clearance, if the inputs are not the printed ones alone.
std::string proof_rows(const fs::path& proven) {
  std::vector<std::string> commands, rows;
  std::map<std::string, std::map<std::string, std::string>> values;
  for (const CsvRow& row : read_csv(proven)) {
    auto& of_run = values[row["command"]];
    if (of_run.empty()) commands.push_back(row["command"]);
    of_run[row["quantity"]] = row["lower"];
  }
  for (const std::string& command : commands) {
    std::map<std::string, std::string> option;
    for (const Match& stated : matches(command, "--(\\S+) (\\S+)")) option[stated[1]] = stated[2];
    const auto& of_run = values.at(command);
    constexpr double half_digit_of_clearance_um = 500;  // 0.003 m
    rows.push_back(fmt::format(
        "| {}, mu = {} | {} | {} | {}{} | {} |",
        option.contains("start-speed-Hz")
            ? fmt::format("steady motion at {} Hz, loss at once", option["start-speed-Hz"])
            : "from rest, loss at 29.1 s",
        option["friction"], option["equations"] == "published" ? "as printed" : "corrected",
        option["until"], of_run.at("touch_downs"),
        of_run.contains("rolling_onset_s") ? ", then rolling" : ", no rolling",
        option.contains("rounding")
            ? fmt::format("a box, clearance +- {:g} um",
                          half_digit_of_clearance_um * std::stod(option["rounding"]))
            : "as printed"));
  }
  return fmt::format("{}", fmt::join(rows, "\n"));
}

/// What can be named: `values_json`, and beside it tally, rows, reasons, laws, contact_laws,
/// limits.
Json table_values(const std::vector<Number>& judged, const fs::path& reference_data) {
  Json values = values_json(judged);
  values["tally"] = tally_json(judged);
  values["rows"] = {{"claims", claim_rows(judged)},
                    {"refuted", refuted_rows(judged)},
                    {"proofs", proof_rows(reference_data / "proven.csv")}};
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

TEST(ApprovedTables, OfMarkdownAreThoseThatAreComputed) {
  const Json values = table_values(judged(), ROTOR_REFERENCE_DATA);
  const auto tables = tables_of(content_of(ROTOR_SOURCES "/verification/report/tables.mustache"));
  for (const std::string& file : markdown_files())
    expect_approved(file, with_tables(content_of(fs::path(ROTOR_SOURCES) / file), tables, values));
}

}  // namespace
}  // namespace rotor
