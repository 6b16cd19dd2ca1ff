# The libraries for a browser: all are headers, those of this machine. Their own CMake packages are
# for its processor.
find_path(headers nlohmann/json.hpp PATHS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)
find_path(eigen_headers Eigen/Core PATHS ${headers}/eigen3 NO_CMAKE_FIND_ROOT_PATH REQUIRED)
# The browser's own C library comes first.
set(CMAKE_INCLUDE_SYSTEM_FLAG_CXX "-idirafter ")
foreach(library Boost::headers Eigen3::Eigen fmt::fmt-header-only nlohmann_json::nlohmann_json)
  add_library(${library} INTERFACE IMPORTED)
  target_include_directories(${library} INTERFACE ${headers} ${eigen_headers})
endforeach()
target_compile_definitions(fmt::fmt-header-only INTERFACE FMT_HEADER_ONLY)
