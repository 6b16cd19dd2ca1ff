/// The drawn figures: `make approve` copies them into the gallery, figures/paper/README.md.
#include <algorithm>
#include <utility>

#include "verification/support/command_line.hpp"
#include "verification/support/content.hpp"
#include "verification/support/paper_figures.hpp"
#include "verification/support/svg_picture.hpp"

namespace rotor {
namespace {

class Pictures : public CommandLine, public testing::WithParamInterface<Figure> {
 protected:
  /// Draws it as make does. A missing column is an error of gnuplot.
  DrawnPicture drawn() const {
    const auto csv = [](Equations equations) {
      return FigureFolder::of(equations).csv(GetParam().number).string();
    };
    const auto [status, output] = shell(fmt::format(
        "'{0}/../draw.sh' a.svg \"data_published = '{1}'; data_corrected = "
        "'{2}';\" '{0}/fig{3:02}.gp' >/dev/null",
        ROTOR_SCENES, csv(Equations::published), csv(Equations::corrected), GetParam().number));
    EXPECT_EQ(status, 0);
    EXPECT_EQ(output, "");
    return DrawnPicture(content("a.svg"));
  }
};

// The same texts, and curves that extend as far, to half a pixel: other machines round differently.
TEST_P(Pictures, AreThoseOfTheGallery) {
  const DrawnPicture picture = drawn();
  EXPECT_EQ(picture.clipped, std::vector<std::string>());
  EXPECT_EQ(picture.hiding, std::vector<std::string>());
  EXPECT_FALSE(has(content("a.svg"), "<title>"));  // gnuplot's, not the figure's
  const fs::path file = fs::path(ROTOR_SCENES) / preview_of(GetParam().number);
  if (std::getenv("ROTOR_APPROVE"))
    fs::copy_file(folder_ / "a.svg", file, fs::copy_options::overwrite_existing);
  const DrawnPicture preview(content_of(file));
  const std::string hint = file.string() + "\nIf this is as it should be: make approve";
  EXPECT_EQ(preview.texts, picture.texts) << hint;
  ASSERT_EQ(preview.curves.size(), picture.curves.size()) << hint;
  for (std::size_t n = 0; n < picture.curves.size(); ++n)
    for (const auto& member : {&Points::value_type::first, &Points::value_type::second}) {
      const auto ends = [&](const DrawnPicture& of) {
        const auto [low, high] = std::ranges::minmax(of.curves[n].points, {}, member);
        return std::pair(low.*member, high.*member);
      };
      EXPECT_NEAR(ends(preview).first, ends(picture).first, 0.5) << hint;
      EXPECT_NEAR(ends(preview).second, ends(picture).second, 0.5) << hint;
    }
}

INSTANTIATE_TEST_SUITE_P(Approved, Pictures, testing::ValuesIn(paper_figures()),
                         [](const auto& of) { return fmt::format("Fig{:02}", of.param.number); });

}  // namespace
}  // namespace rotor
