/// The program, and bad input to it.
#include "verification/support/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "figures/data/text.hpp"

namespace rotor {
namespace {

TEST_F(CommandLine, RefusesBadInputAndWritesNothing) {
  expect_refusal("run --mass 0 --trace t.csv", "--mass: must be a finite number greater than 0 kg");
  expect_refusal("run --friction nan --trace t.csv",
                 "--friction: must be a finite number not below 0");
  expect_refusal("run --friction high --trace t.csv", "--friction: must be a finite number");
  expect_refusal("run --friction ' 3'", "--friction: must be a finite number not below 0, not  3");
  expect_refusal("run --friction '3 '", "--friction: must be a finite number not below 0, not 3 ");
  expect_refusal("run --friction ''", "--friction: must be a finite number not below 0, not");
  expect_refusal("run --tolerance 1e-18", "--tolerance: must be a finite number not below 1e-15");
  expect_refusal("run --stator-radius 0.05 --trace t.csv", "must be larger than rotor_radius");
  expect_refusal("run --eccentricity 0.07",
                 "eccentricity = 0.07 m: must be smaller than rotor_radius = 0.06 m");
  expect_refusal("run --equations newton --trace t.csv", "must be one of: published, consistent");
  expect_refusal("run --columns time --trace t.csv",
                 "there is no column \"time\"; did you mean time_s?; there are: time_s");
  for (const std::string from : {"1", "2"})
    expect_refusal("run --until 1 --trace t.csv --from " + from,
                   "--from " + from + ": must lie inside the run");
  expect_refusal("run --until 0.1 --trace .", "it is a folder");
  expect_refusal("run --until 0.1 --trace ''", "--trace: must name a file");
  expect_refusal("run --until 0.1 --events ''", "--events: must name a file");
  expect_refusal("run --until 0.1 --columns time_s", "--columns requires --trace, or is help");
  expect_refusal("run --until 0.1 --method rk4 --events e.csv", "only --method event");
  expect_refusal("run --until 0.1 --method rk4 --step-run-up 0.2",
                 "step_run_up = 0.2 s: must not be longer than the run");
}

TEST_F(CommandLine, SaysWhatWasProbablyMeant) {
  expect_refusal("run --frcition 0.2",
                 "--frcition: there is no such option of run; did you mean "
                 "--friction?");
  expect_refusal("run --tolerence=1e-9",
                 "--tolerence: there is no such option of run; did you mean --tolerance?");
  expect_refusal("run --weight 5", "--weight: there is no such option of run");
  expect_refusal("foo", "foo: there is no such command; the commands are: figure, plot, run");
  expect_refusal("rnu", "rnu: there is no such command; did you mean run?");
  expect_refusal("run --mass " + std::string(100'000, '9') + "x",
                 "--mass: must be a finite number");
  expect_refusal("run --" + std::string(100'000, 'a'), "there is no such option");
  for (const char* number : {"1e3", "0x10", "2.0", "-5"})
    expect_refusal(std::string("run --trace t.csv --rows ") + number,
                   fmt::format("--rows: must be a whole number, not \"{}\"", number));
  expect_refusal("run --until 1 --no-separation --trace t.csv --rows 00", "--rows 0: must be from");
}

TEST_F(CommandLine, NamesAnUnknownOptionWithoutItsValue) {
  expect_refusal("run --frction=0.1=2",
                 "--frction: there is no such option of run; did you mean --friction?");
}

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

TEST_F(CommandLine, ReadsScenesFromRegularFilesAlone) {
  fs::create_directory(folder_ / "scenes");
  expect_refusal("run --scene nowhere.toml", "nowhere.toml: cannot be read: there is no such file");
  expect_refusal("run --scene scenes", "scenes: cannot be read: it is no regular file");
  expect_refusal("run --scene /dev/zero", "/dev/zero: cannot be read: it is no regular file");
  expect_refusal("run --scene ''", "--scene: must name a file");
  expect_refusal("figure 99 --out f", "the figures are 2, 3, 4");
  expect_refusal("figure --scenes nowhere --out f", "--scenes nowhere: there is no such folder");
  expect_refusal("figure --scenes scenes --out f", "--scenes scenes: there is no figNN.toml");
  fs::create_directory(folder_ / "scenes" / "fig02.toml");
  expect_refusal("figure --scenes scenes --out f", "fig02.toml: cannot be read: it is no regular");
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

TEST_F(CommandLine, ListsTheEventsOfARun) {
  const auto [status, output] = rotor("run --until 29.11 --events e.csv --json");
  EXPECT_EQ(status, 0) << output;
  EXPECT_NE(output.find("\"located_events\": 4"), std::string::npos) << output;
  std::string kinds;
  for (const std::string& row : rows_of("e.csv")) kinds += row.substr(0, row.find(',')) + ' ';
  EXPECT_EQ(kinds, "event motor_off mass_loss touch_down release ring_clear ");
}

TEST_F(CommandLine, NeedsACommand) {
  const auto [status, output] = rotor("");
  EXPECT_NE(status, 0);
  EXPECT_TRUE(output.starts_with("rotor: A subcommand is required")) << output;
}

TEST_F(CommandLine, TellsTheDefaultsOfItsOptions) {
  const std::string help = rotor("run --help").output;
  for (const char* option : {"--mass kg=5 ", "--until s=0.25 s after the mass loss"}) {
    const auto at = help.find(option);
    EXPECT_NE(at, std::string::npos) << option << help;
    EXPECT_EQ(help.find(option, at + 1), std::string::npos) << option;
  }
  EXPECT_EQ(help.find("--clearance m="), std::string::npos) << help;
  for (const auto& [option, other] : {std::pair("\n  --clearance ", "--stator-radius"),
                                      {"\n  --lost-mass ", "--unbalance-factor"},
                                      {"\n  --separation-speed-hz ", "--separation-time"}}) {
    const auto at = help.find(option);
    ASSERT_NE(at, std::string::npos) << option << help;
    const std::string line = help.substr(at + 1, help.find('\n', at + 1) - at - 1);
    EXPECT_TRUE(line.ends_with(std::string(", instead of ") + other)) << line;
  }
  const auto line = help.find("\n  --torque N m=0.3                  torque of the motor");
  EXPECT_NE(line, std::string::npos) << help;
}

TEST_F(CommandLine, SummarisesARunAsJsonAndTracesIt) {
  const auto [status, output] =
      rotor("run --method rk4 --until 0.01 --trace t.csv --columns time_s,rho_m --json");
  EXPECT_EQ(status, 0) << output;
  EXPECT_NE(output.find("\"first_contact_s\": null"), std::string::npos) << output;
  const auto rows = rows_of("t.csv");
  ASSERT_EQ(rows.size(), 1U + 101);  // 100 steps and the start
  EXPECT_EQ(rows[0], "run,time_s,rho_m");
}

TEST_F(CommandLine, TracesWhatTheSceneSays) {
  write("scene.toml",
        "columns = [\"time_s\", \"rho_m\"]\nwindow = { from_s = 0.01, until_s = 0.02 }\n"
        "[parameters]\nuntil = 0.03\nmethod = \"rk4\"");
  const auto [status, output] = rotor("run --scene scene.toml --mass 6 --trace t.csv");
  EXPECT_EQ(status, 0) << output;
  const auto rows = rows_of("t.csv");
  ASSERT_EQ(rows.size(), 1U + 101);  // 100 steps of 1e-4 s and the start
  EXPECT_EQ(rows[0], "run,time_s,rho_m");
  EXPECT_TRUE(rows[1].starts_with("run,0.01,")) << rows[1];
}

TEST_F(CommandLine, DrawsNoFigureOfARunThatNeverRolls) {
  write("fig31.toml",
        "title = \"t\"\ncolumns = [\"time_s\", \"rho_m\"]\n"
        "window = { from = \"rolling_onset\", length_s = 0.01 }\n"
        "[parameters]\nuntil = 0.05\n[[run]]\nname = \"at rest\"\n");
  expect_refusal("figure 31 --scenes . --out .",
                 "./fig31.toml: nothing of the run \"at rest\" lies in the window");
}

TEST_F(CommandLine, ShowsEachRunOfAFigureToItsEnd) {
  write("fig21.toml",
        "window = { from_s = 0.004 }\n[parameters]\nstart_speed_hz = 30\n"
        "[[run]]\nname = \"short\"\nuntil = 0.01\n[[run]]\nname = \"long\"\nuntil = 0.02\n");
  EXPECT_EQ(rotor("figure --scenes . --out .").status, 0);
  EXPECT_TRUE(rows_of("fig21.csv")[1].starts_with("short,0.004,"));
  EXPECT_TRUE(rows_of("fig21.csv").back().starts_with("long,0.02,"));
}

TEST_F(CommandLine, LeavesAFiguresSceneItsOwnMethod) {
  write("fig21.toml",
        "[parameters]\nuntil = 0.1\n[[run]]\nname = \"located\"\n[[run]]\nname = "
        "\"fixed\"\nmethod = \"rk4\"");
  const auto [status, output] = rotor("figure --scenes . --out . --method event");
  EXPECT_EQ(status, 0) << output;
  const std::string csv = content("fig21.csv");
  EXPECT_NE(csv.find("fixed: equations published, method rk4"), std::string::npos);
  EXPECT_NE(csv.find("located: equations published, method event"), std::string::npos);
}

// Nothing of a mass loss is said of it: its cells are empty.
TEST_F(CommandLine, HasNoClosedFormsOfARotorAtRest) {
  write("rest.toml",
        "[parameters]\nstart_speed_hz = 0\nno_separation = true\nuntil = 1\n"
        "[[axis]]\nquantity = \"friction\"\nvalues = [0.1]\n");
  EXPECT_TRUE(shell(ROTOR_MAP_THEORY " rest.toml").output.ends_with("\n0.1,,,,,,,,\n"));
}

TEST_F(CommandLine, HasNoClosedFormsOfDraws) {
  write("drawn.toml",
        "[[axis]]\nquantity = \"mass\"\nvalues = [5]\n"
        "[sample]\ncount = 3\n[[sample.over]]\nquantity = \"friction\"\nuniform = [0.1, 1]\n");
  EXPECT_EQ(shell(ROTOR_MAP_THEORY " drawn.toml").output,
            "map-theory: drawn.toml: a map has an [[axis]], and no [sample]\n");
}

}  // namespace
}  // namespace rotor
