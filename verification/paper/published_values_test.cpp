/// The numbers that the paper's text states.
#include "verification/paper/published_values.hpp"

#include <gtest/gtest.h>

#include <set>

namespace rotor {
namespace {

const std::vector<PublishedValue>& values() {
  static const auto all = published_values(ROTOR_REFERENCE_DATA "/published-values.csv");
  return all;
}

TEST(PublishedValues, AreAllComputed) {
  std::set<std::string> rows;
  for (const PublishedValue& value : values()) {
    EXPECT_TRUE(rows.insert(value.id).second) << value.id << " stands twice";
    EXPECT_TRUE(value.kind == "arithmetic" || value.kind == "simulated") << value.id;
  }
  for (const std::string& id : computed_ids()) EXPECT_TRUE(rows.contains(id)) << id;
}

TEST(PublishedValues, HaveTheVerdictsThatTheTableStates) {
  for (const PublishedValue& value : values())
    EXPECT_EQ(value.verdict, value.expected_verdict)
        << value.id << ": " << value.computed << " against " << value.printed;
}

TEST(PublishedValues, ThatAreNotReproducedHaveAReason) {
  for (const PublishedValue& value : values())
    EXPECT_EQ(value.reason.empty(), value.verdict == "reproduced") << value.id;
}

TEST(PublishedValues, ThatAreRefutedAreSoByATestThatExists) {
  std::set<std::string> tests;
  const auto& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i)
    for (int k = 0; k < all.GetTestSuite(i)->total_test_count(); ++k)
      tests.insert(std::string(all.GetTestSuite(i)->name()) + '.' +
                   all.GetTestSuite(i)->GetTestInfo(k)->name());
  for (const PublishedValue& value : values())
    EXPECT_TRUE(value.refuted_by.empty() || tests.contains(value.refuted_by)) << value.refuted_by;
}

TEST(PublishedValues, RefuseATableThatIsNotThere) {
  EXPECT_THROW(published_values("/nowhere/table.csv"), std::runtime_error);
}

}  // namespace
}  // namespace rotor
