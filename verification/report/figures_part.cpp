/// The figures: pictures of both sets of equations, claims, statements of their scenes.
#include <fmt/format.h>

#include <regex>
#include <set>

#include "figures/input/scene.hpp"
#include "verification/report/digitised.hpp"
#include "verification/report/document.hpp"

namespace rotor {
namespace {

/// The figures whose story the corrected equations change.
const std::set<int> told_twice = {3, 4, 5, 6, 7, 12, 13, 14, 15, 16};

std::string replaced(const std::string& text, const char* pattern, const std::string& by) {
  return std::regex_replace(text, std::regex(pattern), by);
}

/// A picture of gnuplot's as a part of a page: as wide as there is room, with names of its own, and
/// said in words.
std::string inline_svg(std::string svg, const std::string& name, const std::string& label_id) {
  svg = svg.substr(svg.find("<svg"));
  svg = replaced(svg, "<title>[^<]*</title>|<desc>[^<]*</desc>| id=\"gnuplot_[^\"]*\"", "");
  svg = replaced(svg, "id='([^']*)'", "id='" + name + "-$1'");
  svg = replaced(svg, "href='#([^']*)'", "href='#" + name + "-$1'");
  svg = replaced(svg, "url\\(#([^)]*)\\)", "url(#" + name + "-$1)");
  svg = replaced(svg, "<svg[^>]*viewBox=\"([^\"]*)\"[^>]*>",
                 "<svg viewBox=\"$1\" role=\"img\" aria-labelledby=\"" + label_id +
                     "\" xmlns=\"http://www.w3.org/2000/svg\" "
                     "xmlns:xlink=\"http://www.w3.org/1999/xlink\">");
  return replaced(svg, "[ \t]*\n\\s*", "\n");
}

Json picture_json(const Sources& sources, int figure, const std::string& equations) {
  const std::string name = fmt::format("fig{:02}", figure);
  const auto folder = sources.report / "figures" / equations;
  const std::vector<FigureCurve> curves = read_curves(folder / (name + ".csv"));
  std::string alternative = fmt::format("Fig. {}, {} equations.", figure, equations);
  for (const FigureCurve& curve : curves) {
    const std::string run = curve.run == "run" ? "" : ", " + curve.run;
    alternative += fmt::format(" {}{}: {}.", curve.words, run, in_words(curve));
  }
  const std::string id = name + "-" + equations;
  return {{"equations", equations},
          {"id", id},
          {"alternative", alternative},
          {"svg", inline_svg(content_of(folder / (name + ".svg")), id, id + "-says")},
          {"svg_file", fmt::format("figures/{}/{}.svg", equations, name)},
          {"csv_file", fmt::format("figures/{}/{}.csv", equations, name)}};
}

Json runs_json(const Scene& scene) {
  Json runs = Json::array();
  for (const SceneRun& run : scene.runs)
    runs.push_back({{"name", run.name},
                    {"method", name_of(run.scenario.method)},
                    {"friction", run.scenario.parameters.friction},
                    {"contact_stiffness", run.scenario.parameters.contact_stiffness},
                    {"mass_loss_s", run.scenario.parameters.loses_mass
                                        ? Json(run.scenario.parameters.mass_loss_time)
                                        : Json()},
                    {"until_s", run.scenario.until}});
  return runs;
}

}  // namespace

Json figures_json(const Sources& sources, const Json& claims) {
  Json all = Json::array();
  for (const auto& [number, scene_file] : figure_files(sources.scenes)) {
    const std::string name = fmt::format("fig{:02}", number);
    const auto file = sources.scenes / (name + ".toml");
    const Scene scene = read_scene(file);
    Json its_claims = Json::array();
    std::vector<const Json*> judged;
    for (const Json& claim : claims)
      for (const Json& figure : claim.at("figures"))
        if (figure == number) {
          its_claims.push_back(claim);
          judged.push_back(&claim);
        }
    Json pictures = Json::array({picture_json(sources, number, "published")});
    if (told_twice.contains(number))
      pictures.push_back(picture_json(sources, number, "consistent"));
    const auto curves = read_curves(sources.report / "figures" / "published" / (name + ".csv"));
    const Json digitised = digitised_json(sources.reference_data, number, curves);
    all.push_back({{"number", std::to_string(number)},
                   {"name", name},
                   {"title", scene.title},
                   {"verdict", verdicts_json(judged)},
                   {"pictures", pictures},
                   {"is_told_twice", told_twice.contains(number)},
                   {"is_whirl", number == 7 || number == 10},
                   {"runs", runs_json(scene)},
                   {"scene", content_of(file)},
                   {"scene_file", "figures/paper/" + name + ".toml"},
                   {"claims", its_claims},
                   {"has_claims", !its_claims.empty()},
                   {"digitised", digitised},
                   {"has_digitised", !digitised.empty()}});
  }
  return all;
}

}  // namespace rotor
