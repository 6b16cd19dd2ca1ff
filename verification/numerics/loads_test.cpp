/// A load that is stated in one place acts wherever the program asks for loads: a second constant
/// moment beside the motor's, in a program that adds it as model/README.md says.
#include <sstream>

#include "verification/numerics/whole_report.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

class SecondMomentRun : public CommandLine {
 protected:
  std::string report(double second, const std::map<std::string, double, std::less<>>& numbers) {
    std::string command = fmt::format("'" ROTOR_BUILD "/second-moment' {}", second);
    for (const auto& [name, number] : numbers) command += fmt::format(" {}={}", name, number);
    const auto [status, output] = shell(command);
    EXPECT_EQ(status, 0) << output;
    return output;
  }

  static std::string without_energy(const std::string& report) {
    return report.substr(0, report.find("\nenergy\n"));
  }
  static double number(const std::string& report, const std::string& name) {
    const std::size_t at = report.find('\n' + name + ' ');
    EXPECT_NE(at, report.npos) << name << " in: " << report;
    return at == report.npos ? 0 : std::stod(report.substr(at + name.size() + 2));
  }
};

// Mass is lost at 100 Hz, and the rotor touches, rolls and is still driven. A brake beside a
// stronger motor, and a drive without one, are a motor of their sum, to the bit and at its cost.
TEST_F(SecondMomentRun, IsThatOfAMotorWithTheSumOfBoth) {
  for (const auto& [torque, second] : {std::pair(0.3, -0.1), {0., 0.2}}) {
    SCOPED_TRACE(second);
    const double both = torque + second;
    std::map<std::string, double, std::less<>> numbers = {
        {"torque", torque}, {"mass_loss_speed_Hz", 100}, {"until", 28.8}};
    const std::string beside = report(second, numbers);
    numbers["torque"] = both;
    const std::string alone = whole_report(numbers);
    EXPECT_EQ(without_energy(beside), without_energy(alone));
    EXPECT_GT(number(alone, "touch_downs"), 1);
    EXPECT_NEAR(number(beside, "speed_at_mass_loss_Hz"), 100, 1e-7);
    const double work = number(alone, "motor"), energy = number(alone, "kinetic");
    EXPECT_NEAR(number(beside, "motor"), work * torque / both, 1e-12 * energy);
    EXPECT_NEAR(number(beside, "second_moment"), work * second / both, 1e-12 * energy);
    EXPECT_LT(std::abs(number(beside, "residual")), 1e-9 * energy);
  }
}

// By hand for a balanced rotor, whose motor reaches 20 Hz and is switched off.
TEST_F(SecondMomentRun, GoesOnWhenTheMotorIsOff) {
  for (const double second : {-0.1, 0.1}) {
    SCOPED_TRACE(second);
    constexpr double torque = 0.3, off_Hz = 20, until_s = 8;
    const std::string balanced = report(second, {{"torque", torque},
                                                 {"motor_off_Hz", off_Hz},
                                                 {"eccentricity", 0},
                                                 {"mass_loss_time", 99},
                                                 {"until", until_s}});
    const double inertia = Parameters().inertia,
                 off_s = off_Hz * two_pi * inertia / (torque + second);
    EXPECT_NEAR(number(balanced, "motor_off_s"), off_s, 1e-12);
    EXPECT_NEAR(number(balanced, "final_speed_Hz"),
                off_Hz + second / inertia * (until_s - off_s) / two_pi, 1e-10);
    EXPECT_NEAR(number(balanced, "second_moment") / second,  // the angle turned
                two_pi * off_Hz * (until_s - off_s / 2) +
                    second / inertia * (until_s - off_s) * (until_s - off_s) / 2,
                1e-8);
  }
}

}  // namespace
}  // namespace rotor
