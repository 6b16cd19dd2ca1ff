/// Tests of the program as its users see it.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "figures/results/json.hpp"

namespace rotor {

namespace fs = std::filesystem;

/// Whether a text has a part. A failure shows both.
inline testing::AssertionResult has(std::string_view text, std::string_view part) {
  return testing::AssertionResult(text.find(part) != text.npos) << part << " in: " << text;
}

/// A value of a summary as the cell of a table has it.
inline std::string cell_of(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_array()) {
    std::string all;
    for (const Json& item : value) all += (all.empty() ? "" : "; ") + item.get<std::string>();
    return all;
  }
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// A folder for each test, removed afterwards.
class CommandLine : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        fs::absolute(fs::temp_directory_path()) / ("rotor-test-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    fs::create_symlink(ROTOR_PROGRAM, program());
  }
  void TearDown() override {
    fs::remove_all(folder_);
    fs::remove(program());
  }

  fs::path write(std::string_view name, std::string_view content) const {
    std::ofstream(folder_ / name) << content;
    return folder_ / name;
  }

  struct Outcome {
    int status;
    std::string output;
  };

  /// Runs a shell command in the folder; $rotor is the program. The output includes standard error.
  Outcome shell(const std::string& command) const {
    const std::string whole =
        "cd '" + folder_.string() + "' && rotor='" + program() + "' && { " + command + "\n} 2>&1";
    std::signal(SIGHUP, SIG_DFL);  // ignored if nohup started the tests
    FILE* pipe = ::popen(whole.c_str(), "r");
    std::string output;
    std::array<char, 4096> buffer{};
    while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), pipe))
      output.append(buffer.data(), size);
    const int status = ::pclose(pipe);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output};
  }

  Outcome rotor(const std::string& arguments) const { return shell("$rotor " + arguments); }

  /// What `rotor run --json` prints.
  Json summary(const std::string& arguments) const {
    const Outcome outcome = rotor("run --json " + arguments + " 2>messages");
    EXPECT_EQ(outcome.status, 0) << arguments << ": " << content("messages");
    return outcome.status == 0 ? Json::parse(outcome.output) : Json();
  }

  /// The content of a file in the folder.
  std::string content(std::string_view name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// Of a CSV in the folder: the header row, then the data.
  std::vector<std::string> rows_of(std::string_view name) const {
    std::ifstream file(folder_ / name);
    std::vector<std::string> rows;
    for (std::string line; std::getline(file, line);)
      if (!line.starts_with('#')) rows.push_back(line);
    return rows;
  }

  /// How many files the folder holds, hidden ones included.
  long files() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  void expect_refusal(const std::string& arguments, std::string_view message) const {
    const long before = files();
    const auto [status, output] = rotor(arguments);
    EXPECT_GT(status, 0) << arguments;
    EXPECT_TRUE(has(output, message)) << arguments;
    EXPECT_TRUE(output.starts_with("rotor: ")) << output;
    EXPECT_LT(output.size(), 700U) << output;  // one line, however long the input
    EXPECT_EQ(output.find('\n'), output.size() - 1) << output;
    EXPECT_EQ(files(), before) << arguments;
  }

  fs::path folder_;

 private:
  /// A path to the program without blanks, wherever the checkout lies.
  std::string program() const { return folder_.string() + ".program"; }
};

}  // namespace rotor
