/// `random-digits COUNT SEED`: random runs to 3, 6, 9 and 12 digits, against a finer tolerance in
/// quadruple precision. Prints how many of them have their digits, and each falsehood.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "figures/sweep/compute_in_order.hpp"
#include "verification/support/digits_judge.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

int main(const Arguments& arguments) {
  if (arguments.size() != 2) throw std::runtime_error("needs: COUNT SEED");
  const long count = std::stol(arguments[0]);
  RandomRuns runs = judged_runs(static_cast<unsigned>(std::stoul(arguments[1])));
  std::vector<Scenario> scenarios;
  for (long n = 0; n < count; ++n) scenarios.push_back(runs.scenario());

  std::string given;  // a letter for each run and number of digits
  const auto take = [&](const std::string& letters) {
    given += letters;
    fmt::print(stderr, "\r{} of {} runs", given.size() / judged_digits.size(), count);
  };
  std::atomic<long> falsehoods = 0;
  const auto worker = [&]() -> Work {
    return [&](long n) {
      std::string letters;
      for (const JudgedDigits& verdict : judge(scenarios[static_cast<std::size_t>(n)])) {
        letters += verdict.given;
        if (verdict.falsehood.empty()) continue;
        ++falsehoods;
        fmt::print("run {}: FALSE: {}\n", n, verdict.falsehood);
        std::fflush(stdout);
      }
      return letters;
    };
  };
  compute_in_order(0, count, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())),
                   worker, take);
  fmt::print(stderr, "\n");
  fmt::print("{} random runs of seed {}, {} of whose digits are false:\n", count, arguments[1],
             falsehoods.load());
  for (std::size_t k = 0; k < judged_digits.size(); ++k) {
    const auto of = [&](char letter) {
      long all = 0;
      for (std::size_t i = k; i < given.size(); i += judged_digits.size())
        all += given[i] == letter;
      return all;
    };
    fmt::print("{} digits: {} in double precision, {} in quadruple precision, {} not given\n",
               judged_digits[k], of('d'), of('q'), of('-'));
  }
  return falsehoods > 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  return rotor::run_program("random-digits", rotor::main, argc, argv);
}
