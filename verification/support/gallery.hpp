/// Which figures the gallery, figures/paper/README.md, shows in which equations.
#pragma once

#include <fmt/format.h>

#include <set>
#include <string>

#include "model/mechanics/parameters.hpp"

namespace rotor {

/// Whether the corrected equations change what a figure shows.
inline bool is_changed_by_corrections(int figure) {
  return std::set<int>{3, 4, 5, 6, 7, 12, 13, 14, 15, 16}.contains(figure);
}

/// The picture of a figure in the gallery, figures/paper/README.md, relative to it.
inline std::string preview_of(int figure, Equations equations) {
  return fmt::format("preview/fig{:02}{}.svg", figure,
                     equations == Equations::published ? "" : "-corrected");
}

}  // namespace rotor
