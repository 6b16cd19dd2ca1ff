/// Pictures that gnuplot draws from drafts in a temporary folder.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace rotor {

/// The folder of scenes and scripts: that of an installed program, wherever it is, or of the
/// sources.
std::filesystem::path figures_folder();

/// Throws unless a picture of the scene can be written: svg, pdf or png, by its extension.
void require_picture(const std::filesystem::path& out, const std::string& scene);

/// Files by their names.
using Drafts = std::vector<std::pair<std::string, std::string>>;

/// Draws with plot.gp and the drafts, among them settings.gp, and prints the picture's name. Throws
/// std::exception; then no picture is written.
void draw(const std::filesystem::path& out, const Drafts& drafts);

}  // namespace rotor
