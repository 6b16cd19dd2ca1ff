/// Which folders may include which.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>

namespace rotor {
namespace {

namespace fs = std::filesystem;

/// Each uses only those before it, as model/README.md says. No run uses theory.
constexpr std::array model = {"mechanics", "integration", "phases", "scenario", "methods",
                              "results",   "run",         "digits", "theory"};

/// Of paths from the root of the sources.
bool may_include(const std::string& path, const std::string& included) {
  const auto is_in = [](const std::string& of, const std::string& folder) {
    return of.starts_with(folder + '/');
  };
  const auto floor_of = [&](const std::string& of) {
    return std::ranges::find_if(
        model, [&](const char* room) { return is_in(of, std::string("model/") + room); });
  };
  if (is_in(path, "model")) return is_in(included, "model") && floor_of(included) <= floor_of(path);
  if (is_in(path, "figures")) return !is_in(included, "verification");
  const std::string room = path.substr(0, path.find('/', path.find('/') + 1));
  if (room == "verification/proof") return is_in(included, room);  // shares nothing with the model
  return !is_in(included, "verification") || is_in(included, room) ||
         is_in(included, "verification/support") ||
         (room == "verification/report" && is_in(included, "verification/paper"));
}

TEST(Rooms, IncludeOnlyWhatTheyMay) {
  const fs::path root = ROTOR_SOURCES;
  const std::string include = "#include \"";
  int includes = 0;
  for (const char* house : {"model", "figures", "verification"})
    for (const auto& entry : fs::recursive_directory_iterator(root / house)) {
      if (!entry.is_regular_file()) continue;
      const std::string path = fs::relative(entry.path(), root);
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);) {
        if (!line.starts_with(include) || line.find('/') == line.npos) continue;
        ++includes;
        const std::string included = line.substr(include.size(), line.rfind('"') - include.size());
        EXPECT_TRUE(may_include(path, included)) << path << ": " << included;
      }
    }
  EXPECT_GT(includes, 500);
}

}  // namespace
}  // namespace rotor
