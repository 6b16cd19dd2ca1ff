/// The house: which rooms may include which, and that no file grows too large.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace rotor {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// What each room may include beside itself.
const std::map<std::string, Names>& allowed() {
  static const Names model = {"model/mechanics", "model/integration", "model/phases",
                              "model/scenario",  "model/methods",     "model/results",
                              "model/run",       "model/certified"};
  static const auto with = [](Names names, const Names& more) {
    names.insert(more.begin(), more.end());
    return names;
  };
  static const Names runs = with(model, {"figures/data", "figures/runs"});
  static const Names scenes =
      with(runs, {"model/theory", "figures/record", "figures/input", "figures/results"});
  static const Names of_verification =
      with(scenes, {"figures/explore", "figures/sweep", "verification/support"});
  static const std::map<std::string, Names> rooms = {
      {"model/mechanics", {}},
      {"model/integration", {}},
      {"model/phases", {"model/mechanics", "model/integration"}},
      {"model/scenario", {"model/mechanics", "model/phases"}},
      {"model/methods", {"model/mechanics", "model/integration", "model/phases", "model/scenario"}},
      {"model/results", {"model/mechanics", "model/scenario"}},
      {"model/run", {"model/mechanics", "model/scenario", "model/methods"}},
      {"model/certified", model},
      {"model/theory", {"model/mechanics"}},
      {"figures/data", {}},
      {"figures/runs", runs},
      {"figures/record", with(model, {"figures/data"})},
      {"figures/input", with(runs, {"figures/record"})},
      {"figures/results", scenes},
      {"figures/sweep", scenes},
      {"figures/explore", with(scenes, {"figures/sweep"})},
      {"figures/maps", with(scenes, {"figures/sweep"})},
      {"figures/program", with(scenes, {"figures/sweep"})},
      {"verification/support", scenes},
      {"verification/approved", {"verification/support"}},
      {"verification/equations", of_verification},
      {"verification/numerics", of_verification},
      {"verification/paper", of_verification},
      {"verification/program", of_verification},
      {"verification/proof", {}},
      {"verification/robustness", of_verification},
      {"verification/benchmark", of_verification},
      {"verification/report", with(of_verification, {"verification/paper"})},
  };
  return rooms;
}

struct SourceFile {
  std::string path, room;
  std::vector<std::string> includes;
};

/// All sources below the three folders.
const std::vector<SourceFile>& sources() {
  static const std::vector<SourceFile> all = [] {
    std::vector<SourceFile> found;
    const fs::path root = ROTOR_SOURCES;
    const std::string include = "#include ";
    for (const char* folder : {"model", "figures", "verification"})
      for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const std::string ending = entry.path().extension();
        if (ending != ".hpp" && ending != ".cpp" && ending != ".ipp") continue;
        const fs::path path = fs::relative(entry.path(), root);
        auto part = path.begin();
        SourceFile file{
            .path = path.string(), .room = (*part / *std::next(part)).string(), .includes = {}};
        std::ifstream stream(entry.path());
        for (std::string line; std::getline(stream, line);)
          if (line.starts_with(include)) {
            const std::size_t name = include.size() + 1;  // behind the quote
            file.includes.push_back(line.substr(name, line.find_first_of(">\"", name) - name));
          }
        found.push_back(file);
      }
    return found;
  }();
  return all;
}

std::string room_of(const std::string& include) {
  return include.substr(0, include.find('/', include.find('/') + 1));
}

TEST(Rooms, IncludeOnlyWhatTheyMay) {
  EXPECT_GT(sources().size(), 80U);
  for (const SourceFile& file : sources()) {
    ASSERT_TRUE(allowed().contains(file.room)) << file.path << " stands in no room";
    for (const std::string& include : file.includes) {
      const std::string room = room_of(include);
      if (!allowed().contains(room) || room == file.room) continue;
      EXPECT_TRUE(allowed().at(file.room).contains(room)) << file.path << " includes " << include;
    }
  }
}

}  // namespace
}  // namespace rotor
