/// `prove`: what is certain about a run from the steady response or from rest, as rows of
/// reference-data/proven.csv. Options have the names of those of `rotor run`.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <ctime>

#include "verification/proof/rotor.hpp"

int main(int argc, char** argv) {
  using proof::Ball;
  CLI::App app("Proves what happens to the rotor, by ball arithmetic.", "prove");
  proof::Case of;
  for (const proof::PrintedInput& input : proof::printed_inputs)
    app.add_option_function<std::string>(
        "--" + input.name,
        [&of, &input](const std::string& value) { of.inputs[input.name] = value; },
        "instead of " + input.value);
  std::string equations = "published";
  app.add_option("--equations", equations)->check(CLI::IsMember({"published", "consistent"}));
  app.add_option("--until", of.until, "end of the run, s");
  app.add_option("--bits", Ball::bits, "precision")->check(CLI::Range(32, 10000));
  app.add_option("--rounding", of.rounding,
                 "width of all inputs: the share of their printed digits' rounding");
  CLI11_PARSE(app, argc, argv);
  of.jump_twice = of.whole_gravity_moment = equations == "published";

  std::string command = "build/prove";
  for (int i = 1; i < argc; ++i) command += std::string(" ") + argv[i];
  try {
    const proof::Findings found = prove(of);
    const double cpu_s = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    for (const auto& [quantity, value] : found) {
      const auto [lower, upper] = value.decimal_ends(17);
      std::printf("%s,%s,%s,%ld,%.2g,%s\n", quantity.c_str(), lower.c_str(), upper.c_str(),
                  Ball::bits, cpu_s, command.c_str());
    }
    return 0;
  } catch (const proof::Undecided& what) {
    std::fprintf(stderr, "prove: undecided at %ld bits: %s\n", Ball::bits, what.what());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "prove: %s\n", error.what());
  }
  return 1;
}
