/// `stress rotors COUNT FOLDER` and `stress steps FOLDER`.
#include "verification/robustness/stress.hpp"

#include "verification/support/program.hpp"

namespace rotor {
namespace {

int main(const Arguments& arguments) {
  if (arguments.size() == 3 && arguments[0] == "rotors")
    return stress_rotors(std::stol(arguments[1]), arguments[2]);
  if (arguments.size() == 2 && arguments[0] == "steps") return stress_steps(arguments[1]);
  throw std::runtime_error("needs: rotors COUNT FOLDER, or: steps FOLDER");
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("stress", rotor::main, argc, argv); }
