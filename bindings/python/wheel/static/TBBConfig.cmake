# SPDX-License-Identifier: MIT
# oneTBB as a static library (libraries.sh), with the headers of the system.
if(NOT TARGET TBB::tbb)
  add_library(TBB::tbb STATIC IMPORTED)
  set_target_properties(TBB::tbb PROPERTIES IMPORTED_LOCATION ${SHD_WHEEL_LIBRARIES}/libtbb.a
                        INTERFACE_LINK_LIBRARIES "Threads::Threads;${CMAKE_DL_LIBS}")
endif()
