/// The gallery figures/paper/README.md, for readers who build nothing. `make approve` writes it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "verification/report/document.hpp"
#include "verification/report/page.hpp"
#include "verification/support/paper_figures.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

const fs::path checkout = ROTOR_SOURCES;

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
  const fs::path file = checkout / "figures/paper/README.md";
  if (std::getenv("ROTOR_APPROVE")) std::ofstream(file, std::ios::binary) << text;
  EXPECT_EQ(content_of(file), text) << "If this is as it should be: make approve";
}

}  // namespace
}  // namespace rotor
