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
                              "model/simulation"};
  static const auto with = [](Names names, const Names& more) {
    names.insert(more.begin(), more.end());
    return names;
  };
  static const Names scenes = with(model, {"figures/data", "figures/scenes"});
  static const Names of_verification =
      with(scenes, {"figures/explore", "figures/sweep", "model/theory", "verification/support"});
  static const std::map<std::string, Names> rooms = {
      {"model/mechanics", {}},
      {"model/integration", {}},
      {"model/phases", {"model/mechanics", "model/integration"}},
      {"model/simulation", {"model/mechanics", "model/integration", "model/phases"}},
      {"model/theory", {"model/mechanics"}},
      {"figures/data", {}},
      {"figures/scenes", with(model, {"figures/data"})},
      {"figures/sweep", scenes},
      {"figures/explore", with(scenes, {"figures/sweep"})},
      {"figures/maps", with(scenes, {"figures/sweep", "model/theory"})},
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

/// What only those files may include that have to.
const std::map<std::string, Names>& heavy() {
  static const std::map<std::string, Names> all = {
      {"CLI/CLI.hpp", {"figures/program/main.cpp", "verification/proof/main.cpp"}},
      {"toml++/toml.h", {"figures/scenes/toml_file.hpp"}},
      {"rapidcheck/gtest.h", {"verification/equations/friction_test.cpp"}},
  };
  return all;
}

struct SourceFile {
  std::string path, room;
  std::vector<std::string> includes;
  long lines = 0;
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
        for (std::string line; std::getline(stream, line); ++file.lines)
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

TEST(Rooms, HaveNoCircleOfIncludes) {
  std::map<std::string, Names> open;  // what each header still waits for
  for (const SourceFile& file : sources())
    for (const std::string& include : file.includes)
      if (allowed().contains(room_of(include))) open[file.path].insert(include);
  for (bool found = true; found;) {
    found = false;
    for (auto file = open.begin(); file != open.end();) {
      std::erase_if(file->second, [&](const auto& include) { return !open.contains(include); });
      found = found || file->second.empty();
      file = file->second.empty() ? open.erase(file) : std::next(file);
    }
  }
  for (const auto& [file, includes] : open) ADD_FAILURE() << file << " includes itself in the end";
}

TEST(Rooms, KeepHeavyHeadersOutOfOtherFiles) {
  for (const SourceFile& file : sources())
    for (const auto& [header, users] : heavy())
      if (std::ranges::find(file.includes, header) != file.includes.end()) {
        EXPECT_TRUE(users.contains(file.path)) << file.path << " includes " << header;
      }
}

TEST(Rooms, HaveNoFileThatOneCannotReadAtASitting) {
  const Names tables = {"verification/paper/readings.cpp"};
  for (const SourceFile& file : sources()) {
    if (!tables.contains(file.path)) {
      EXPECT_LE(file.lines, 320) << file.path;
    }
  }
}

}  // namespace
}  // namespace rotor
