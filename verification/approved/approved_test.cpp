/// The texts of the program and of make that people read, as approved in the .txt files of this
/// folder: commands after "$ " (continued after "> "), and below each its output, with the status
/// if that is not 0. `make approve` rewrites them; a person reads the diff. Numbers are not
/// approved: `numbers` blanks computed ones.
#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "verification/support/command_line.hpp"
#include "verification/support/content.hpp"
#include "verification/support/pattern.hpp"

namespace rotor {
namespace {

const fs::path approved = ROTOR_SOURCES "/verification/approved";

class Approved : public CommandLine, public testing::WithParamInterface<std::string> {
 protected:
  /// The transcript with what its commands print now.
  std::string transcript(const std::string& text) const {
    std::string now, command;
    const auto run = [&] {
      if (command.empty()) return;
      const auto [status, output] = shell("sources='" ROTOR_SOURCES "' build='" ROTOR_BUILD
                                          "'\n. \"$sources/verification/approved/commands.sh\"\n" +
                                          command);
      const std::string sources =
          replaced(ROTOR_SOURCES, R"([.+(){}])", R"(\$&)");  // make refuses other such letters
      now += replaced(output, "(^|[^\\w.])" + sources, "$1(sources)");
      if (!output.empty() && !output.ends_with('\n')) now += "\n(without a newline)\n";
      if (status != 0) now += fmt::format("(status {})\n", status);
      now += '\n';
      command.clear();
    };
    enum { heading, in_command, in_output } place = heading;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("$ ")) {
        run();
        place = in_command;
      } else if (place == in_command && !line.starts_with("> ")) {
        place = in_output;
      }
      if (place == in_command) command += line.substr(2) + '\n';
      if (place != in_output) now += line + '\n';
    }
    run();
    return now;
  }
};

TEST_P(Approved, IsWhatIsPrinted) {
  const fs::path file = approved / (GetParam() + ".txt");
  const std::string before = content_of(file), now = transcript(before);
  if (std::getenv("ROTOR_APPROVE"))
    std::ofstream(file, std::ios::binary) << now;
  else if (now != before)
    FAIL() << shell(fmt::format("diff -u '{}' - <<'END_OF_TRANSCRIPT'\n{}END_OF_TRANSCRIPT\n",
                                file.string(), now))
                  .output
           << "If this is as it should be: make approve";
}

std::vector<std::string> transcripts() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(approved))
    if (entry.path().extension() == ".txt") names.push_back(entry.path().stem());
  std::ranges::sort(names);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Transcripts, Approved, testing::ValuesIn(transcripts()),
                         [](const auto& of) { return of.param; });

}  // namespace
}  // namespace rotor
