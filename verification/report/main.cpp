/// Writes the reviewer's page and the document behind it:
///   report-page SOURCES BUILD OUT COMMIT DATE this-machine|archive
/// OUT holds what stands beside the page; index.html, report.json and machine.json come to it.
#include "figures/data/files.hpp"
#include "verification/report/page.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

int main(const Arguments& arguments) {
  if (arguments.size() != 6 || (arguments[5] != "this-machine" && arguments[5] != "archive"))
    throw std::runtime_error(
        "needs the folders of the sources, of what was built and of the page, the commit and its "
        "date, and this-machine or archive");
  const std::filesystem::path root = arguments[0], out = arguments[2],
                              room = root / "verification/report";
  Json page = document({.texts = room / "texts.json",
                        .scenes = root / "figures/paper",
                        .reference_data = root / "reference-data",
                        .report = out,
                        .tests = std::filesystem::path(arguments[1]) / "report",
                        .commit = arguments[3],
                        .commit_date = arguments[4],
                        .of_this_machine = arguments[5] == "this-machine"});
  page["style"] = content_of(room / "page.css");
  page["script"] = content_of(room / "page.js");
  Partials partials;
  for (const char* name : {"claims_table", "data_table"})
    partials[name] = content_of(room / (std::string(name) + ".mustache.html"));
  const std::string html = render(content_of(room / "index.mustache.html"), partials, page);
  for (const char* key : {"style", "script"}) page.erase(key);
  for (Json& figure : page["figures"])
    for (Json& picture : figure["pictures"]) picture.erase("svg");  // which stand beside it
  page["accident"].erase("frames_text");
  FileTransaction files;
  files.write(out / "accident.svg",
              render(content_of(room / "accident.mustache.svg"), {}, page["accident"]));
  files.write(out / "index.html", html);
  files.write(out / "report.json", page.dump(1) + '\n');
  files.write(out / "machine.json", machine_json().dump(1) + '\n');
  files.commit();
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  return rotor::run_program("report-page", rotor::main, argc, argv);
}
