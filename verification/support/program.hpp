/// Common parts of the programs of the verification.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "figures/data/files.hpp"

namespace rotor {

using Arguments = std::vector<std::string>;

/// The status of a program. An exception is reported on standard error, and gives 1.
inline int run_program(const char* name, int (*program)(const Arguments&), int argc, char** argv) {
  try {
    return program({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", name, error.what());
    return 1;
  }
}

/// The whole of a file, or nothing.
inline void write_file(const std::filesystem::path& file, std::string_view text) {
  FileTransaction files;
  files.write(file, text);
  files.commit();
}

}  // namespace rotor
