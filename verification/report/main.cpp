/// Writes the reviewer's page, index.html, into the folder OUT that has its data:
///   report-page SOURCES BUILD OUT DATE
#include <fmt/format.h>

#include <set>

#include "figures/data/files.hpp"
#include "verification/report/page.hpp"
#include "verification/support/pattern.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

/// A module and its imports as one script, each a function that is called once and returns its
/// exports.
std::string bundled(const fs::path& module, std::set<fs::path>& seen) {
  std::string before, names;
  if (!seen.insert(module).second) return "";
  std::string text =
      replaced('\n' + content_of(module), "import (\\{[^}]*\\}) from \"\\./(\\w+)\\.js\";\n",
               [&](const Match& import) {
                 before += bundled(module.parent_path() / (import[2] + ".js"), seen);
                 return "const " + import[1] + " = of_" + import[2] + ";\n";
               });
  text = replaced(text, "\nexport ((?:const|function|class) (\\w+))", [&](const Match& exported) {
    names += exported[2] + ", ";
    return '\n' + exported[1];
  });
  return fmt::format("{}const of_{} = (() => {{{}return {{ {}}};\n}})();\n", before,
                     module.stem().string(), text, names);
}

/// The names of numbers in the picture of claims lead to their rows.
std::string with_links(std::string picture, const Json& shown) {
  for (const Json& passage : shown.at("claims"))
    for (const Json& row : passage.at("rows")) {
      const auto id = row.at("id").get<std::string>();
      picture = replaced(picture, "(<text[^>]*>(?:<tspan[^>]*>)?" + id + "(?:</tspan>)?</text>)",
                         "<a href=\"#number-" + id + "\">$1</a>");
    }
  return picture;
}

int main(const Arguments& arguments) {
  if (arguments.size() != 3)
    throw std::runtime_error("needs the folders of the sources, of what was built and of the page");
  const fs::path root = arguments[0], build = arguments[1], out = arguments[2],
                 room = root / "verification/report";
  Json shown = document({.texts = room / "texts.json",
                         .scenes = root / "figures/paper",
                         .reference_data = root / "reference-data",
                         .pictures = build / "figures"});
  std::set<fs::path> seen;
  shown["style"] = tints_of_page() + content_of(room / "page.css");
  shown["script"] = bundled(room / "script/main.js", seen);
  // If it is built: emscripten's script with the worker, and base64.
  if (const fs::path packed = out / "engine.wasm.gz.base64"; fs::exists(packed))
    shown["engine"] = {
        {"worker", content_of(build / "explore/engine.js") + content_of(room / "script/worker.js")},
        {"wasm", content_of(packed)}};
  shown["instrument"] = instrument_json(out).dump();
  shown["model"] = content_of(root / "figures/paper/preview/model.svg");
  shown["picture"] = with_links(inline_svg(content_of(out / "claims.svg"), "claims"), shown);
  shown["stills"] = render(content_of(room / "accident.mustache.svg"), {}, accident_json());
  const std::string html =
      render(content_of(room / "index.mustache.html"),
             {{"claims_part", content_of(room / "claims.mustache.html")}}, shown);
  FileTransaction files;
  files.write(out / "index.html", html);
  files.commit();
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  return rotor::run_program("report-page", rotor::main, argc, argv);
}
