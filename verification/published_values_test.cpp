/// The numbers that the paper's text states.
#include "verification/published_values.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace rotor {
namespace {

const std::vector<PublishedValue>& values() {
  static const auto all = published_values(ROTOR_REFERENCE_DATA "/published-values.csv");
  return all;
}

TEST(PublishedValues, AreAllComputedOrExcused) {
  std::set<std::string> rows;
  for (const PublishedValue& value : values()) {
    EXPECT_TRUE(rows.insert(value.id).second) << value.id << " stands twice";
    EXPECT_EQ(value.computed.has_value(), value.expected_verdict != "excused") << value.id;
  }
  for (const std::string& id : computed_ids()) EXPECT_TRUE(rows.contains(id)) << id;
}

TEST(PublishedValues, HaveTheVerdictsThatTheTableStates) {
  for (const PublishedValue& value : values())
    EXPECT_EQ(value.verdict, value.expected_verdict)
        << value.id << ": " << value.computed.value_or(0) << " against " << value.printed;
}

TEST(PublishedValues, ThatAreNotReproducedHaveAReason) {
  for (const PublishedValue& value : values())
    EXPECT_EQ(value.reason.empty(), value.verdict == "reproduced") << value.id;
}

TEST(PublishedValues, RefuseATableThatIsNotThere) {
  EXPECT_THROW(published_values("/nowhere/table.csv"), std::runtime_error);
}

}  // namespace
}  // namespace rotor
