# SPDX-License-Identifier: MIT
# Highway as headers alone, which a library with one SIMD target needs: the headers of this machine's package do for
# every processor, its compiled library does not. They are linked into the build folder, because the folder they lie in
# also has this machine's C library.
find_path(SHD_HWY_INCLUDE_DIR hwy/highway.h HINTS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH)
if(NOT SHD_HWY_INCLUDE_DIR)
  set(hwy_FOUND FALSE)
  set(hwy_NOT_FOUND_MESSAGE "hwy/highway.h was not found (Debian: libhwy-dev)")
  return()
endif()
set(shd_hwy_headers ${CMAKE_BINARY_DIR}/hwy-headers)
file(MAKE_DIRECTORY ${shd_hwy_headers})
file(CREATE_LINK ${SHD_HWY_INCLUDE_DIR}/hwy ${shd_hwy_headers}/hwy SYMBOLIC)
add_library(hwy::hwy INTERFACE IMPORTED)
set_target_properties(hwy::hwy PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${shd_hwy_headers})
