/// `prove`: what is certain of a run from the steady response or from rest, as rows of
/// reference-data/proven.csv. Options are called as those of `rotor run`.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <ctime>

#include "verification/proof/rotor.hpp"

namespace {

using proof::Ball;

struct Output {
  std::string command;
  std::string cpu_s() const {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2g",
                  static_cast<double>(std::clock()) / CLOCKS_PER_SEC);
    return text.data();
  }
  void row(const std::string& quantity, const Ball& value) const {
    const auto [lower, upper] = proof::decimal_ends(value, 17);
    text(quantity, lower, upper);
  }
  void row(const std::string& quantity, long count) const {
    text(quantity, std::to_string(count), std::to_string(count));
  }

 private:
  void text(const std::string& quantity, const std::string& lower, const std::string& upper) const {
    std::printf("%s,%s,%s,%ld,%s,%s\n", quantity.c_str(), lower.c_str(), upper.c_str(), Ball::bits,
                cpu_s().c_str(), command.c_str());
  }
};

void write(const proof::Findings& found, const Output& out) {
  long touch_downs = 0;
  bool rolled = false;
  for (const proof::Happening& at : found.happenings) {
    if (at.event == "touch_down")
      out.row("touch_down_" + std::to_string(++touch_downs) + "_s", at.time_s);
    if (at.event == "motor_off") out.row("motor_off_s", at.time_s);
    if (at.event == "mass_loss") out.row("speed_at_mass_loss_Hz", at.speed_Hz);
    if (at.event != "rolling_onset" || rolled) continue;
    rolled = true;
    out.row("rolling_onset_s", at.time_s);
    out.row("rolling_onset_speed_Hz", at.speed_Hz);
    out.row("rolling_onset_force_N", at.normal_force_N);
  }
  if (!found.undecided.empty()) return;
  out.row("touch_downs", touch_downs);
  if (touch_downs > 0) out.row("peak_normal_force_N", found.greatest_force_N);
  out.row("max_displacement_m", found.greatest_displacement_m);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Proves what happens to the rotor, by ball arithmetic.", "prove");
  proof::Case of;
  for (const proof::PrintedInput& input : proof::printed_inputs())
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

  Output out{"build/prove"};
  for (int i = 1; i < argc; ++i) out.command += std::string(" ") + argv[i];
  try {
    const proof::Findings found = prove(of);
    write(found, out);
    if (found.undecided.empty()) return 0;
    std::fprintf(stderr, "prove: cannot decide %s, after t = %.6f s, %ld steps and %s s\n",
                 found.undecided.c_str(), found.reached_s.to_double(), found.steps,
                 out.cpu_s().c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "prove: %s\n", error.what());
  }
  return 1;
}
