/// The paper's figures, drawn as `make` draws them.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "figures/data/csv.hpp"
#include "figures/scenes/names.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/svg_picture.hpp"

namespace rotor {

class FigureDrawing : public CommandLine {
 protected:
  static std::string name_of_figure(int number) { return fmt::format("fig{:02}", number); }

  /// Into the folder: figNN.csv, figNN.svg, or of another format.
  Outcome draw(int number, Equations equations, const std::string& points = "",
               const std::string& format = "svg") const {
    return shell(fmt::format(
        "$rotor figure {0} --out . --equations {1} 2>/dev/null && {3}/../draw.sh {2}.{5} "
        "\"data = '{2}.csv'; equations = '{1}'; points = '{4}'\" {3}/{2}.gp >/dev/null",
        number, name_of(equations), name_of_figure(number), ROTOR_SCENES, points, format));
  }
  std::vector<CsvRow> data_of(int number) const {
    return read_csv(folder_ / (name_of_figure(number) + ".csv"));
  }
};

/// The published figures.
class PublishedFigures : public FigureDrawing {
 protected:
  DrawnPicture drawn(int number) const {
    const Outcome outcome = draw(number, Equations::published);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    return DrawnPicture(content(name_of_figure(number) + ".svg"));
  }
  static void expect_said(const DrawnPicture& picture, const std::string& text) {
    EXPECT_NE(std::ranges::find(picture.texts, text), picture.texts.end()) << text;
  }
};

}  // namespace rotor
