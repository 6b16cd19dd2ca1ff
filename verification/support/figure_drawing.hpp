/// The paper's figures, drawn as `make` draws them.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "figures/data/csv.hpp"
#include "figures/scenes/names.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {

class FigureDrawing : public CommandLine {
 protected:
  static std::string name_of_figure(int number) { return fmt::format("fig{:02}", number); }

  /// Into the folder: figNN.csv, figNN.svg.
  Outcome draw(int number, Equations equations, const std::string& points = "") const {
    return shell(fmt::format(
        "$rotor figure {0} --out . --equations {1} 2>/dev/null && gnuplot -e \"data = '{2}.csv'; "
        "output = '{2}.svg'; format = 'svg'; equations = '{1}'; points = '{4}'\" {3}/style.gp "
        "{3}/{2}.gp",
        number, name_of(equations), name_of_figure(number), ROTOR_SCENES, points));
  }
  std::vector<CsvRow> data_of(int number) const {
    return read_csv(folder_ / (name_of_figure(number) + ".csv"));
  }
};

}  // namespace rotor
