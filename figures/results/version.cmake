# Writes version.cpp if version() has changed: the NUMBER, and what git says of the SOURCES. In an archive git
# has filled in the texts between dollar signs (.gitattributes).
cmake_minimum_required(VERSION 3.25)
set(commit "$Format:%(describe:tags)$" "$Format:%h$")
if(commit MATCHES "Format:")
  execute_process(COMMAND git --git-dir=.git --no-optional-locks describe --tags --always --dirty
    WORKING_DIRECTORY ${SOURCES} OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
list(APPEND commit "unknown commit")
list(REMOVE_ITEM commit "")
list(GET commit 0 commit)
file(CONFIGURE OUTPUT version.cpp CONTENT [[
#include "figures/results/version.hpp"
std::string_view rotor::version() { return "@NUMBER@ (@commit@)"; }
]] @ONLY)
