/// Every marked number in a Markdown file is the computed one; `make approve` writes them.
#include "verification/report/marked_numbers.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace rotor {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> markdown_files() {
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator at(ROTOR_SOURCES), end; at != end; ++at) {
    const std::string name = at->path().filename();
    if (at->is_directory() && (name.starts_with('.') || name.starts_with("build")))
      at.disable_recursion_pending();
    else if (at->path().extension() == ".md")
      files.push_back(at->path());
  }
  return files;
}

TEST(MarkedNumbers, ArePutBetweenTheirMarks) {
  const Json values = {{"peak", {{"kN", 454.836}}}, {"says", "holds, 3 of 3"}};
  EXPECT_EQ(
      with_marked_numbers("| <!--peak.kN.f1-->?<!----> kN | <!--says--><!----> | <!--x-->", values),
      "| <!--peak.kN.f1-->454.8<!----> kN | <!--says-->holds, 3 of 3<!----> | <!--x-->");
  EXPECT_THROW(with_marked_numbers("<!--peak.MN.f1-->0.5<!---->", values), std::invalid_argument);
}

TEST(ApprovedNumbers, OfMarkdownAreThoseThatAreComputed) {
  const Json values = markable_values(judged(), ROTOR_REFERENCE_DATA);
  for (const fs::path& file : markdown_files()) {
    const std::string before = content_of(file), now = with_marked_numbers(before, values);
    if (std::getenv("ROTOR_APPROVE") && now != before)
      std::ofstream(file, std::ios::binary) << now;
    else
      EXPECT_EQ(before, now) << file << "\nIf this is as it should be: make approve";
  }
}

}  // namespace
}  // namespace rotor
