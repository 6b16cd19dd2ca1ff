/// Pictures that gnuplot draws from drafts, in a folder that is gone in the end.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rotor {

/// A text for gnuplot, by the numbers of its bytes: nothing in it can be taken for a command.
std::string numbered(std::string_view text);

/// One picture, svg, pdf or png by how its name ends. All throw std::exception; then no picture is
/// written.
class Drawing {
 public:
  /// Of what a file states, to `out`; if that is empty, to the file's name with .svg.
  Drawing(const std::string& file, const std::string& out);
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;
  ~Drawing();

  /// A draft, where gnuplot works.
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, std::string_view text) const;

  /// What is drawn of a title, or of the picture's name if that is empty.
  std::string heading(const std::string& title) const;

  /// Draws by settings and a script beside this program, and prints the picture's name.
  void finish(const std::string& settings, const std::string& script) const;

 private:
  std::filesystem::path out_, folder_;
  std::string_view extension_;
};

}  // namespace rotor
