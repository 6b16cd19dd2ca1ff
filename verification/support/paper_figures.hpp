/// The paper's figures, and their data, which the program writes once for all tests.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "figures/data/read_csv.hpp"
#include "figures/input/names.hpp"
#include "figures/runs/scene.hpp"

namespace rotor {

struct Figure {
  int number;
  Scene scene;
};

inline void PrintTo(const Figure& figure, std::ostream* out) { *out << "Fig. " << figure.number; }

inline std::vector<Figure> paper_figures() {
  std::vector<Figure> figures;
  for (const auto& [number, file] : figure_files(ROTOR_SCENES))
    figures.push_back({number, read_scene(file)});
  return figures;
}

/// The picture of a figure in the gallery, figures/paper/README.md, relative to it.
inline std::string preview_of(int figure) { return fmt::format("preview/fig{:02}.svg", figure); }

class FigureFolder {
 public:
  static const FigureFolder& of(Equations equations) {
    static const FigureFolder published(Equations::published), corrected(Equations::corrected);
    return equations == Equations::published ? published : corrected;
  }
  ~FigureFolder() { std::filesystem::remove_all(path_); }
  FigureFolder(const FigureFolder&) = delete;
  FigureFolder& operator=(const FigureFolder&) = delete;

  std::filesystem::path csv(int number) const {
    return path_ / fmt::format("fig{:02}.csv", number);
  }
  std::vector<CsvRow> rows(int number) const { return read_csv(csv(number)); }

 private:
  explicit FigureFolder(Equations equations)
      : path_(std::filesystem::temp_directory_path() /
              fmt::format("rotor-figures-{}-{}", ::getpid(), name_of(equations))) {
    std::filesystem::create_directory(path_);
    const std::string command = fmt::format("'{}' figure --out '{}' --equations {} >/dev/null 2>&1",
                                            ROTOR_PROGRAM, path_.string(), name_of(equations));
    if (std::system(command.c_str()) != 0) throw std::runtime_error(command);
  }

  std::filesystem::path path_;
};

}  // namespace rotor
