/// Prints what the model makes of every published number, and writes it: `report TABLE OUT`.
#include <fmt/format.h>

#include "figures/csv.hpp"
#include "verification/published_values.hpp"

namespace rotor {
namespace {

int main(const std::filesystem::path& table, const std::filesystem::path& out) {
  const auto values = published_values(table);
  bool as_expected = true;
  for (const std::string verdict : {"reproduced", "close", "differs", "excused"}) {
    const auto of_it = [&](const PublishedValue& value) { return value.verdict == verdict; };
    fmt::print("\nPublished numbers {}: {}\n", verdict, std::ranges::count_if(values, of_it));
    for (const PublishedValue& value : values) {
      if (!of_it(value)) continue;
      as_expected = as_expected && value.verdict == value.expected_verdict;
      fmt::print("  {:<52} {:>9} {:<7} {:>10}  {}\n", value.quantity, value.printed, value.unit,
                 value.computed ? fmt::format("{:.5g}", *value.computed) : "", value.reason);
    }
  }
  FileTransaction files;
  files.write(out, to_csv(values));
  files.commit();
  return as_expected ? 0 : 1;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  try {
    if (argc != 3)
      throw std::runtime_error("needs the table of published values and an output file");
    return rotor::main(argv[1], argv[2]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "report: {}\n", error.what());
    return 1;
  }
}
