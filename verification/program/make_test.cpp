/// What `make` makes anew, what it leaves alone, and that nothing which failed passes for made.
#include <fmt/format.h>

#include <chrono>

#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

using namespace std::chrono_literals;

class Make : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    fs::create_directories(folder_ / "figures/paper");
    for (const char* file : {"Makefile", "figures/draw.sh"})
      fs::copy_file(fs::path(ROTOR_SOURCES) / file, folder_ / file);
    write("figures/paper/fig18.toml", "");
  }

  /// Not as a part of the make that may run the tests, nor with the options it was given.
  Outcome make(const std::string& arguments) const {
    return shell("env -i PATH=\"$PATH\" make " + arguments);
  }
};

// Where a scene was edited all data are computed anew. Those that come out the same are left as
// they are, so that no picture is drawn again.
TEST_F(Make, ReplacesDataThatHaveChanged) {
  fs::create_directories(folder_ / "build/figures");
  const auto made_of = [&](const std::string& data) {
    write("build/rotor", "#!/bin/sh\nmkdir -p build/figures/new\necho " + data +
                             " > build/figures/new/fig18.csv\n");
    fs::permissions(folder_ / "build/rotor", fs::perms::owner_all);
    const fs::path stamp = folder_ / "build/figures/.data";
    const fs::path scene = folder_ / "figures/paper/fig18.toml";
    if (fs::exists(stamp)) fs::last_write_time(scene, fs::last_write_time(stamp) + 1s);
    const auto [status, output] = make("-o build -o build/rotor build/figures/.data");
    EXPECT_EQ(status, 0) << output;
    EXPECT_EQ(content("build/figures/fig18.csv"), data + "\n");
    return fs::last_write_time(folder_ / "build/figures/fig18.csv");
  };
  const auto first = made_of("a");
  EXPECT_EQ(made_of("a"), first);
  EXPECT_NE(made_of("b"), first);
}

// Data that were removed are written anew, others are left alone; a picture without its end is
// none.
TEST_F(Make, MakesAnewWhatHasBeenRemovedAndKeepsNoHalfPicture) {
  fs::create_directories(folder_ / "build/figures");
  fs::create_directories(folder_ / "bin");
  const auto program = [&](const std::string& file, const std::string& text) {
    write(file, "#!/bin/sh\n" + text);
    fs::permissions(folder_ / file, fs::perms::owner_all);
  };
  program("build/rotor", "mkdir -p build/figures/new; echo data > build/figures/new/fig18.csv\n");
  write("figures/paper/fig18.gp", "");
  write("figures/paper/style.gp", "");
  const auto make_figure = [&](const std::string& end, const std::string& format = "svg") {
    program("bin/gnuplot", "echo '<svg>" + end + "' > build/figures/fig18." + format + ".part\n");
    return shell("env -i PATH=\"$PWD/bin:$PATH\" make -o build -o build/rotor fig18 FORMAT=" +
                 format);
  };
  EXPECT_EQ(make_figure("IEND\xae\x42\x60\x82", "png").status, 0);
  EXPECT_EQ(make_figure("%%EOF", "pdf").status, 0);
  EXPECT_EQ(make_figure("</svg>").status, 0);
  for (const char* removed : {"build/figures/fig18.csv", "build/figures/fig18.svg"}) {
    ASSERT_TRUE(fs::remove(folder_ / removed));
    EXPECT_EQ(make_figure("</svg>").status, 0) << removed;
    EXPECT_TRUE(fs::exists(folder_ / removed));
  }
  // Points that were read off printed figures are drawn into these alone.
  fs::create_directories(folder_ / "reference-data/digitised");
  for (const char* file : {"fig17_force.csv", "fig18_force.csv", "fig18_speed.csv"})
    write(std::string("reference-data/digitised/") + file, "");
  program("bin/gnuplot",
          "echo \"$*\" >arguments; echo '<svg></svg>' >build/figures/fig18.svg.part\n");
  EXPECT_EQ(shell("env -i PATH=\"$PWD/bin:$PATH\" make -o build -o build/rotor fig18").status, 0);
  EXPECT_NE(content("arguments")
                .find("points = 'reference-data/digitised/fig18_force.csv "
                      "reference-data/digitised/fig18_speed.csv'"),
            std::string::npos)
      << content("arguments");
  fs::remove(folder_ / "build/figures/fig18.svg");
  const auto [status, output] = make_figure("");
  EXPECT_NE(status, 0);
  EXPECT_NE(output.find("fig18.svg: gnuplot has not drawn the whole picture"), std::string::npos)
      << output;
  EXPECT_FALSE(fs::exists(folder_ / "build/figures/fig18.svg"));
  EXPECT_FALSE(fs::exists(folder_ / "build/figures/fig18.svg.part"));
}

// What fails leaves nothing that a later make would take for made.
TEST_F(Make, KeepsNothingOfWhatHasFailed) {
  fs::create_directories(folder_ / "figures/maps");
  fs::create_directories(folder_ / "build/maps");
  write("figures/maps/some.toml", "");
  write("build/map-theory", "#!/bin/sh\necho half\nexit 1\n");
  fs::permissions(folder_ / "build/map-theory", fs::perms::owner_all);
  EXPECT_NE(
      make("-o build -o build/rotor -o map-theory -o build/map-theory build/maps/some-theory.csv")
          .status,
      0);
  EXPECT_FALSE(fs::exists(folder_ / "build/maps/some-theory.csv"));
}

// A test that fails ends `make verify` with a status of its own.
TEST_F(Make, SaysThatTestsHaveFailed) {
  const std::string run = "sh -c '" ROTOR_SOURCES "/verification/tests.sh fake'";
  fs::create_directories(folder_ / "fake");
  const std::string writes = "echo '{\"testsuites\": []}' > ${1#--gtest_output=json:}\n";
  for (const auto& [program, fails] : {std::pair(writes, false),
                                       {writes + "exit 1\n", true},
                                       {"kill -SEGV $$\n", true},
                                       {"exit 0\n", true}}) {
    write("fake/verification", "#!/bin/sh\n" + program);
    fs::permissions(folder_ / "fake/verification", fs::perms::owner_all);
    EXPECT_EQ(shell(run).status != 0, fails) << program;
    const bool crashed = program.find(writes) == std::string::npos;
    EXPECT_EQ(content("fake/report/tests-0.json").find("failures") != std::string::npos, crashed);
  }
}

// Also of a command whose output another one reads, such as a build's.
TEST_F(Make, FailsWhereACommandInAPipeDoes) {
  EXPECT_NE(shell("env -i PATH=\"$PATH\" make --eval='piped: ; @false | true' piped").status, 0);
}

}  // namespace
}  // namespace rotor
