/// What `make` says of requests that cannot be fulfilled: one line each.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <sstream>

#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

using namespace std::chrono_literals;

class Make : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    fs::copy_file(fs::path(ROTOR_SOURCES) / "Makefile", folder_ / "Makefile");
    fs::create_directories(folder_ / "figures/paper");
    write("figures/paper/fig18.toml", "");
  }

  /// Not as a part of the make that may run the tests, nor with the options it was given.
  Outcome make(const std::string& arguments) const {
    return shell("env -i PATH=\"$PATH\" make " + arguments);
  }
  /// What it would do.
  std::string plan(const std::string& arguments) const { return make("-n " + arguments).output; }

  void expect_line(const std::string& arguments, const std::string& line) const {
    const auto [status, output] = make(arguments);
    EXPECT_NE(status, 0) << arguments;
    EXPECT_NE(output.find(line), std::string::npos) << output;
    EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 1) << output;
  }
};

TEST_F(Make, SaysWhatItCannotMake) {
  for (const std::string format : {"jpg", "eps", "svg pdf", "%"})
    expect_line("FORMAT='" + format + "' figures",
                "FORMAT=" + format + ": must be one of: svg pdf png");
  expect_line("EQUATIONS=printed figures",
              "EQUATIONS=printed: must be one of: published consistent");
  for (const std::string points : {"many", "040", "19", "2.5e1", "-30", ""})
    expect_line("POINTS=" + points + " maps",
                "POINTS=" + points + ": must be a whole number, 20 at least");
  for (const std::string figures : {"3", "18,3", "18-3", "fig18", "three", "0"})
    expect_line("FIG=" + figures + " figures", "FIG=" + figures + ": must be some of: 18");
  write("build", "a file in the place of the folder");
  expect_line("build", "build: cannot be written");
  expect_line("figures/paper/fig18.gp",
              "The scene figures/paper/fig18.toml has no script figures/paper/fig18.gp");
}

// What it would do, FIG, EQUATIONS and FORMAT being handed on.
TEST_F(Make, HandsItsOptionsOn) {
  for (const char* name : {"fig03", "fig04", "fig08", "style"})
    write(std::string("figures/paper/") + name + ".gp", "");
  for (const char* name : {"fig03", "fig04", "fig08"})
    write(std::string("figures/paper/") + name + ".toml", "");
  fs::remove(folder_ / "figures/paper/fig18.toml");
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  const std::string all = plan("figures"), one = plan("FIG=4 figures"),
                    consistent = plan("EQUATIONS=consistent figures"),
                    pdf = plan("FORMAT=pdf fig03"), two = plan("FIG='03 08' figures");
  EXPECT_TRUE(has(all, "output = 'build/figures/fig03.svg.part'; format = 'svg'")) << all;
  EXPECT_TRUE(has(all, "fig04.svg.part")) << all;
  EXPECT_TRUE(has(one, "fig04.svg.part") && !has(one, "fig03.svg.part")) << one;
  EXPECT_TRUE(has(two, "fig03.svg.part") && has(two, "fig08.svg.part") &&
              !has(two, "fig04.svg.part"))
      << two;
  EXPECT_TRUE(has(consistent, "--equations consistent") &&
              has(consistent, "equations = 'consistent'") &&
              has(consistent, "/consistent/fig03.svg"))
      << consistent;
  EXPECT_TRUE(has(plan("FIG=3 report"), "pictures FORMAT=svg FIG= EQUATIONS="));
  EXPECT_TRUE(has(pdf, "fig03.pdf.part'; format = 'pdf'") && !has(pdf, "fig04")) << pdf;
  // A picture is made again if its data, its script or the style of all has changed.
  EXPECT_TRUE(has(plan("--print-data-base fig03"),
                  "\nbuild/figures/fig03.svg: build/figures/fig03.csv figures/paper/fig03.gp "
                  "figures/paper/style.gp"));
}

// Both sets of equations on the page, as many draws as README says, another compiler elsewhere.
TEST_F(Make, DoesAllThatItsTargetsPromise) {
  fs::remove(folder_ / "figures/paper/fig18.toml");
  const std::vector<std::pair<std::string, std::vector<std::string>>> targets = {
      {"verify", {"--target all", "verification/verify.sh build\n"}},
      {"CXX='ccache clang++' verify", {"verification/verify.sh build/clang++\n"}},
      {"CXX=clang++ verify", {"-B build/clang++ ", "verification/verify.sh build/clang++\n"}},
      {"report", {"for set in published consistent; do", "verification/report/report.sh build\n"}},
      {"FORMAT=pdf report", {"pictures FORMAT=svg FIG= EQUATIONS="}},
      {"check-report", {"verification/report/check.sh build\n"}},
      {"lint", {"verification/lint.sh build\n"}},
      {"sanitize", {"--preset sanitize -B build/sanitize", "verification/tests.sh build/sanitize"}},
      {"mpi", {"--target rotor-mpi ", "verification/program/mpi.sh build/mpi/rotor"}},
      {"portable", {"verification/program/portable.sh build\n"}},
      {"explore", {"figures/explore/build.sh build\n"}},
      {"mutants", {"verification/robustness/mutants.py --seed 1 --hand 50 --count 100\n"}},
      {"SEED=7 HAND=400 COUNT=50 mutants", {"mutants.py --seed 7 --hand 400 --count 50\n"}},
      {"reference",
       {"digits-reference reference-data/random-runs.csv\n",
        "reference reference-data/high-precision.csv reference-data/figure-values.csv\n"}},
      {"ensembles", {"ensembles reference-data 10000\n"}},
      {"reasons", {"reasons reference-data 1000\n"}},
      {"bench", {"benchmark build/bench ", "scene-costs figures/paper", "sweep-costs"}},
      {"SEED=3 stress",
       {"stress rotors 100000 build/stress-results\n", "stress steps build/stress-results\n",
        "precision reference-data/high-precision.csv build/stress-results\n",
        "digits-reference stress 1000 3 build/stress-results\n"}},
      {"clean", {"rm -rf build\n"}}};
  for (const auto& [target, done] : targets)
    for (const std::string& step : done)
      EXPECT_NE(plan(target).find(step), std::string::npos) << target << ": " << step;
}

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

// Each map that there is, by its outcomes and by its forces.
TEST_F(Make, DrawsEachMapTwice) {
  fs::remove(folder_ / "figures/paper/fig18.toml");
  fs::copy(fs::path(ROTOR_SOURCES) / "figures/maps", folder_ / "figures/maps");
  write("figures/paper/style.gp", "");
  const std::string maps_plan = plan("maps");
  int maps = 0;
  for (const auto& entry : fs::directory_iterator(folder_ / "figures/maps")) {
    const std::string map = entry.path().stem();
    if (entry.path().extension() != ".toml" || map == "rounding") continue;
    ++maps;
    for (const char* shows : {"outcome", "force"})
      EXPECT_NE(
          maps_plan.find(fmt::format("data = 'build/maps/{0}.csv'; output = "
                                     "'build/maps/{0}-{1}.svg.part'; format = 'svg'; theory = "
                                     "'build/maps/{0}-theory.csv'; shows = '{1}'\" "
                                     "figures/paper/style.gp figures/maps/{0}.gp",
                                     map, shows)),
          std::string::npos)
          << map << maps_plan;
  }
  EXPECT_GE(maps, 4);
  EXPECT_EQ(maps_plan.find("\nrm "), std::string::npos) << maps_plan;  // what took minutes is kept
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

// As many points as are asked for along the axes of maps, and a tenth of them for an ensemble.
TEST_F(Make, HandsThePointsOfMapsOn) {
  fs::create_directories(folder_ / "figures/maps");
  write("figures/maps/some.toml", "points = 400\npoints = 40\npoints = 4000\n");
  for (const int points : {20, 40, 100, 4000}) {
    const std::string file = fmt::format("build/maps/{}/some.toml", points);
    EXPECT_EQ(make(fmt::format("POINTS={} {}", points, file)).status, 0);
    EXPECT_EQ(content(file),
              fmt::format("points = {}\npoints = {}\npoints = 4000\n", points, points / 10));
  }
}

// What the build, the tests and the pictures need, by the names that Debian 12 has for it.
TEST_F(Make, InstallsWhatIsNeeded) {
  const std::string makefile = content("Makefile");
  const auto begin = makefile.find("\nPACKAGES := "), end = makefile.find("\n# ", begin);
  std::istringstream words(makefile.substr(begin, end - begin));
  std::set<std::string> packages;
  for (std::string word; words >> word;)
    if (word != "PACKAGES" && word != ":=" && word != "\\") packages.insert(word);
  EXPECT_EQ(packages,
            (std::set<std::string>{"g++", "cmake", "ninja-build", "libboost-dev", "libeigen3-dev",
                                   "libcli11-dev", "libtomlplusplus-dev", "nlohmann-json3-dev",
                                   "libfmt-dev", "libgtest-dev", "librapidcheck-dev",
                                   "libkainjow-mustache-dev", "gnuplot-nox", "fonts-dejavu-core"}));
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

TEST_F(Make, NamesTheFiguresThatThereAre) {
  EXPECT_NE(make("help").output.find("one figure: fig18\n"), std::string::npos);
}

// A user's own settings for gnuplot change no picture.
TEST_F(Make, CallsGnuplotWithoutTheUsersSettings) {
  const std::string makefile = content("Makefile"), call = "gnuplot -";
  int calls = 0;
  for (std::size_t at = 0; (at = makefile.find(call, at)) != std::string::npos; at += call.size()) {
    EXPECT_EQ(makefile.substr(at, 13), "gnuplot -d -e");
    ++calls;
  }
  EXPECT_EQ(calls, 4);
}

// Also of a command whose output another one reads, such as a build's.
TEST_F(Make, FailsWhereACommandInAPipeDoes) {
  EXPECT_NE(shell("env -i PATH=\"$PATH\" make --eval='piped: ; @false | true' piped").status, 0);
}

}  // namespace
}  // namespace rotor
