/// The program, and bad input to it.
#include "verification/support/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "figures/data/text.hpp"

namespace rotor {
namespace {

// Of six letters two may be wrong.
TEST(Suggestion, CountsLettersThatChangedPlacesAsOneMistake) {
  EXPECT_EQ(suggestion("badcef", {"abcdef"}), "; did you mean abcdef?");
  EXPECT_EQ(suggestion("bxdcef", {"abcdef"}), "");
}

// Nobody mistypes a name for a text, and comparing letters takes the product of both lengths.
TEST(Suggestion, IsNoneForLongTexts) {
  const std::string longest(60, 'a'), longer(61, 'a');
  EXPECT_EQ(suggestion(longest, {longest}), "; did you mean " + longest + "?");
  EXPECT_EQ(suggestion(longer, {longest}), "");
}

TEST(Shown, LeavesOutWholeLettersOnly) {
  EXPECT_EQ(shown(std::string(59, 'a') + "äb"), std::string(59, 'a') + "...");
  EXPECT_EQ(shown(std::string(58, 'a') + "äb"), std::string(58, 'a') + "ä...");
  EXPECT_EQ(shown(std::string(58, 'a') + "ä"), std::string(58, 'a') + "ä");
}

TEST(Suggestion, IsWhatHasTheMistypedAsAPart) {
  EXPECT_EQ(suggestion("stiffness", {"mass", "support_stiffness"}),
            "; did you mean support_stiffness?");
}

TEST_F(CommandLine, RefusesScenesThatNoParserStands) {
  std::string keys = "a";
  for (int i = 0; i < 50'000; ++i) keys += ".a";
  write("deep.toml", "title = \"a\"\n" + keys + " = 1\n");
  expect_refusal("run --scene deep.toml", "deep.toml:2: is nested deeper than any scene needs");
  write("arrays.toml", "columns = " + std::string(50'000, '[') + "\n");
  expect_refusal("run --scene arrays.toml", "arrays.toml:1: is nested deeper");
  write("long.toml", "columns = [\"\"\"\n# \"\"\", {" + keys + " = 1}]\n");
  expect_refusal("run --scene long.toml", "long.toml:2: is nested deeper");
  write("closed.toml", "# " + std::string(60'000, ']') + "\ncolumns = " + std::string(50'000, '['));
  expect_refusal("run --scene closed.toml", "closed.toml:2: is nested deeper");
  write("comment.toml", "  # " + std::string(400, '.') + std::string(400, '[') + "\ntitle = 1\n");
  expect_refusal("run --scene comment.toml", "comment.toml:2: title");
  std::string values = "0.1";
  for (int i = 0; i < 400; ++i) values += ", 0.1";
  write("list.toml", "[[axis]]\nquantity = \"friction\"\nvalues = [" + values + "]\n");
  EXPECT_TRUE(rotor("sweep list.toml --dry-run").output.starts_with("401 points"));
  // Brackets that are closed again are not nested.
  std::string runs;
  for (int i = 0; i < 150; ++i) runs += fmt::format("[[run]]\nname = \"{}\"\n", i);
  write("wide.toml", "[parameters]\nuntil = 1e-3\n" + runs);
  EXPECT_EQ(rotor("run --scene wide.toml").status, 0);
  write("large.toml", "title = \"" + std::string(2'000'000, 'a') + "\"\n");
  expect_refusal("run --scene large.toml", "large.toml: cannot be read: it is larger than");
}

TEST_F(CommandLine, LeavesAnExistingFileAloneWhenARunFails) {
  write("t.csv", "precious");
  EXPECT_NE(rotor("run --method rk4 --contact-stiffness 1e13 --trace t.csv").status, 0);
  EXPECT_EQ(content("t.csv"), "precious");
}

TEST_F(CommandLine, ShowsEachRunOfAFigureToItsEnd) {
  write("fig21.toml",
        "window = { from_s = 0.004 }\n[parameters]\nstart_speed_hz = 30\n"
        "[[run]]\nname = \"short\"\nuntil = 0.01\n[[run]]\nname = \"long\"\nuntil = 0.02\n");
  EXPECT_EQ(rotor("figure --scenes . --out .").status, 0);
  EXPECT_TRUE(rows_of("fig21.csv")[1].starts_with("short,0.004,"));
  EXPECT_TRUE(rows_of("fig21.csv").back().starts_with("long,0.02,"));
}

}  // namespace
}  // namespace rotor
