/// Files that list the figures for readers who build nothing: codecheck.yml and the gallery
/// figures/paper/README.md. `make approve` writes them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "figures/sweep/sweep.hpp"
#include "verification/report/document.hpp"
#include "verification/report/page.hpp"
#include "verification/support/paper_figures.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

const fs::path checkout = ROTOR_SOURCES;

void expect_approved(const fs::path& file, const std::string& text) {
  if (std::getenv("ROTOR_APPROVE")) std::ofstream(checkout / file, std::ios::binary) << text;
  EXPECT_EQ(content_of(checkout / file), text)
      << file << "\nIf this is as it should be: make approve";
}

/// A quoted text of YAML.
std::string quoted(std::string text) {
  for (std::size_t at = 0; (at = text.find('\'', at)) != std::string::npos; at += 2)
    text.insert(at, "'");
  return '\'' + text + '\'';
}

// https://codecheck.org.uk/spec/config/latest: what a checker makes and compares. The paper's
// authors and reference are not known.
TEST(ApprovedManifest, ListsEveryFigureMapAndTableWithTheTargetThatMakesIt) {
  std::string text = R"(---
version: https://codecheck.org.uk/spec/config/1.0/
# A replication from the text: new code, and no data of the authors. Unknown: the paper's authors,
# journal, year and DOI; see CITATION.cff.
paper:
  title: Overcritical high-speed rotor systems, full annular rub and accident
  authors:
    - name: UNKNOWN
  reference: UNKNOWN
manifest:
)";
  const auto add = [&](const std::string& file, const std::string& target,
                       const std::string& title) {
    text += fmt::format("  - file: {}\n    comment: {}\n", file,
                        quoted(fmt::format("make {}: {}", target, title)));
  };
  for (const Figure& figure : paper_figures()) {
    const std::string name = fmt::format("fig{:02}", figure.number);
    add(fmt::format("build/figures/{}.svg", name), name, figure.scene.title);
  }
  std::vector<fs::path> maps;
  for (const auto& entry : fs::directory_iterator(checkout / "figures/maps"))
    if (entry.path().extension() == ".toml") maps.push_back(entry.path());
  std::ranges::sort(maps);
  for (const fs::path& map : maps) {
    const std::string name = map.stem();
    for (const char* shows : {"-outcome", "-force"})
      if (name != "rounding" || shows == std::string("-outcome"))
        add(fmt::format("build/maps/{}{}.svg", name, name == "rounding" ? "" : shows), "maps",
            read_sweep(map).title);
  }
  const std::string makefile = content_of(checkout / "Makefile");
  for (const auto& [target, file, title] :
       {std::tuple("report", "build/report/claims.csv", "the verdict on each claim"),
        {"ensembles", "reference-data/ensembles.csv", "claims over the rounding of the inputs"},
        {"laws", "reference-data/laws.csv", "closed forms on random rotors"},
        {"contact-laws", "reference-data/contact-laws.csv", "other laws of the ring"},
        {"reasons", "reference-data/reasons-tried.csv", "the text's reasons on random rotors"},
        {"prove", "reference-data/proven.csv", "bounds by ball arithmetic"},
        {"validate", "reference-data/independent.csv", "the accidents by an independent code"},
        {"reference", "reference-data/high-precision.csv", "runs in quadruple precision"}}) {
    add(file, target, title);
    EXPECT_NE(makefile.find(fmt::format("\n{}: ", target)), std::string::npos) << target;
    EXPECT_TRUE(std::string(file).starts_with("build/") || fs::exists(checkout / file)) << file;
  }
  expect_approved("codecheck.yml", text);
}

TEST(ApprovedGallery, ShowsEachFigureWithItsCommandItsVerdictsAndItsNumbers) {
  const Json claims = claims_json(judged());
  const Json captions = with_numbers(
      read_json(checkout / "verification/report/texts.json").at("captions"), values_json(judged()));
  std::string text = R"(# The figures

Redrawn from the equations as printed and from the corrected ones: in blue and in brown. This page is written by
`make approve`. The paper's printed curves were not available: its numbers, in grey, are beside ours in the pictures.
)";
  for (const Figure& figure : paper_figures()) {
    const Json its = claims_of(figure.number, claims), verdicts = verdicts_json(its);
    text += fmt::format(
        "\n## Fig. {0}: {1}\n\n`make fig{0:02}`. Claims: {2}{3}.\n\n{4}\n\n![Fig. {0}]({5})\n",
        figure.number, figure.scene.title, verdicts["as_printed"]["says"].get<std::string>(),
        its.empty() ? "" : "; corrected: " + verdicts["corrected"]["says"].get<std::string>(),
        captions.at(std::to_string(figure.number)).get<std::string>(), preview_of(figure.number));
  }
  expect_approved("figures/paper/README.md", text);
}

}  // namespace
}  // namespace rotor
