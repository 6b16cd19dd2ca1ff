/// For programs that are not linked with the other sources of this folder.
#include "model/digits/digits.hpp"

namespace rotor {
RunToDigits* const run_to_digits = nullptr;
}  // namespace rotor
