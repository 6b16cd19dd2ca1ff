/// How many runs a sweep does in a second, on one core and on more.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>

#include "figures/sweep/block_scheduler.hpp"
#include "figures/sweep/sweep_row.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

/// As a sweep file in a temporary folder has it.
Sweep sweep_of(const std::string& text) {
  const auto file = std::filesystem::temp_directory_path() / fmt::format("rates-{}.toml", getpid());
  std::ofstream(file) << text;
  Sweep sweep = read_sweep(file);
  std::filesystem::remove(file);
  return sweep;
}

/// Points a second, the best of several tries: what disturbs can but slow them down.
double rate(long points, int threads, const std::function<Work()>& make_worker) {
  double best_s = 1e9;
  for (int n = 0; n < 3; ++n) {
    const auto start = std::chrono::steady_clock::now();
    BlockScheduler scheduler(0, points, [](std::string_view, long) {});
    work(scheduler, threads, make_worker, [] {});
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    best_s = std::min(best_s, elapsed.count());
  }
  return static_cast<double>(points) / best_s;
}

double rate(const Sweep& sweep, int threads = 1) {
  return rate(sweep.points(), threads, [&sweep]() -> Work {
    return [row = std::make_shared<SweepRows>(sweep)](long n) { return (*row)(n); };
  });
}

int main(const Arguments& /*arguments*/) {
  const std::string rubs =
      "[parameters]\ntolerance = 1e-7\nuntil = 29.2\n[sample]\ncount = 1500\n[[sample.over]]\n"
      "quantity = \"unbalance_factor\"\nuniform = [2.9, 3.1]\n";
  const std::string own_run_ups =
      "[parameters]\ntolerance = 1e-7\nuntil = 29.2\n[sample]\ncount = 500\n[[sample.over]]\n"
      "quantity = \"eccentricity\"\nuniform = [1.4e-4, 1.6e-4]\n";
  const Sweep to_the_end = sweep_of("stop_on = \"end\"\n" + rubs), to_outcome = sweep_of(rubs);
  const double whole = rate(to_the_end), stopped = rate(to_outcome);
  fmt::print("Runs in a second, tolerance 1e-7, mu = 0.3, until 0.1 s after the mass loss\n");
  fmt::print("{:<52} {:>8.0f}\n", "run-up shared, one core", whole);
  fmt::print("{:<52} {:>8.0f}  {:.2f} times\n", "the same, stopped at the outcome", stopped,
             stopped / whole);
  fmt::print("{:<52} {:>8.0f}\n", "a run-up each, stopped at the outcome",
             rate(sweep_of(own_run_ups)));
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  for (const int threads : {2, 4}) {
    const double faster = rate(to_outcome, threads);
    const int busy = std::min(threads, cores);
    fmt::print("{:<52} {:>8.0f}  {:.0f} % of {} cores\n", fmt::format("{} threads", threads),
               faster, 100 * faster / stopped / busy, busy);
  }
  const auto empty = []() -> Work { return [](long) { return std::string(600, '0'); }; };
  fmt::print("{:<52} {:>8.0f}  {:.2g} us a point\n", "dealing and collecting alone, 2 threads",
             rate(1'000'000, 2, empty), 1e6 / rate(1'000'000, 2, empty));
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  return rotor::run_program("sweep-costs", rotor::main, argc, argv);
}
