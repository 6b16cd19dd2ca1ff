/// Pictures that gnuplot draws from drafts in a temporary folder.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "model/scenario/scenario.hpp"

namespace rotor {

/// The folder of scenes and scripts: that of an installed program, wherever it is, or of the
/// sources.
std::filesystem::path figures_folder();

/// Throws unless a picture of the scene can be written: svg, pdf or png, by its extension.
void require_picture(const std::filesystem::path& out, const std::string& scene);

/// Files by their names.
using Drafts = std::vector<std::pair<std::string, std::string>>;

/// Writes them into an existing folder.
void write_drafts(const std::filesystem::path& folder, const Drafts& drafts);

/// Draws with a script of that folder and the drafts, among them settings.gp, and prints the
/// picture's name. Throws std::exception; then no picture is written.
void draw(const std::filesystem::path& out, const std::string& script, const Drafts& drafts);

/// Items of a list, in lines of pictures that end between them.
class Items {
 public:
  void add(const std::string& item);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// The unit of a quantity in pictures, in which lengths are in mm, and its size in SI units.
std::string unit_in_words(const Quantity& quantity);
double unit_of(const Quantity& quantity);
/// What has been printed is there before messages that follow, in a pipe, too. Throws
/// std::system_error.
void print_before_messages();

/// A title with F_n as pictures have it.
std::string with_indices(std::string title);

/// "clearance = 2 mm"
std::string with_unit(const Quantity& quantity, double value);

}  // namespace rotor
