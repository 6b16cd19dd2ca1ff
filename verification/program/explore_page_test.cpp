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

TEST(ExplorePage, HasKnobsForNumbersThatThereAre) {
  const Json numbers = Explorer(printed_inputs()).describe_numbers();
  std::set<std::string> known;
  for (const auto& group : Json::parse(text_of(page / "knobs.json")))
    for (const auto& knob : group["knobs"]) {
      const std::string name = knob["name"];
      EXPECT_TRUE(known.insert(name).second) << name;
      if (name == "until") {
        EXPECT_EQ(knob["unstated"], "0.25 s after it");
      }
      if (knob.value("typed", false)) continue;
      const Statable* statable = find_statable(name);
      ASSERT_TRUE(statable) << name;
      const double from = knob["from"], to = knob["to"];
      EXPECT_LT(from, to) << name;
      EXPECT_TRUE(statable->quantity.allows(from) && statable->quantity.allows(to)) << name;
      EXPECT_TRUE(from > 0 || !knob.value("logarithmic", false)) << name;
      EXPECT_EQ(knob.value("instead_of", ""),
                name == "separation_speed_hz" ? "separation_time" : "");
      const auto its = std::find_if(numbers.begin(), numbers.end(),
                                    [&](const Json& number) { return number["name"] == name; });
      if (!(*its)["paper"].is_null()) {
        EXPECT_GT((*its)["paper"], from) << name;
        EXPECT_LT((*its)["paper"], to) << name;
      }
    }
  for (const char* name : {"friction", "unbalance_factor", "separation_time", "separation_speed_hz",
                           "clearance", "contact_stiffness", "contact_damping", "support_stiffness",
                           "support_damping", "eccentricity", "torque", "from", "until"})
    EXPECT_TRUE(known.contains(name)) << name;
}

TEST(ExplorePage, HasWordsForEachOutcomeAndEvent) {
  const std::string words = text_of(page / "page/outcome.js");
  const Json schema = Json::parse(text_of(page / "../program/summary.schema.json"));
  for (const auto& outcome : schema["properties"]["outcome"]["enum"])
    EXPECT_NE(words.find(fmt::format("  {}: \"", outcome.get<std::string>())), std::string::npos)
        << outcome;
  for (const Event event : {Event::mass_loss, Event::touch_down, Event::release, Event::ring_clear,
                            Event::renewed_contact, Event::rolling_onset, Event::slip_reversal,
                            Event::break_away, Event::motor_off})
    EXPECT_NE(words.find(fmt::format(" {}: \"", name_of(event))), std::string::npos)
        << name_of(event);
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
