/// Failed targets must not pass as made.

#include "verification/support/command_line.hpp"
#include "verification/support/content.hpp"

namespace rotor {
namespace {

class Make : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    fs::create_directories(folder_ / "figures/paper");
    for (const char* file : {"Makefile", "figures/draw.sh"})
      fs::copy_file(fs::path(ROTOR_SOURCES) / file, folder_ / file);
    write("figures/paper/fig18.toml", "");
  }

  void program(const std::string& file, const std::string& text) const {
    write(file, "#!/bin/sh\n" + text);
    fs::permissions(folder_ / file, fs::perms::owner_all);
  }

  /// With nothing of the make that runs the tests, and with the folder's own programs first.
  Outcome make(const std::string& arguments, const std::string& variables = "") const {
    return shell("env -i PATH=\"$PWD/bin:$PATH\" " + variables + " make " + arguments);
  }
};

// Removed and damaged data are written again, others are left alone; an incomplete picture is
// removed.
TEST_F(Make, MakesAnewWhatHasBeenRemovedAndKeepsNoHalfPicture) {
  fs::create_directories(folder_ / "build/figures");
  fs::create_directories(folder_ / "bin");
  // Both programs run while another make makes the same figure.
  const std::string another =
      "[ -n \"$ANOTHER\" ] || ANOTHER=1 make -o build -o build/rotor fig18 || exit 1\n";
  program("build/rotor", another + "echo data | tee $3/fig18.csv > $3/fig18.var\n");
  write("figures/paper/fig18.gp", "");
  write("figures/paper/style.gp", "");
  const auto make_figure = [&](const std::string& end, const std::string& format = "svg") {
    program("bin/gnuplot", "part=$(expr \"$3\" : \"output = '\\([^']*\\)'\")\necho '<svg>" + end +
                               "' > $part\n" + another);
    return make("-o build -o build/rotor fig18 FORMAT=" + format);
  };
  EXPECT_EQ(make_figure("IEND\xae\x42\x60\x82", "png").status, 0);
  EXPECT_EQ(make_figure("%%EOF", "pdf").status, 0);
  EXPECT_EQ(make_figure("</svg>").status, 0);
  for (const char* removed :
       {"build/figures/published/fig18.csv", "build/figures/corrected/fig18.csv",
        "build/figures/corrected/fig18.var", "build/figures/fig18.svg"}) {
    ASSERT_TRUE(fs::remove(folder_ / removed));
    EXPECT_EQ(make_figure("</svg>").status, 0) << removed;
    EXPECT_TRUE(fs::exists(folder_ / removed));
  }
  write("build/figures/published/fig18.csv", "da");
  EXPECT_EQ(make_figure("</svg>").status, 0);
  EXPECT_EQ(content("build/figures/published/fig18.csv"), "data\n");
  fs::remove(folder_ / "build/figures/fig18.svg");
  const auto [status, output] = make_figure("");
  EXPECT_NE(status, 0);
  EXPECT_TRUE(has(output, "fig18.svg: gnuplot did not draw the whole picture"));
  EXPECT_FALSE(fs::exists(folder_ / "build/figures/fig18.svg"));
  EXPECT_FALSE(fs::exists(folder_ / "build/figures/fig18.svg.part"));
}

// Only what stands on the command line decides which tests run, and how.
TEST_F(Make, HeedsNothingThatIsExported) {
  for (const char* folder : {"bin", "build/sanitize", "verification"})
    fs::create_directories(folder_ / folder);
  fs::copy_file(ROTOR_SOURCES "/verification/tests.sh", folder_ / "verification/tests.sh");
  program("bin/cmake", "");
  program("build/sanitize/verification",
          "echo $1 $GTEST_FILTER $ROTOR_APPROVE $CXX > seen\n"
          "echo '\"result\": \"COMPLETED\"' > ${2#--gtest_output=json:}\n");
  for (const auto& [option, filter] : {std::pair("", "*"), {"TESTS='-A b'", "-A b"}}) {
    const auto [status, output] = make(std::string("-o need-deps sanitize ") + option,
                                       "GTEST_FILTER=None ROTOR_APPROVE=1 CXX=none TESTS=None");
    EXPECT_EQ(status, 0) << output;
    EXPECT_EQ(content("seen"), std::string("--gtest_filter=") + filter + '\n');
  }
}

TEST_F(Make, RefusesFlagsThatChangeTheArithmetic) {
  for (const char* flag : {"-ffast-math", "-Ofast"}) {
    const auto [status, output] = shell(std::string("CXXFLAGS='-g ") + flag +
                                        "' cmake -S '" ROTOR_SOURCES "' -B made -G Ninja");
    EXPECT_NE(status, 0);
    EXPECT_TRUE(has(output, std::string("CXXFLAGS with ") + flag));
    fs::remove_all(folder_ / "made");
  }
}

// The model needs none of the program's libraries, builds nothing but itself, and brings its C++20.
TEST_F(Make, BuildsTheModelAloneInAnotherProject) {
  const std::string readme = content_of(ROTOR_SOURCES "/model/README.md");
  const auto block = [&](const std::string& language) {
    const std::size_t start = readme.find("```" + language + '\n') + language.size() + 4;
    return readme.substr(start, readme.find("```", start) - start);
  };
  write("accident.cpp", block("cpp"));
  write("CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.25)\nproject(mine CXX)\n" + block("cmake"));
  shell("ln -s '" ROTOR_SOURCES "' rotor");
  for (const std::string standard : {"", "-DCMAKE_CXX_STANDARD=17"}) {
    const auto [status, output] =
        shell("cmake -B made -G Ninja -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON " + standard +
              " >log 2>&1 && ninja -C made CMakeFiles/accident.dir/accident.cpp.o >>log && "
              "ninja -C made -t commands | grep -o ' -o [^ ]*[.]dir/' | sort -u");
    EXPECT_EQ(output, " -o CMakeFiles/accident.dir/\n -o rotor/CMakeFiles/model.dir/\n")
        << standard << status << content("log");
  }
  const std::string printed = shell("'" ROTOR_EXAMPLE "'").output;
  EXPECT_TRUE(has(readme, '`' + printed.substr(0, printed.size() - 1) + '`')) << printed;
}

// Moved anywhere, the installed program finds its scenes and scripts: without them it does nothing.
TEST_F(Make, InstallsAProgramThatCanBeMoved) {
  fs::create_directory_symlink(fs::path(ROTOR_PROGRAM).parent_path(), folder_ / "build");
  const auto [status, output] = make("-o build install PREFIX=\"$PWD/a folder\"");
  ASSERT_EQ(output, (folder_ / "a folder/bin/rotor\n").string());
  fs::rename(folder_ / "a folder", folder_ / "it is here");
  const std::string share = "'it is here/share/rotor/figures/", mine = "'it is here/bin/rotor' ";
  write("own.toml", "[parameters]\nmass = 4\nstart_speed_hz = 150\nuntil = 1e-3\n");
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
