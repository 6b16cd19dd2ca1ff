/// Files that `make approve` writes, and a person reads in the diff.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

#include "verification/support/content.hpp"

namespace rotor {

inline void expect_approved(const std::string& file, const std::string& text) {
  const std::filesystem::path path = std::filesystem::path(ROTOR_SOURCES) / file;
  if (std::getenv("ROTOR_APPROVE")) std::ofstream(path, std::ios::binary) << text;
  EXPECT_EQ(content_of(path), text) << file << "\nIf this is as it should be: make approve";
}

}  // namespace rotor
