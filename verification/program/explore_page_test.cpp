/// What the explorer's page says of the program, in its own files.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>

#include "figures/explore/explorer.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const fs::path page = fs::path(ROTOR_SOURCES) / "figures/explore";

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<CsvRow> printed_inputs() {
  return read_csv(fs::path(ROTOR_REFERENCE_DATA) / "printed-inputs.csv");
}

TEST(ExplorePage, ReadsNothingOfARunThatThereIsNot) {
  Observer unconcerned;
  const Picture picture = Explorer(printed_inputs()).run({{"friction", "0.2"}}, unconcerned);
  const Json& summary = picture.told["summary"];
  std::set<std::string> columns;
  for (const auto& name : picture.told["motion"]) columns.insert(name);
  for (const auto& entry : fs::directory_iterator(page / "page")) {
    const std::string script = text_of(entry.path());
    const auto each = [&](const char* pattern, const auto& look) {
      const std::regex regex(pattern);
      for (std::sregex_iterator found(script.begin(), script.end(), regex), end; found != end;
           ++found)
        look((*found)[1].str());
    };
    each(R"(\bmotion\.(?!js)(\w+))", [&](const std::string& name) {
      EXPECT_TRUE(columns.contains(name)) << entry.path() << ": " << name;
    });
    each(R"(\b(?:summary|s)\.(\w+_\w+))", [&](const std::string& name) {
      EXPECT_TRUE(summary.contains(name)) << entry.path() << ": " << name;
    });
  }
}

}  // namespace
}  // namespace rotor
