# SPDX-License-Identifier: MIT
# Install rules: libraries, headers, find_package(shd COMPONENTS color io scene embree), pkg-config files, documents.
include(CMakePackageConfigHelpers)

set(cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/shd)

# One export file per component, so that a component's absent dependency does not break the others. The components of
# install() are the packages of packaging/ShdDeb.cmake: one per library, and dev, doc and tools.
foreach(target IN LISTS shd_targets)
  install(TARGETS ${target} EXPORT ${target}Targets FILE_SET HEADERS COMPONENT dev
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${target} NAMELINK_COMPONENT dev
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
          RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${target}
          INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT ${target}Targets NAMESPACE shd:: DESTINATION ${cmake_dir} COMPONENT dev)
endforeach()

configure_package_config_file(${PROJECT_SOURCE_DIR}/src/shdConfig.cmake.in ${PROJECT_BINARY_DIR}/shdConfig.cmake
                              INSTALL_DESTINATION ${cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/shdConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/shdConfig.cmake ${PROJECT_BINARY_DIR}/shdConfigVersion.cmake
        DESTINATION ${cmake_dir} COMPONENT dev)

# gdb loads this file together with the library of the same name.
if(SHD_BUILD_SHARED AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
  install(FILES ${PROJECT_SOURCE_DIR}/src/packaging/gdb/libshd-gdb.py RENAME $<TARGET_FILE_NAME:shd>-gdb.py
          DESTINATION ${CMAKE_INSTALL_DATADIR}/gdb/auto-load${CMAKE_INSTALL_FULL_LIBDIR} COMPONENT dev)
endif()

# The .pc files find their prefix from where they lie, so that `cmake --install --prefix` and moved trees work.
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  set(PC_PREFIX ${CMAKE_INSTALL_PREFIX})
else()
  file(RELATIVE_PATH pc_up "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/prefix")
  string(REGEX REPLACE "/$" "" pc_up ${pc_up})
  string(CONCAT PC_PREFIX "\${pcfiledir}/" "${pc_up}")
endif()

# name, description, what a static link needs besides, what a shared link needs besides, and libraries of a static link
# without a pkg-config file. The file of a shared library
# names nothing private: pkg-config would look for those packages on every machine that compiles against the library.
function(shd_pkg_config name description private_requires requires)
  set(PC_NAME ${name})
  set(PC_DESCRIPTION ${description})
  set(PC_REQUIRES "${requires}")
  if(NOT SHD_BUILD_SHARED)
    # A static archive carries no dependencies of its own: name them for every link.
    string(JOIN " " PC_REQUIRES ${requires} ${private_requires})
    string(JOIN " " PC_LIBS_EXTRA "" ${ARGN} -lstdc++ -lm -pthread)
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/src/shd.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)
endfunction()

if(SHD_WITH_TBB)
  shd_pkg_config(shd "${PROJECT_DESCRIPTION}" "libhwy tbb" "")
else()
  shd_pkg_config(shd "${PROJECT_DESCRIPTION}" "libhwy" "")
endif()
if(SHD_WITH_OCIO)
  shd_pkg_config(shd_color "Colour management for shd through OpenColorIO" "OpenColorIO" "shd")
endif()
if(SHD_WITH_IO)
  set(io_libs "")
  if(shd_has_astcenc)
    set(io_libs -lastcenc)  # no pkg-config file
  endif()
  if(TARGET shd_openvdb)
    shd_pkg_config(shd_io "Image and volume files for shd" "${shd_picture_modules} tbb Imath ${shd_texture_modules}"
                   "shd" -lopenvdb ${io_libs})
  else()
    shd_pkg_config(shd_io "Image files for shd" "${shd_picture_modules} ${shd_texture_modules}" "shd" ${io_libs})
  endif()
endif()
if(SHD_WITH_SCENE)
  shd_pkg_config(shd_scene "Model files for shd" "" "shd_io shd")
endif()

if(TARGET shd_embree)
  # Embree has no pkg-config file: the line of a static link names its library.
  get_filename_component(embree_name ${SHD_EMBREE_LIBRARY} NAME_WE)
  string(REGEX REPLACE "^lib" "-l" shd_embree_libs ${embree_name})
  shd_pkg_config(shd_embree "Ray tracer for shd through Embree" "" "shd" ${shd_embree_libs})
endif()

# Licence, manual and examples. The links between them are those of the source tree.
set(doc_dir ${CMAKE_INSTALL_DATAROOTDIR}/doc/shd)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
        DESTINATION ${doc_dir} COMPONENT doc)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${doc_dir} COMPONENT doc
        FILES_MATCHING PATTERN "*.md" PATTERN "*.svg" PATTERN "cheatsheet.html" PATTERN "site" EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION ${doc_dir} COMPONENT doc
        FILES_MATCHING PATTERN "*.c" PATTERN "*.h" PATTERN "*.png" PATTERN "*.md")

if(SHD_DEB)
  include(${PROJECT_SOURCE_DIR}/src/packaging/ShdDeb.cmake)
endif()
