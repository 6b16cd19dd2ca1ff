/// Tests of what the READMEs say.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "verification/support/markdown_table.hpp"
#include "verification/support/run_summary.hpp"

namespace rotor {

class Readme : public RunSummary {
 protected:
  static std::vector<Cells> table(const std::string& heading,
                                  const std::string& readme = "README.md") {
    std::ifstream file(ROTOR_SOURCES "/" + readme);
    return markdown_table({std::istreambuf_iterator<char>(file), {}}, heading);
  }

  /// Its words, with single blanks between them.
  static std::string text() {
    std::ifstream file(ROTOR_SOURCES "/README.md");
    std::string all;
    for (std::string word; file >> word;) all += word + ' ';
    return all;
  }
  static void expect_said(const std::string& sentence) {
    EXPECT_NE(text().find(sentence), std::string::npos) << "does not say: " << sentence;
  }
};

}  // namespace rotor
