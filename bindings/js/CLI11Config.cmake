# SPDX-License-Identifier: MIT
# The headers of CLI11 of this machine, linked into the build folder, because the folder they lie in also has this
# machine's C library.
find_path(SHD_CLI11_INCLUDE_DIR CLI/CLI.hpp HINTS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH)
if(NOT SHD_CLI11_INCLUDE_DIR)
  set(CLI11_FOUND FALSE)
  return()
endif()
set(shd_cli11_headers ${CMAKE_BINARY_DIR}/cli11-headers)
file(MAKE_DIRECTORY ${shd_cli11_headers})
file(CREATE_LINK ${SHD_CLI11_INCLUDE_DIR}/CLI ${shd_cli11_headers}/CLI SYMBOLIC)
add_library(CLI11::CLI11 INTERFACE IMPORTED)
set_target_properties(CLI11::CLI11 PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${shd_cli11_headers})
