# SPDX-License-Identifier: MIT
# Draco as the static library of the system, which fits into shared libraries.
find_library(SHD_WHEEL_DRACO libdraco.a REQUIRED)
if(NOT TARGET draco::draco)
  add_library(draco::draco STATIC IMPORTED)
  set_target_properties(draco::draco PROPERTIES IMPORTED_LOCATION ${SHD_WHEEL_DRACO})
endif()
