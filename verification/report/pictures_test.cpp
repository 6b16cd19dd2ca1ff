/// The drawn figures: `make approve` copies them into the gallery, figures/paper/README.md, and the
/// picture of the claims into verification/paper.
#include <algorithm>
#include <utility>

#include "verification/paper/tally.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/content.hpp"
#include "verification/support/paper_figures.hpp"
#include "verification/support/svg_picture.hpp"

namespace rotor {
namespace {

class DrawnPictures : public CommandLine {
 protected:
  /// Draws a.svg as make does; a missing column is an error of gnuplot. It has the same texts as
  /// the approved file, and curves that extend as far, to half a pixel: other machines round
  /// differently.
  void expect_approved_picture(const std::string& settings, const std::string& script,
                               const fs::path& file) const {
    const auto [status, output] = shell(fmt::format("'{}/../draw.sh' a.svg \"{}\" '{}' >/dev/null",
                                                    ROTOR_SCENES, settings, script));
    EXPECT_EQ(status, 0);
    EXPECT_EQ(output, "");
    const DrawnPicture picture(content("a.svg"));
    EXPECT_EQ(picture.clipped, std::vector<std::string>());
    EXPECT_EQ(picture.overlapping, std::vector<std::string>());
    EXPECT_EQ(picture.hiding, std::vector<std::string>());
    EXPECT_FALSE(has(content("a.svg"), "<title>"));  // gnuplot's, not the figure's
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
};

class Pictures : public DrawnPictures, public testing::WithParamInterface<Figure> {};

TEST_P(Pictures, AreThoseOfTheGallery) {
  const auto csv = [](Equations equations) {
    return FigureFolder::of(equations).csv(GetParam().number).string();
  };
  expect_approved_picture(fmt::format("data_published = '{}'; data_corrected = '{}';",
                                      csv(Equations::published), csv(Equations::corrected)),
                          fmt::format("{}/fig{:02}.gp", ROTOR_SCENES, GetParam().number),
                          fs::path(ROTOR_SCENES) / preview_of(GetParam().number));
}

using ApprovedPicture = DrawnPictures;

TEST_F(ApprovedPicture, OfTheClaimsIsThatOfTheirData) {
  write("claims.csv", to_csv(judged()));
  expect_approved_picture("data = 'claims.csv'", ROTOR_SOURCES "/verification/paper/claims.gp",
                          ROTOR_SOURCES "/verification/paper/claims.svg");
}

INSTANTIATE_TEST_SUITE_P(Approved, Pictures, testing::ValuesIn(paper_figures()),
                         [](const auto& of) { return fmt::format("Fig{:02}", of.param.number); });

}  // namespace
}  // namespace rotor
