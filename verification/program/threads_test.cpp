/// The threads of a sweep, in this process: `make races` runs these tests under ThreadSanitizer.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "figures/program/commands.hpp"
#include "figures/sweep/compute_in_order.hpp"

namespace rotor {
namespace {

// Although the first one is slow, for which not all others wait.
TEST(ComputeInOrder, PassesEachRowOnOnce) {
  long passed = 0;
  std::atomic<long> computed = 0;
  long computed_while_slow = 0;
  const auto make = [&]() -> Work {
    return [&](long n) {
      if (n == 10) {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        computed_while_slow = computed;
      }
      ++computed;
      return fmt::format("{}", n);
    };
  };
  compute_in_order(10, 40000, 3, make, [&](const std::string& row) {
    EXPECT_EQ(row, fmt::format("{}", 10 + passed++));
  });
  EXPECT_EQ(passed, 40000 - 10);
  EXPECT_GT(computed_while_slow, 1000);
  EXPECT_LT(computed_while_slow, 20000);  // memory is bounded
}

// The other threads take no more work.
TEST(ComputeInOrder, EndsWithWhatTheWorkThrows) {
  long passed = 0;
  std::atomic<long> computed = 0;
  const auto make = [&]() -> Work {
    return [&](long n) -> std::string {
      if (n == 500) throw std::runtime_error("at 500");
      if (n > 500) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ++computed;
      return "";
    };
  };
  EXPECT_THROW(compute_in_order(0, 3000, 2, make, [&](const std::string&) { ++passed; }),
               std::runtime_error);
  EXPECT_LE(passed, 500);
  EXPECT_LT(computed, 2999);  // not all the others
}

// With run-ups to a speed, refusals and both methods.
TEST(ThreadsOfASweep, WriteTheBytesOfOne) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / fmt::format("rotor-threads-{}", ::getpid());
  fs::create_directory(folder);
  const fs::path file = folder / "s.toml";
  std::ofstream(file) << R"(
[parameters]
tolerance = 1e-6
step_run_up = 1e-3
[[axis]]
quantity = "method"
values = ["event", "rk4"]
[[axis]]
quantity = "friction"
values = [0.3, 0.08]
[sample]
count = 8
[[sample.over]]
quantity = "mass_loss_speed_Hz"
normal = [130, 30]
)";
  const auto results = [&](int jobs) {
    SweepOptions options;
    options.file = file;
    options.out = folder / fmt::format("{}.csv", jobs);
    options.jobs = jobs;
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    run_sweep(options);
    testing::internal::GetCapturedStdout();
    testing::internal::GetCapturedStderr();
    std::ifstream stream(options.out);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  const std::string of_one = results(1);
  EXPECT_NE(of_one.find("is not reached"), std::string::npos);
  EXPECT_NE(of_one.find(",rolling,"), std::string::npos);
  for (const int jobs : {2, 8}) EXPECT_TRUE(results(jobs) == of_one) << jobs;
  fs::remove_all(folder);
}

}  // namespace
}  // namespace rotor
