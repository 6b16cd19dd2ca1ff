/// Pictures that gnuplot draws from drafts in a temporary folder.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "figures/data/files.hpp"
#include "figures/results/provenance.hpp"

namespace rotor {

/// One picture: svg, pdf or png, by its extension. All throw std::exception; then no picture is
/// written.
class Drawing {
 public:
  /// The picture of a scene.
  Drawing(const std::string& file, const std::string& out);
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;
  ~Drawing();

  /// The path of a draft in gnuplot's folder.
  std::filesystem::path file(const std::string& name) const { return folder_.path / name; }
  void write(const std::string& name, std::string_view text) const;

  /// Draws with settings and a script from figures/program, and prints the picture's name.
  void finish(const std::string& settings, const std::string& script) const;

 private:
  std::filesystem::path out_;
  std::string picture_;
  Draft folder_;
};

}  // namespace rotor
