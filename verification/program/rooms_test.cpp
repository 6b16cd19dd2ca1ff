/// Which folders may include which.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace rotor {
namespace {

namespace fs = std::filesystem;

/// From the bottom up: a folder may include itself and folders of the floors below it.
const std::vector<std::vector<std::string>> floors = {
    {"model/mechanics", "model/integration", "figures/data"},
    {"model/phases", "model/theory"},
    {"model/scenario"},
    {"model/methods", "model/results"},
    {"model/run"},
    {"model/digits"},
    {"figures/input", "figures/record"},
    {"figures/runs"},
    {"figures/results"},
    {"figures/sweep"},
    {"figures/maps", "figures/program", "verification/support"},
    {"verification/approved", "verification/benchmark", "verification/equations",
     "verification/numerics", "verification/paper", "verification/program",
     "verification/robustness", "verification/validation"},
    {"verification/report"},
};

/// -1 for an unknown folder.
long floor_of(const std::string& room) {
  const auto found = std::ranges::find_if(
      floors, [&](const auto& rooms) { return std::ranges::find(rooms, room) != rooms.end(); });
  return found == floors.end() ? -1 : found - floors.begin();
}

bool may_include(const std::string& room, const std::string& other) {
  if (room == other) return true;
  if (room == "verification/proof") return false;  // shares nothing with the model
  const bool is_report = room == "verification/report";
  if (other.starts_with("verification/") && other != "verification/support")
    return is_report && other == "verification/paper";
  return floor_of(other) < floor_of(room) &&
         !(room.starts_with("model/") && other.starts_with("figures/"));
}

/// The first two folders of a path.
std::string room_of(const std::string& path) {
  return path.substr(0, path.find('/', path.find('/') + 1));
}

/// The files of ours that a file includes itself.
std::vector<std::string> includes_of(const fs::path& file) {
  std::vector<std::string> all;
  std::ifstream stream(file);
  const std::string include = "#include \"";
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with(include))
      all.push_back(line.substr(include.size(), line.rfind('"') - include.size()));
  return all;
}

TEST(Rooms, IncludeOnlyWhatTheyMay) {
  const fs::path root = ROTOR_SOURCES;
  int files = 0;
  for (const char* house : {"model", "figures", "verification"})
    for (const auto& entry : fs::recursive_directory_iterator(root / house)) {
      const std::string ending = entry.path().extension();
      if (ending != ".hpp" && ending != ".cpp" && ending != ".ipp") continue;
      ++files;
      const std::string path = fs::relative(entry.path(), root), room = room_of(path);
      EXPECT_TRUE(floor_of(room) >= 0 || room == "verification/proof")
          << path << " is in an unknown folder";
      for (const std::string& included : includes_of(entry.path())) {
        const std::string other = room_of(included);
        if (floor_of(other) < 0 && other != "verification/proof") continue;  // next to the file
        EXPECT_TRUE(may_include(room, other)) << path << ": " << included;
      }
    }
  EXPECT_GT(files, 80);
}

// An edit of the integrator, or of a phase, then compiles few sources again.
TEST(Rooms, OfFiguresDoNotParseTheIntegrator) {
  const fs::path root = ROTOR_SOURCES;
  std::set<std::string> parsed;
  const std::function<void(const fs::path&)> parse = [&](const fs::path& file) {
    for (const std::string& included : includes_of(file))
      if (parsed.insert(included).second) parse(root / included);
  };
  for (const auto& entry : fs::recursive_directory_iterator(root / "figures")) parse(entry.path());
  EXPECT_TRUE(parsed.contains("model/phases/event.hpp"));
  for (const std::string& file : parsed)
    EXPECT_FALSE(file.starts_with("model/integration/") || file.starts_with("model/methods/"))
        << file;
}

}  // namespace
}  // namespace rotor
