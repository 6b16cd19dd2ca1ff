/// Files that state no sweep, and what is said of them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "figures/sweep/sweep.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

class SweepFile : public CommandLine {
 protected:
  std::string refusal(const std::string& text) const {
    write("s.toml", text);
    try {
      read_sweep(folder_ / "s.toml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

// All corners are looked at, of which there are as many as two to the power of what varies.
TEST_F(SweepFile, VariesTwelveQuantitiesAtMost) {
  std::string text = "[sample]\ncount = 3\n";
  int varied = 0;
  for (const char* quantity : {"mass", "inertia", "eccentricity", "support_stiffness",
                               "support_damping", "gravity", "torque", "contact_stiffness",
                               "contact_damping", "friction", "clearance", "separation_time"}) {
    text += fmt::format("[[sample.over]]\nquantity = \"{}\"\nnormal = [{}, 1e-9]\n", quantity,
                        1e-3 * ++varied);
  }
  EXPECT_EQ(refusal(text).find("quantities vary"), std::string::npos) << refusal(text);
  text += "[[sample.over]]\nquantity = \"tolerance\"\nuniform = [1e-9, 2e-9]\n";
  EXPECT_NE(refusal(text).find("more than 12 quantities vary"), std::string::npos) << refusal(text);
}

// What is drawn without ends is looked at beforehand where most of it lies.
TEST_F(SweepFile, MayDrawFromANormalDistributionWhatItsDefaultWouldContradict) {
  const std::string drawn =
      "[parameters]\nstator_radius = 0.05\n[sample]\ncount = 3\n[[sample.over]]\n"
      "quantity = \"rotor_radius\"\nnormal = ";
  write("s.toml", drawn + "[0.049, 1e-5]\n");
  EXPECT_EQ(rotor("sweep s.toml --dry-run").status, 0);
  EXPECT_NE(refusal(drawn + "[0.051, 1e-5]\n").find("corner: rotor_radius = 0.051"),
            std::string::npos);
}

// The other correction still varies with the equations.
TEST_F(SweepFile, MayStateOneCorrectionBesideTheEquations) {
  write("s.toml",
        "[parameters]\nvelocity_jump = \"once\"\n[[axis]]\nquantity = \"equations\"\n"
        "values = [\"published\", \"consistent\"]\n");
  EXPECT_EQ(rotor("sweep s.toml --dry-run").status, 0);
}

}  // namespace
}  // namespace rotor
