/// The figures: pictures, claims, statements of their scenes.
#include <fmt/format.h>

#include "figures/runs/scene.hpp"
#include "verification/report/document.hpp"
#include "verification/support/pattern.hpp"

namespace rotor {
namespace {

/// A picture from gnuplot as part of a page: as wide as possible, with unique names.
std::string inline_svg(std::string svg, const std::string& name) {
  svg = svg.substr(svg.find("<svg"));
  svg = replaced(svg, " id=\"gnuplot_[^\"]*\"", "");
  svg = replaced(svg, "id='([^']*)'", "id='" + name + "-$1'");
  svg = replaced(svg, "href='#([^']*)'", "href='#" + name + "-$1'");
  svg = replaced(svg, "url\\(#([^)]*)\\)", "url(#" + name + "-$1)");
  svg = replaced(svg, "<svg[^>]*viewBox=\"([^\"]*)\"[^>]*>",
                 "<svg viewBox=\"$1\" xmlns=\"http://www.w3.org/2000/svg\" "
                 "xmlns:xlink=\"http://www.w3.org/1999/xlink\">");
  return replaced(svg, "[ \t]*\n\\s*", "\n");
}

}  // namespace

Json figures_json(const Sources& sources, const Json& claims) {
  Json all = Json::array();
  for (const auto& [number, scene_file] : figure_files(sources.scenes)) {
    const std::string name = fmt::format("fig{:02}", number);
    const auto file = sources.scenes / (name + ".toml");
    const Scene scene = read_scene(file);
    const Json its_claims = claims_of(number, claims);
    all.push_back({{"number", std::to_string(number)},
                   {"name", name},
                   {"title", scene.title},
                   {"verdict", verdicts_json(its_claims)},
                   {"picture", inline_svg(content_of(sources.pictures / (name + ".svg")), name)},
                   {"scene", content_of(file)},
                   {"scene_file", "figures/paper/" + name + ".toml"},
                   {"claims", its_claims}});
  }
  return all;
}

}  // namespace rotor
