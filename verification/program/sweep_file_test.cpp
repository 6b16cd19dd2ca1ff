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

TEST_F(SweepFile, IsRefusedWhereItMeansNothing) {
  const auto axis = [](const std::string& lines) { return "[[axis]]\n" + lines; };
  const std::string friction = "quantity = \"friction\"\n";
  EXPECT_NE(refusal("").find("nothing varies"), std::string::npos);
  for (const auto& [text, message] : {
           std::pair(axis("quantity = \"frictoin\"\n"), "did you mean friction"),
           std::pair(axis(friction + "from = 0.3\nto = 0.1\npoints = 3\n"),
                     "to: must be greater than from = 0.3"),
           std::pair(axis(friction + "from = 0.3\nto = 0.3\npoints = 3\n"), "must be greater"),
           std::pair(axis(friction + "from = -1\nto = 0.3\npoints = 3\n"),
                     "friction must be a finite number not below 0"),
           std::pair(axis(friction + "from = 0\nto = 1\npoints = 3\nspacing = \"log\"\n"),
                     "greater than 0 for equal ratios"),
           std::pair(axis(friction + "from = 0\nto = 1\npoints = 1\n"), "must be 2 at least"),
           std::pair(axis(friction + "from = 0\nto = 1\npoints = 1000000000\n"), "600 GB"),
           std::pair(axis(friction + "values = []\n"), "something in it"),
           std::pair(axis(friction + "values = [0.1]\npoints = 2\n"), "stand instead of"),
           std::pair(axis("quantity = \"method\"\nvalues = [\"euler\"]\n"), "must be one of"),
           std::pair("[parameters]\nvelocity_jump = \"once\"\ngravity_moment = \"whole\"\n" +
                         axis("quantity = \"equations\"\nvalues = [\"published\"]\n"),
                     "equations: varies, and velocity_jump and gravity_moment are stated"),
           std::pair(axis("quantity = \"method\"\nfrom = 1\n"), "must be stated"),
           std::pair(axis(friction + "values = [0.1]\n") + axis(friction + "values = [0.2]\n"),
                     "varies, and so does friction"),
           std::pair("[parameters]\nstator_radius = 0.07\n" +
                         axis("quantity = \"clearance\"\nvalues = [1e-3]\n"),
                     "clearance: varies, and [parameters] states stator_radius"),
           std::pair("[parameters]\nmethod = \"rk4\"\n" +
                         axis("quantity = \"method\"\nvalues = [\"event\"]\n"),
                     "method: varies, and [parameters] states it"),
           std::pair(axis("quantity = \"rotor_radius\"\nfrom = 0.05\nto = 0.07\npoints = 2\n"),
                     "corner: rotor_radius = 0.07: stator_radius"),
           std::pair(axis("quantity = \"rotor_radius\"\nvalues = [0.07, 0.05]\n"),
                     "corner: rotor_radius = 0.07: stator_radius"),
           std::pair(axis("quantity = \"stator_radius\"\nfrom = 0.05\nto = 0.07\npoints = 2\n"),
                     "corner: stator_radius = 0.05: stator_radius"),
           std::pair(std::string("[sample]\ncount = 3\n[[sample.over]]\nquantity = "
                                 "\"stator_radius\"\nuniform = [0.05, 0.07]\n"),
                     "corner: stator_radius = 0.05: stator_radius"),
           std::pair(std::string("[sample]\ncount = 3\nsed = 1\n[[sample.over]]\n"
                                 "quantity = \"friction\"\nuniform = [0.1, 0.2]\n"),
                     "sed: unknown key; did you mean seed?"),
           std::pair(std::string("[sample]\ncount = 3\n[[sample.over]]\nquantity = \"friction\"\n"
                                 "normal = [0.2, 0]\n"),
                     "the deviation must be greater than 0"),
           std::pair(std::string("[sample]\ncount = 3\n[[sample.over]]\nquantity = \"friction\"\n"
                                 "uniform = [0.1, 0.2]\nnormal_ = [0.2, 1]\n"),
                     "normal_: unknown key; did you mean normal?"),
           std::pair(std::string("[sample]\ncount = 3\n"), "needs a [[sample.over]]"),
           std::pair(std::string("[sample]\ncount = 3\n[[sample.over]]\nquantity = \"friction\"\n"),
                     "needs one of"),
           std::pair(std::string("[sample]\ncount = 3\n[[sample.over]]\nquantity = \"friction\"\n"
                                 "uniform = [0.2, 0.1]\n"),
                     "must go from a number to a greater one"),
           std::pair(std::string("stop_on = \"lunch\"\n") + axis(friction + "values = [0.1]\n"),
                     "or \"end\""),
           std::pair(std::string("columns = [\"outcom\"]\n") + axis(friction + "values = [0.1]\n"),
                     "there is no result \"outcom\"; did you mean outcome?"),
           std::pair("columns = [\"outcome\", \"outcome\"]\n" + axis(friction + "values = [0.1]\n"),
                     "\"outcome\" stands twice"),
           std::pair("columns = []\n" + axis(friction + "values = [0.1]\n"), "something in it"),
           std::pair("columns = \"outcome\"\n" + axis(friction + "values = [0.1]\n"),
                     "must be a list"),
           std::pair("[parameters]\ndigits = 6\n" + axis(friction + "values = [0.1]\n"),
                     "needs stop_on = \"end\""),
           std::pair("stop_on = \"end\"\n[parameters]\ndigits = 6\nmethod = \"rk4\"\n" +
                         axis(friction + "values = [0.1]\n"),
                     "digits: method rk4"),
       })
    EXPECT_NE(refusal(text).find(message), std::string::npos) << text << refusal(text);
  write("s.toml", axis(friction + "values = [0.1]\n"));
  expect_refusal("sweep s.toml", "--out is required");
  expect_refusal("sweep s.toml --out .", "must be a file");
  expect_refusal("sweep s.toml --out -", "must be a file");
  expect_refusal("sweep s.toml --out /dev/null", "must be a file");
  expect_refusal("sweep s.toml --out r.csv --jobs 0", "--jobs");
}

TEST_F(SweepFile, RefusesDrawsThatMeanNothing) {
  const auto drawn = [](const std::string& distribution, const std::string& above = "count = 3\n",
                        const std::string& quantity = "friction") {
    return "[sample]\n" + above + "[[sample.over]]\nquantity = \"" + quantity + "\"\n" +
           distribution + "\n";
  };
  const std::string tenths = "uniform = [0.1, 0.2]";
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {drawn("uniform = 3"), ":5: uniform: must be [from, to]"},
           {drawn("uniform = [1, 2, 3]"), ":5: uniform: must be [from, to]"},
           {drawn("normal = [1]"), ":5: normal: must be [mean, deviation]"},
           {drawn("uniform = [1, \"2\"]"), ":5: sample.over: must be numbers"},
           {drawn("uniform = [-1, 2]"), ":5: uniform: friction must be a finite number"},
           {drawn("uniform = [0.1, inf]"), ":5: uniform: friction must be a finite number"},
           {drawn("normal = [-1, 2]"), ":5: normal: friction must be a finite number"},
           {drawn("normal = [1, -2]"), ":5: normal: the deviation must be greater than 0"},
           {drawn("log_uniform = [0, 1]"), ":5: log_uniform: must begin above 0"},
           {drawn("log_uniform = [1, 1]"), ":5: log_uniform: must go from a number to a greater"},
           {drawn(tenths, "count = 0\n"), ":2: count: must be 1 at least"},
           {drawn(tenths, ""), "count: must be stated"},
           {drawn(tenths, "count = 2.5\n"), ":2: count: must be a whole number"},
           {drawn(tenths, "count = 3\nseed = -1\n"), ":3: seed: must be 0 at least"},
           {drawn(tenths, "count = 3\nmethod = \"lattice\"\n"),
            ":3: method: must be \"sobol\" or \"random\""},
           {drawn("uniform = [0, 1]", "count = 3\n", "method"), "only numbers can be drawn"},
           {"[[axis]]\nquantity = \"friction\"\nvalues = [0.1, nan, 0.3]\n",
            ":3: values: friction must be a finite number"},
           {"[[axis]]\nquantity = \"friction\"\nvalues = [0.1, \"0.2\"]\n",
            ":3: values: must be numbers"},
       })
    EXPECT_NE(refusal(text).find(message), std::string::npos) << text << refusal(text);
}

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
