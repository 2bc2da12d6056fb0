# SPDX-License-Identifier: MIT
# Debian packages by CPack: one per library with the name of its soname, libshd-dev, libshd-doc, shd-tools and
# python3-shd. README.md of this folder has the commands. deb/finish.sh completes each package with what CPack does not write.
set(SHD_MAINTAINER "The shd authors <shd@shd.invalid>" CACHE STRING "Maintainer of the Debian packages")

if(NOT SHD_BUILD_SHARED)
  message(FATAL_ERROR "SHD_BUILD_SHARED is OFF; the Debian packages are of shared libraries")
elseif(NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  message(FATAL_ERROR "CMAKE_INSTALL_PREFIX is ${CMAKE_INSTALL_PREFIX}; the prefix of Debian packages is /usr")
elseif(NOT CMAKE_SKIP_INSTALL_RPATH)
  message(FATAL_ERROR "CMAKE_SKIP_INSTALL_RPATH is OFF; files of Debian packages have no search path")
endif()

set(soname_version ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "${SHD_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # the descriptions below have a summary of their own
set(CPACK_STRIP_FILES OFF)  # deb/finish.sh strips, and keeps the debug information
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SOURCE shd)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/src)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_POST_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/deb/finish.cmake)
set(CPACK_SHD_FINISH "${CMAKE_CURRENT_LIST_DIR}/deb/finish.sh")
set(CPACK_COMPONENTS_ALL "")

# component, package, section, description (the summary, then lines of text); then the components it depends on
macro(shd_deb component package section description)
  string(TOUPPER ${component} upper)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${description}")
  set(CPACK_COMPONENT_${upper}_DEPENDS ${ARGN})
endmacro()

# The text that all of the packages share.
set(about "shd filters textures, shades surfaces and rasterises triangles on the CPU.
It needs no window system, driver or global state, and gives the same bits
for every SIMD instruction set and number of threads.
")

set(libraries ${shd_targets})
shd_deb(shd libshd${soname_version} libs "texture filtering and software rasterisation on the CPU
${about}
This package has the shared library.")
if(TARGET shd_color)
  shd_deb(shd_color libshd-color${soname_version} libs "colour management for shd, by OpenColorIO
${about}
This package has libshd_color. It converts scene-linear pixels to displays
and views of OpenColorIO." shd)
endif()
if(TARGET shd_io)
  shd_deb(shd_io libshd-io${soname_version} libs "image and volume files for shd, by OpenImageIO
${about}
This package has libshd_io. It loads and saves images, textures and volumes.
Files can be decoded in a process of its own." shd)
endif()
if(TARGET shd_scene)
  shd_deb(shd_scene libshd-scene${soname_version} libs "model files for shd
${about}
This package has libshd_scene. It loads meshes, materials, lights and
cameras from files of models, each in a process of its own." shd_io shd)
endif()
if(TARGET shd_embree)
  shd_deb(shd_embree libshd-embree${soname_version} libs "ray tracer for shd, by Embree
${about}
This package has libshd_embree. It finds the occluders of ambient occlusion
with Embree." shd)
endif()
shd_deb(dev libshd-dev libdevel "texture filtering and software rasterisation on the CPU (development)
${about}
This package has the headers for C and C++, and files for CMake and
pkg-config." ${libraries})
shd_deb(doc libshd-doc doc "texture filtering and software rasterisation on the CPU (manual)
${about}
This package has the manual and the sources of the examples.")
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)
if(SHD_BUILD_TOOLS)
  shd_deb(tools shd-tools graphics "renderer of model files and tools for textures on the CPU
${about}
This package has shd-render, which renders a picture of a model file with
lights, shadows, environments and volumes; shd-check, which judges texture
lookups; and shd-maketx, which makes tiled files with mip levels." ${libraries})
endif()
# The Python package needs only libshd; its modules shd.io, shd.scene and others load the components when they are used.
execute_process(COMMAND /usr/bin/python3 -c "import setuptools, pip, wheel" RESULT_VARIABLE no_pip OUTPUT_QUIET ERROR_QUIET)
if(no_pip)
  message(STATUS "python3-shd is not packaged (Debian: python3-pip python3-setuptools python3-wheel)")
else()
  set(python_dir ${PROJECT_BINARY_DIR}/dist-packages)
  add_custom_target(shd_deb_python ALL COMMAND ${CMAKE_CURRENT_LIST_DIR}/deb/python.sh ${python_dir} VERBATIM)
  install(DIRECTORY ${python_dir}/ DESTINATION lib/python3/dist-packages COMPONENT python)
  shd_deb(python python3-shd python "texture filtering and software rasterisation on the CPU (Python)
${about}
This package has the Python module, which works on arrays of NumPy." shd)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS OFF)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3:any, python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS
      "libshd-color${soname_version}, libshd-io${soname_version}, libshd-scene${soname_version}")
endif()
include(CPack)
