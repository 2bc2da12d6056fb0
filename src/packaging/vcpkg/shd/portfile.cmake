# SPDX-License-Identifier: MIT
# The checksum of the archive is known when the version is released; vcpkg prints it if it is 0.
vcpkg_from_github(
  OUT_SOURCE_PATH SOURCE_PATH
  REPO shd/shd
  REF "v${VERSION}"
  SHA512 0
  HEAD_REF main
)

vcpkg_check_features(
  OUT_FEATURE_OPTIONS FEATURE_OPTIONS
  FEATURES
    color SHD_WITH_OCIO
    io    SHD_WITH_IO
    scene SHD_WITH_SCENE
    tbb   SHD_WITH_TBB
)

# OpenColorIO, OpenImageIO and assimp are found by pkg-config.
vcpkg_find_acquire_program(PKGCONFIG)

# libexec/shd is tools/shd in vcpkg: the program that decodes files in a process of its own.
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    ${FEATURE_OPTIONS}
    "-DPKG_CONFIG_EXECUTABLE=${PKGCONFIG}"
    -DCMAKE_INSTALL_LIBEXECDIR=tools
    -DSHD_WITH_EIGEN=OFF
    -DSHD_WITH_EMBREE=OFF
    -DSHD_WITH_OPENVDB=OFF
    -DSHD_WITH_ZSTD=OFF
    -DSHD_WITH_ZLIB=OFF
    -DSHD_WITH_ASTCENC=OFF
    -DSHD_BUILD_EXAMPLES=OFF
    -DSHD_BUILD_TESTS=OFF
    -DSHD_BUILD_TOOLS=OFF
  MAYBE_UNUSED_VARIABLES
    PKG_CONFIG_EXECUTABLE
)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/shd)
vcpkg_fixup_pkgconfig()

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
