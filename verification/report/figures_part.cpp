/// The figures: pictures, claims, statements of their scenes.
#include <fmt/format.h>

#include "figures/runs/scene.hpp"
#include "verification/report/document.hpp"
#include "verification/support/pattern.hpp"

namespace rotor {

/// What gnuplot repeats for each text is said once, at the root or in page.css.
std::string inline_svg(std::string svg, const std::string& name) {
  svg = svg.substr(svg.find("<svg"));
  svg = replaced(svg, " *(font-family=\"[^\"]*\"|text-anchor=\"start\"|xml:space=\"preserve\") *",
                 " ");
  svg = replaced(svg, "<tspan ?>([^<]*)</tspan>", "$1");
  svg = replaced(svg,
                 "<g transform=\"translate\\(([^,]*),([^)]*)\\)\" stroke=\"none\"([^>]*)>\\s*<text "
                 "?>([^<]*)</text>\\s*</g>",
                 "<text x=\"$1\" y=\"$2\"$3>$4</text>");
  const std::string size = matches(svg, " font-size=\"[^\"]*\"").at(0).at(0);
  svg = replaced(svg, "(<(?:g|text) [^>]*)" + size, "$1");
  svg = replaced(svg, " id=\"gnuplot_[^\"]*\"", "");
  svg = replaced(svg, "id='([^']*)'", "id='" + name + "-$1'");
  svg = replaced(svg, "href='#([^']*)'", "href='#" + name + "-$1'");
  svg = replaced(svg, "url\\(#([^)]*)\\)", "url(#" + name + "-$1)");
  svg = replaced(svg, "<svg[^>]*viewBox=\"([^\"]*)\"[^>]*>",
                 "<svg viewBox=\"$1\" xmlns=\"http://www.w3.org/2000/svg\" "
                 "xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
                 "font-family=\"DejaVu Sans, sans-serif\"" +
                     size + ">");
  return replaced(svg, "[ \t]*\n\\s*", "\n");
}

Json figures_json(const Sources& sources, const std::vector<Number>& numbers) {
  Json all = Json::array();
  for (const auto& [number, scene_file] : figure_files(sources.scenes)) {
    const std::string name = fmt::format("fig{:02}", number);
    const auto file = sources.scenes / (name + ".toml");
    const Scene scene = read_scene(file);
    all.push_back({{"number", std::to_string(number)},
                   {"name", name},
                   {"title", scene.title},
                   {"tally", tally_of_figure(number, numbers)},
                   {"picture", inline_svg(content_of(sources.pictures / (name + ".svg")), name)},
                   {"scene", content_of(file)},
                   {"scene_file", "figures/paper/" + name + ".toml"}});
  }
  return all;
}

}  // namespace rotor
