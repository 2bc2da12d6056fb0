# SPDX-License-Identifier: MIT
# meshoptimizer as a static library (libraries.sh), with the header of the system.
if(NOT TARGET meshoptimizer::meshoptimizer)
  add_library(meshoptimizer::meshoptimizer STATIC IMPORTED)
  set_target_properties(meshoptimizer::meshoptimizer PROPERTIES
                        IMPORTED_LOCATION ${SHD_WHEEL_LIBRARIES}/libmeshoptimizer.a)
endif()
