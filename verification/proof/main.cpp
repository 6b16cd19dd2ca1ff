/// `prove`: what is certain about a run from the steady response or from rest, as rows of
/// reference-data/proven.csv. Options have the names of those of `rotor run`.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <ctime>

#include "verification/proof/rotor.hpp"

int main(int argc, char** argv) {
  CLI::App app("Proves what happens to the rotor, by ball arithmetic.", "prove");
  proof::Case of;
  for (auto& [name, input] : of.inputs)
    app.add_option("--" + name, input.value, "instead of " + input.value);
  std::string equations = "published";
  app.add_option("--equations", equations)->check(CLI::IsMember({"published", "corrected"}));
  app.add_option("--bits", proof::Ball::bits, "precision")->check(CLI::Range(32, 10000));
  app.add_option("--rounding", of.rounding,
                 "width of all inputs: the share of their printed digits' rounding");
  CLI11_PARSE(app, argc, argv);
  of.published = equations == "published";

  std::string command = "build/prove";
  for (int i = 1; i < argc; ++i) command += std::string(" ") + argv[i];
  try {
    const proof::Findings found = prove(of);
    const double cpu_s = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    mpfr_t lower, upper;
    mpfr_inits2(proof::Ball::bits, lower, upper, nullptr);
    for (const auto& [quantity, value] : found) {
      arb_get_interval_mpfr(lower, upper, value.get());
      mpfr_printf(arb_is_int(value.get()) != 0 ? "%s,%.0RDf,%.0RUf" : "%s,%.16RDe,%.16RUe",
                  quantity.c_str(), lower, upper);
      std::printf(",%ld,%.3g,%s\n", proof::Ball::bits, cpu_s, command.c_str());
    }
    mpfr_clears(lower, upper, nullptr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "prove: %s\n", error.what());
    return 1;
  }
}
