/// second-moment NEWTON_METRES [QUANTITY=NUMBER ...]: a run with a second constant moment.
#include "verification/numerics/second_moment.hpp"

#include <fmt/format.h>

#include "verification/numerics/whole_report.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

int run_with_second_moment(const Arguments& arguments) {
  SecondMoment::of_program = std::stod(arguments.at(0));
  std::map<std::string, double, std::less<>> numbers;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::size_t equals = arguments[i].find('=');
    numbers[arguments[i].substr(0, equals)] = std::stod(arguments[i].substr(equals + 1));
  }
  fmt::print("{}", whole_report(numbers));
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  return rotor::run_program("second-moment", rotor::run_with_second_moment, argc, argv);
}
