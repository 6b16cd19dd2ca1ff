/// The gallery figures/paper/README.md: the figures for readers who build nothing.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "verification/report/document.hpp"
#include "verification/report/page.hpp"
#include "verification/support/approved.hpp"
#include "verification/support/paper_figures.hpp"

namespace rotor {
namespace {

TEST(ApprovedGallery, ShowsEachFigureWithItsCommandItsVerdictsAndItsNumbers) {
  const Json texts = with_numbers(read_json(ROTOR_SOURCES "/verification/report/texts.json"),
                                  values_json(judged()));
  std::string text = R"(# The figures

Redrawn from the equations as printed and from the corrected ones: in blue and in brown. This page is written by
`make approve`. The paper's printed curves were not available.
)";
  for (const Figure& figure : paper_figures()) {
    const Json tally = tally_of_figure(figure.number, judged());
    text += fmt::format(
        "\n## Fig. {0}: {1}\n\n`make fig{0:02}`. Claims: {2}{3}.\n\n{4}\n\n![{5}]({6})\n",
        figure.number, figure.scene.title, tally["as_printed"]["words"].get<std::string>(),
        tally["claims"].empty() ? ""
                                : "; corrected: " + tally["corrected"]["words"].get<std::string>(),
        texts.at("captions").at(std::to_string(figure.number)).get<std::string>(),
        texts.at("seen").at(std::to_string(figure.number)).get<std::string>(),
        preview_of(figure.number));
  }
  for (const Json& other : texts.at("other_pictures"))
    text +=
        fmt::format("\n## {}\n\n`{}`. {}\n\n![{}]({})\n", other.at("title").get<std::string>(),
                    other.at("command").get<std::string>(), other.at("text").get<std::string>(),
                    other.at("seen").get<std::string>(), other.at("picture").get<std::string>());
  expect_approved("figures/paper/README.md", text);
}

}  // namespace
}  // namespace rotor
