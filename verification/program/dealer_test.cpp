/// The points of a sweep, dealt out to workers.
#include "figures/sweep/dealer.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace rotor {
namespace {

TEST(Dealer, PassesRowsOnInOrderAndWaitsForSlowOnes) {
  std::string seen;
  long most = 0;
  std::atomic<long> worked = 0;
  Dealer dealer(0, 40000, [&](std::string_view rows, long until) {
    seen += rows;
    EXPECT_EQ(std::count(rows.begin(), rows.end(), ' '), until - most);
    most = until;
  });
  std::string expected;
  for (long n = 0; n < 40000; ++n) expected += fmt::format("{} ", n);
  long worked_while_slow = 0;
  const auto make = [&]() -> Work {
    return [&](long n) {
      if (n == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        worked_while_slow = worked;
      }
      ++worked;
      return fmt::format("{} ", n);
    };
  };
  work(dealer, 3, make, [] {});
  EXPECT_TRUE(seen == expected);
  EXPECT_EQ(most, 40000);
  EXPECT_GT(worked_while_slow, 1000);   // the others did not wait,
  EXPECT_LT(worked_while_slow, 20000);  // but not without bound either
}

// As long as something is left to be dealt out, those who find nothing due have to wait.
TEST(Dealer, KnowsWhenNothingIsLeftToBeDealtOut) {
  Dealer dealer(0, 8, [](std::string_view, long) {});
  EXPECT_FALSE(dealer.is_dealt_out());
  const auto first = dealer.next();
  EXPECT_FALSE(dealer.is_dealt_out());
  const auto last = dealer.next_if_due();
  EXPECT_TRUE(dealer.is_dealt_out());
  EXPECT_FALSE(dealer.is_finished());
  dealer.take(last.value(), "b");
  dealer.take(first.value(), "a");
  EXPECT_TRUE(dealer.is_finished());

  Dealer stopped(0, 8, [](std::string_view, long) {});
  stopped.stop(nullptr);
  EXPECT_FALSE(stopped.is_dealt_out());
  stopped.stop(std::make_exception_ptr(std::runtime_error("enough")));
  EXPECT_TRUE(stopped.is_dealt_out());
}

TEST(Dealer, EndsWithWhatTheWorkThrows) {
  Dealer dealer(0, 1000, [](std::string_view, long) {});
  const auto make = []() -> Work {
    return [](long n) -> std::string { return n == 500 ? throw std::runtime_error("at 500") : ""; };
  };
  EXPECT_THROW(work(dealer, 2, make, [] {}), std::runtime_error);
}

// What fails next may have failed because of it.
TEST(Dealer, TellsWhatFailedFirst) {
  Dealer dealer(0, 8, [](std::string_view, long) {});
  for (const char* reason : {"first", "second"})
    dealer.stop(std::make_exception_ptr(std::runtime_error(reason)));
  try {
    work(
        dealer, 1, []() -> Work { return [](long) { return ""; }; }, [] {});
    FAIL() << "it went on";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "first");
  }
}

}  // namespace
}  // namespace rotor
