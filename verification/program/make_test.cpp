/// The targets of make, and what CMake refuses. Failed targets must not pass as made.
#include <fmt/format.h>

#include "verification/support/command_line.hpp"
#include "verification/support/content.hpp"

namespace rotor {
namespace {

class Make : public CommandLine {
 protected:
  void program(const std::string& file, const std::string& text) const {
    write(file, "#!/bin/sh\n" + text);
    fs::permissions(folder_ / file, fs::perms::owner_all);
  }

  /// With nothing of the make that runs the tests, and with the folder's own programs first.
  static constexpr auto in_environment = "env -i PATH=\"$PWD/bin:$PATH\" ";

  Outcome make(const std::string& arguments, const std::string& variables = "") const {
    return shell(in_environment + variables + " make " + arguments);
  }
};

/// Real targets, in a path that has a blank: of two figures and a map, with programs that need not
/// be compiled.
class Checkout : public Make {
 protected:
  void SetUp() override {
    Make::SetUp();
    folder_ /= "a r\u00f6tor";
    for (const char* folder : {"bin", "figures/paper", "figures/maps", "reference-data"})
      fs::create_directories(folder_ / folder);
    for (const char* file :
         {"Makefile", "CMakePresets.json", "figures/draw.sh", "figures/make",
          "figures/paper/style.gp", "figures/paper/palette.gp", "verification/tests.sh"}) {
      fs::create_directories((folder_ / file).parent_path());
      fs::copy(fs::path(ROTOR_SOURCES) / file, folder_ / file);
    }
    write("CMakeLists.txt",
          "cmake_minimum_required(VERSION 3.25)\nproject(rotor LANGUAGES NONE)\n"
          "set(ROTOR_WITH \"\" CACHE STRING \"\")\noption(ROTOR_DIGITS \"\" ON)\n"
          "foreach(name rotor map-theory map-statistics)\n  add_executable(${name} IMPORTED)\n"
          "  set_target_properties(${name} PROPERTIES IMPORTED_LOCATION "
          "${PROJECT_SOURCE_DIR}/bin/${name})\nendforeach()\n"
          "include(figures/make/pictures.cmake)\n");
    program("bin/dpkg-query", "shift 2; for name; do echo ii $name; done\n");
    fs::create_symlink(ROTOR_PROGRAM, folder_ / "bin/rotor");
    for (const char* figure : {"figures/paper/fig18", "figures/paper/fig19"}) {
      write(std::string(figure) + ".toml",
            "title = \"T\"\ncolumns = [\"time_s\", \"rho_m\"]\n[parameters]\n"
            "start_speed_Hz = 150\nuntil = 0.001\n");
      write(std::string(figure) + ".gp",
            "data = exists('data_corrected') ? data_corrected : data_published\n"
            "plot data using 'time_s':'rho_m' with lines\n");
    }
  }
  void TearDown() override {
    folder_ = folder_.parent_path();
    Make::TearDown();
  }

  /// What is printed, if all is well: the files that were drawn.
  std::string made(const std::string& arguments, const std::string& variables = "") const {
    const auto [status, output] = make(arguments, variables);
    EXPECT_EQ(status, 0) << arguments << ": " << output;
    return output;
  }
};

// Neither format nor equations are those of the last time, nor of the environment.
TEST_F(Checkout, DrawsEachFigureOnce) {
  const std::string both = "build/figures/fig18.svg\n", other = "build/figures/fig19.svg\n";
  EXPECT_EQ(made("fig18"), both);
  EXPECT_EQ(made("FORMAT=pdf EQUATIONS=published fig18"), "build/figures/published/fig18.pdf\n");
  EXPECT_EQ(made("-j figures", "FORMAT=png EQUATIONS=corrected FIG=18 CXX=none"), other);
  EXPECT_EQ(made("-j1 figures fig18"), "");
  EXPECT_EQ(made("FIG='18 19' FORMAT=png figures").size(), 2 * both.size());
  for (const char* picture : {"fig18.svg", "fig19.png", "published/fig18.pdf"})
    EXPECT_EQ(shell(std::string("tail -c 16 build/figures/") + picture +
                    " | grep -aq '</svg>\\|%%EOF\\|IEND'")
                  .status,
              0)
        << picture;
  EXPECT_FALSE(fs::exists(folder_ / "build/figures/published/fig19.pdf"));
}

// Removed and damaged data are written again with their pictures, others and theirs are left alone.
// The same figures can be made twice at once.
TEST_F(Checkout, MakesAnewWhatHasBeenDamaged) {
  const std::string both = "build/figures/fig18.svg\n";
  made("figures");
  for (const char* damaged : {"published/fig18.csv", "corrected/fig18.csv", "corrected/fig18.var"})
    for (const char* damage : {"rm ", "echo damaged >>"}) {
      const std::string file = std::string("build/figures/") + damaged, before = content(file);
      shell(damage + file);
      EXPECT_EQ(made("figures"), both) << damage << file;
      EXPECT_EQ(content(file), before);
    }
  for (const char* changed : {"paper/fig18.gp", "paper/fig18.toml"}) {
    shell(std::string("echo '# changed' >>figures/") + changed);
    EXPECT_EQ(made("figures"), has(changed, "gp") ? both : "") << changed;  // the same data
  }
  shell("rm -r build/figures");
  const std::string make_figures = std::string(in_environment) + "make figures >";
  const auto [status, output] =
      shell(make_figures + "one & " + make_figures +
            "two && wait $! && grep -c '^</svg>' build/figures/fig18.svg");
  EXPECT_EQ(status, 0) << content("one") << content("two");
  EXPECT_EQ(output, "1\n");
  EXPECT_EQ(made("figures"), "");
}

// An archive has the files of the commit and what was made, and the same bytes each time.
TEST_F(Checkout, PacksWhatIsFinished) {
  program("bin/git",
          "case $1 in status) [ ! -e changed ] || cat changed;; archive) tar -c Makefile "
          "CITATION.cff;; "
          "show) echo 1700000000;; esac\n");
  write("CITATION.cff", "version: 9.9\n");
  for (const char* folder : {"build/report", "build/figures", "build/maps/20"})
    fs::create_directories(folder_ / folder);
  for (const char* file : {"build/report/index.html", "build/report/claims.csv",
                           "build/figures/fig18.svg", "build/maps/20/small.svg"})
    write(file, file);
  const std::string dist = in_environment + std::string("figures/make/dist.sh build 20 svg");
  EXPECT_EQ(shell(dist).output, "build/rotor-9.9.tar.gz\n");
  const std::string packed = content("build/rotor-9.9.tar.gz");
  EXPECT_EQ(shell("tar -tzf build/rotor-9.9.tar.gz | grep -v '/$'").output,
            "rotor-9.9/CITATION.cff\nrotor-9.9/Makefile\nrotor-9.9/results/claims.csv\n"
            "rotor-9.9/results/figures/fig18.svg\nrotor-9.9/results/index.html\n"
            "rotor-9.9/results/maps/small.svg\n");
  shell("sleep 1");  // files are packed with the time of the commit
  shell(dist);
  EXPECT_TRUE(content("build/rotor-9.9.tar.gz") == packed);
  write("changed", " M Makefile\n");
  const auto [status, output] = shell(dist);
  EXPECT_EQ(status, 1);
  EXPECT_EQ(output, "make dist: these files differ from the commit:\n M Makefile\n");
  EXPECT_TRUE(content("build/rotor-9.9.tar.gz") == packed);
}

// An incomplete picture is removed, and so is what an interrupted make has begun.
TEST_F(Checkout, KeepsNothingHalfMade) {
  program("bin/gnuplot", "echo '<svg>' >$(expr \"$3\" : \"output = '\\([^']*\\)'\")\n");
  const auto [status, output] = make("fig18");
  EXPECT_NE(status, 0);
  EXPECT_TRUE(has(output, "fig18.svg: gnuplot did not draw the whole picture"));
  EXPECT_EQ(shell("ls build/figures").output, "corrected\npublished\n");
  for (const std::string waits : {"gnuplot", "rotor"}) {
    fs::rename(folder_ / "bin/rotor", folder_ / "bin/other");
    program("bin/" + waits, "touch waits; sleep 60\n");
    if (waits == "gnuplot") fs::rename(folder_ / "bin/other", folder_ / "bin/rotor");
    EXPECT_NE(shell(std::string(in_environment) + "timeout 60 make fig18 & for n in $(seq 300); do "
                                                  "[ -e waits ] && break; sleep 0.1; done; "
                                                  "rm waits || exit 0; kill $!; wait $!")
                  .status,
              0)
        << waits;
  }
  fs::remove(folder_ / "bin/gnuplot");
  fs::rename(folder_ / "bin/other", folder_ / "bin/rotor");
  EXPECT_EQ(made("fig18"), "build/figures/fig18.svg\n");
  EXPECT_EQ(shell("ls build/figures build/figures/*/ | grep 'new\\|svg'").output, "fig18.svg\n");
}

// Programs report here what they do. A sweep resumes from what it left. No map is made for an
// option that is none, or for points that cannot be.
TEST_F(Checkout, MakesMapsOncePerFolder) {
  write("figures/maps/small.toml", "[[axis]]\npoints = 400\n");
  for (const char* script : {"small", "map", "lines"})
    write(fmt::format("figures/maps/{}.gp", script), "");
  fs::remove(folder_ / "bin/rotor");
  program("bin/rotor",
          "[ $1 = sweep ] || { touch $6/settings.gp; exit 0; }\n"
          "echo sweep $2 >>done\n[ -e $5.journal ] || { touch $5.journal; exit 1; }\n"
          "grep points $2 >$5\n");
  for (const char* name : {"bin/map-theory", "bin/map-statistics", "figures/maps/tolerance.sh"})
    program(name, "echo 1\n");
  fs::remove(folder_ / "figures/draw.sh");
  program("figures/draw.sh", "echo draw $1 >>done\ntouch $1\n");
  const auto done_by = [&](const std::string& arguments, bool all_is_well) {
    shell("rm -f done");
    EXPECT_EQ(make(arguments).status == 0, all_is_well) << arguments;
    return shell("touch done; sort done").output;
  };
  const std::string map = "build/maps/40/small", draws = "draw " + map;
  for (const char* refused :
       {"POINT=40 maps", "POINTS=19 maps", "POINTS=040 maps", "POINTS= maps", "FORMAT=jpg maps"})
    EXPECT_EQ(done_by(refused, false), "") << refused;
  EXPECT_FALSE(fs::exists(folder_ / "build"));
  EXPECT_EQ(done_by("POINTS=40 maps", false), "sweep " + map + ".toml\n");  // as if interrupted
  EXPECT_EQ(done_by("POINTS=40 maps", true),
            draws + "-force.svg\n" + draws + "-outcome.svg\nsweep " + map + ".toml\n");
  EXPECT_EQ(content(map + ".csv"), "points = 40\n");
  EXPECT_EQ(done_by("POINTS=40 FORMAT=png maps", true),
            draws + "-force.png\n" + draws + "-outcome.png\n");
  done_by("maps", false);
  EXPECT_TRUE(has(done_by("maps", true), "sweep build/maps/small.toml\n"));
  EXPECT_EQ(content("build/maps/small.csv"), "points = 400\n");
  for (const char* again : {"maps", "POINTS=40 maps"}) EXPECT_EQ(done_by(again, true), "");
}

// Only what stands on the command line decides which tests run, and how; and how many compilers.
TEST_F(Checkout, HeedsNothingThatIsExported) {
  fs::create_directories(folder_ / "build/sanitize");
  program("bin/cmake", "echo $* >>called\n");
  program("build/sanitize/verification",
          "echo $1 $GTEST_FILTER $ROTOR_APPROVE $CXX > seen\n"
          "echo '\"result\": \"COMPLETED\"' > ${2#--gtest_output=json:}\n");
  for (const auto& [option, filter] : {std::pair("", "*"), {"TESTS='-A b'", "-A b"}}) {
    made(std::string("sanitize ") + option,
         "GTEST_FILTER=None ROTOR_APPROVE=1 CXX=none TESTS=None");
    EXPECT_EQ(content("seen"), std::string("--gtest_filter=") + filter + " c++\n");
  }
  made("-j1 build");
  EXPECT_TRUE(has(content("called"), "--build build --target rotor -j1\n"));
}

// For any configuration, by the environment, or in a project that includes this one. What has been
// refused is not remembered.
TEST_F(Make, RefusesFlagsThatChangeTheArithmetic) {
  const std::string run = "cmake -S '" ROTOR_SOURCES "' -B made -G Ninja -DROTOR_VERIFICATION=OFF ";
  const auto expect_refusal_of = [this](const std::string& flag, const std::string& command) {
    const auto [status, output] = shell(command);
    EXPECT_NE(status, 0) << command;
    EXPECT_TRUE(has(output, " has " + flag + ":")) << command;
  };
  for (const char* flag : {"-Ofast", "-ffast-math", "-ffp-model=fast", "-ffp-model=aggressive",
                           "-fno-signed-zeros", "-funsafe-math-optimizations", "-fassociative-math",
                           "-freciprocal-math", "-ffinite-math-only", "-fno-honor-nans",
                           "-fno-honor-infinities", "-fapprox-func", "-fsingle-precision-constant"})
    expect_refusal_of(flag, run + "-DCMAKE_CXX_FLAGS_DEBUG='-g " + flag + "'");
  for (const std::string configuration :
       {"", "_RELEASE", "_RELWITHDEBINFO", "_MINSIZEREL", "_MY_OWN_2"})
    expect_refusal_of("-Ofast", run + "-DCMAKE_CXX_FLAGS" + configuration + "=-Ofast");
  expect_refusal_of("-Ofast", "CXXFLAGS='-g -Ofast' " + run);
  const auto [status, output] = shell("CXXFLAGS='-g -fno-fast-math -O2' " + run);
  EXPECT_EQ(status, 0) << output;
  expect_refusal_of("-Ofast", "rm -r made; CXX='c++ -Ofast' " + run);
  write("CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.25)\nproject(mine CXX)\n"
        "add_compile_options($<$<CONFIG:Debug>:-Ofast>)\nadd_subdirectory(rotor)\n");
  expect_refusal_of("-Ofast", "rm -r made; ln -s '" ROTOR_SOURCES "' rotor; cmake -B made");
}

// What a compiler reports of its flags, even if CMake has not seen them; and not those of the
// program itself.
TEST_F(Make, CompilesTheModelWithNoOtherArithmetic) {
  const std::vector<std::string> both = {"-Ofast", "-ffast-math", "-ffinite-math-only"};
  std::vector<std::string> of_gcc = {"-funsafe-math-optimizations", "-freciprocal-math",
                                     "-fno-signed-zeros", "-fsingle-precision-constant",
                                     "-fassociative-math -fno-signed-zeros -fno-trapping-math"};
  of_gcc.insert(of_gcc.end(), both.begin(), both.end());
  write("a.cpp", "#include \"model/mechanics/parameters.hpp\"\n");
  for (const auto& [compiler, flags] : {std::pair("g++", of_gcc), {"clang++", both}}) {
    const auto compile = [&, compiler = compiler](const std::string& with) {
      return shell(fmt::format("{} -std=c++20 -fsyntax-only {} -I '" ROTOR_SOURCES "' a.cpp",
                               compiler, with));
    };
    if (shell(std::string("command -v ") + compiler).status != 0) continue;
    EXPECT_EQ(compile("-O2 -fno-math-errno -fno-trapping-math -ffp-contract=off").status, 0);
    for (const std::string& flag : flags) {
      const auto [status, output] = compile(flag);
      EXPECT_NE(status, 0) << compiler << flag;
      EXPECT_TRUE(has(output, ": leave out -")) << compiler << flag;
    }
  }
}

// The model needs none of the program's libraries, builds nothing but itself, and brings its C++20.
// The other project may have targets with the names of this one.
TEST_F(Make, BuildsTheModelAloneInAnotherProject) {
  const std::string readme = content_of(ROTOR_SOURCES "/model/README.md");
  const auto block = [&](const std::string& language) {
    const std::size_t start = readme.find("```" + language + '\n') + language.size() + 4;
    return readme.substr(start, readme.find("```", start) - start);
  };
  write("accident.cpp", block("cpp"));
  std::string project = "cmake_minimum_required(VERSION 3.25)\nproject(mine CXX)\n";
  for (const char* target : {"model", "project_options", "seldom_run", "data", "rotor", "digits"})
    project += fmt::format("add_library({} INTERFACE)\n", target);
  write("CMakeLists.txt", project + block("cmake"));
  shell("ln -s '" ROTOR_SOURCES "' rotor");
  for (const std::string standard : {"", "-DCMAKE_CXX_STANDARD=17"}) {
    const auto [status, output] =
        shell("cmake -B made -G Ninja -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON " + standard +
              " >log 2>&1 && ninja -C made CMakeFiles/accident.dir/accident.cpp.o >>log && "
              "ninja -C made -t commands | grep -o ' -o [^ ]*[.]dir/' | sort -u");
    EXPECT_EQ(output, " -o CMakeFiles/accident.dir/\n -o rotor/CMakeFiles/rotor_model.dir/\n")
        << standard << status << content("log");
  }
  const std::string printed = shell("'" ROTOR_EXAMPLE "'").output;
  EXPECT_TRUE(has(readme, '`' + printed.substr(0, printed.size() - 1) + '`')) << printed;
}

// Moved anywhere, the installed program finds its scenes and scripts: without them it does nothing.
TEST_F(Make, InstallsAProgramThatCanBeMoved) {
  fs::create_directories(folder_ / "figures/make");
  fs::copy_file(ROTOR_SOURCES "/Makefile", folder_ / "Makefile");
  program("figures/make/build.sh", "");  // it has been built
  fs::create_directory_symlink(ROTOR_BUILD, folder_ / "build");
  const auto [status, output] = make("install PREFIX=\"$PWD/a folder\"");
  ASSERT_EQ(output, (folder_ / "a folder/bin/rotor\n").string());
  fs::rename(folder_ / "a folder", folder_ / "it is here");
  const std::string share = "'it is here/share/rotor/figures/", mine = "'it is here/bin/rotor' ";
  write("own.toml", "[parameters]\nmass = 4\nstart_speed_Hz = 150\nuntil = 1e-3\n");
  const std::vector<std::pair<std::string, std::string>> commands = {
      {mine + "run own.toml --json", "paper/fig08.toml"},
      {mine + "run " + share + "paper/fig13.toml' --json", "paper/fig08.toml"},
      {mine + "figure 14 --out . --equations corrected", "paper/fig14.toml"},
      {mine + "plot own.toml", "program/plot.gp"},
      {share + "draw.sh' fig14.svg \"data_corrected = 'fig14.csv'\" " + share + "paper/fig14.gp'",
       "../reference-data/printed-inputs.csv"}};
  for (const auto& [command, needed] : commands) {
    const auto [failed, errors] = shell(command + " >out");
    EXPECT_EQ(failed, 0) << command << content("out");
    EXPECT_FALSE(has(errors, "warning"));  // as without the paper's data
  }
  for (const char* picture : {"own.svg", "fig14.svg"})
    EXPECT_TRUE(has(content(picture), "</svg>")) << picture;
  for (const auto& [command, needed] : commands) {
    fs::remove(folder_ / "it is here/share/rotor/figures" / needed);
    EXPECT_EQ(shell(command + " >out").status == 0, command.find(" run ") != std::string::npos)
        << command;
  }
}

// The installed model builds the example of model/README.md, which prints the same.
TEST_F(Make, InstallsALibraryWithWhichTheExampleIsBuilt) {
  ASSERT_EQ(shell("cmake --install '" ROTOR_BUILD "' --prefix here >log").status, 0);
  fs::rename(folder_ / "here", folder_ / "it is here");
  for (const char* name : {"share/doc/rotor/LICENSE", "share/rotor/examples/my-rotor.toml"})
    EXPECT_TRUE(fs::exists(folder_ / "it is here" / name)) << name;
  EXPECT_EQ(
      shell("'it is here/bin/rotor' run 'it is here/share/rotor/examples/my-rotor.toml'").status,
      0);
  write("CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.25)\nproject(mine CXX)\nfind_package(rotor 1 REQUIRED)\n"
        "add_executable(accident \"it is here/share/rotor/examples/accident.cpp\")\n"
        "target_link_libraries(accident PRIVATE rotor::model)\n");
  const auto [status, output] = shell(
      "cmake -B made -G Ninja -DCMAKE_PREFIX_PATH=\"$PWD/it is here\" >log 2>&1 && "
      "ninja -C made >>log && made/accident");
  EXPECT_EQ(status, 0) << content("log");
  EXPECT_EQ(output, shell("'" ROTOR_EXAMPLE "'").output);
}

// Where a test fails or crashes, or none runs, tests.sh returns an error.
TEST_F(Make, SaysThatTestsHaveFailed) {
  const std::string run = "'" ROTOR_SOURCES "/verification/tests.sh' fake verification";
  fs::create_directories(folder_ / "fake");
  const std::string empty = "echo '{\"testsuites\": []}' > ${2#--gtest_output=json:}\n",
                    writes = "echo '\"result\": \"COMPLETED\"' > ${2#--gtest_output=json:}\n";
  for (const auto& [text, fails] : {std::pair(writes, false),
                                    {writes + "exit 1\n", true},
                                    {empty, true},
                                    {"kill -SEGV $$\n", true},
                                    {"exit 0\n", true}}) {
    program("fake/verification", text);
    EXPECT_EQ(shell(run).status != 0, fails) << text;
    const bool crashed = text.find("json") == std::string::npos;
    EXPECT_EQ(content("fake/report/tests-0.json").find("failures") != std::string::npos, crashed);
  }
}

}  // namespace
}  // namespace rotor
