# SPDX-License-Identifier: MIT
# Highway as a static library (libraries.sh), with the headers of the system. The definition is that of the shared
# library, so that ccache finds objects of other builds.
if(NOT TARGET hwy::hwy)
  add_library(hwy::hwy STATIC IMPORTED)
  set_target_properties(hwy::hwy PROPERTIES IMPORTED_LOCATION ${SHD_WHEEL_LIBRARIES}/libhwy.a
                        INTERFACE_COMPILE_DEFINITIONS HWY_SHARED_DEFINE)
endif()
