#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# libraries.sh FOLDER: makes the libraries with which shd.wasm reads files of images and models, and headers, files of
# pkg-config and packages of CMake that name them: for modules of one thread in FOLDER/one, with threads in
# FOLDER/threads. They are built from Debian's sources. CMake is given the folder by SHD_WASM_LIBRARIES.
# Exit code 77: Emscripten or the sources are absent.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../../src/packaging/debian_sources.sh"
mkdir -p "$1"
cd "$1"
folder=$PWD
jobs=${JOBS:-$(nproc)}
if [ -e one/complete ] && [ -e threads/complete ]; then exit 0; fi
command -v emcc > /dev/null || skip "emcc is not installed (Debian: emscripten)"
[ -e /usr/include/nlohmann/json.hpp ] || skip "nlohmann-json is not installed (Debian: nlohmann-json3-dev)"
export CFLAGS=-sSUPPORT_LONGJMP=wasm  # as exceptions, of which longjmp() then is one
export CXXFLAGS="-Wno-error=unused-variable -Wno-error=unused-function"  # meshoptimizer has -Werror
list_sources
zlib=$folder/$(fetch zlib1g-dev zlib zlib)
mkdir -p "$zlib/win32"
touch "$zlib/win32/zlib1.rc"  # zlib's CMakeLists.txt names it; Debian's sources lack it, and only Windows needs it
zstd=$folder/$(fetch libzstd-dev libzstd zstd)
png=$folder/$(fetch libpng-dev libpng1.6 png)
jpeg=$folder/$(fetch libjpeg62-turbo-dev libjpeg-turbo jpeg)
mesh=$folder/$(fetch libmeshoptimizer-dev meshoptimizer mesh)

# module, library, modules that it needs: a file of pkg-config
describe() {
  printf '%s\n' "Name: $1" "Description: $1" "Version: 1" "Requires: ${3:-}" "Cflags: -I$PWD/include" \
    "Libs: -L$PWD -l$2" > "pkgconfig/$1.pc"
}
# package, target, library or nothing: a package of CMake
package() {
  printf '%s\n' "if(NOT TARGET $2)" "  add_library($2 INTERFACE IMPORTED)" \
    "  set_target_properties($2 PROPERTIES INTERFACE_INCLUDE_DIRECTORIES \"$PWD/include\"" \
    "                        INTERFACE_LINK_LIBRARIES \"${3:-}\")" "endif()" > "cmake/$1Config.cmake"
}
# folder, option of the toolchain: all libraries of a module
make_libraries() {
  mkdir -p "$folder/$1"/{include,pkgconfig,cmake}
  cd "$folder/$1"
  build_options=(-DCMAKE_TOOLCHAIN_FILE="$here/wasm.cmake" -DSHD_WASM_THREADS="$2"
                 -DCMAKE_C_COMPILER_LAUNCHER="${LAUNCHER:-}" -DCMAKE_CXX_COMPILER_LAUNCHER="${LAUNCHER:-}")
  build "$zlib" zlibstatic z
  cp build/zlibstatic/zconf.h "$zlib/zlib.h" include
  build "$zstd/build/cmake" libzstd_static zstd -DZSTD_BUILD_PROGRAMS=OFF -DZSTD_BUILD_SHARED=OFF \
    -DZSTD_MULTITHREAD_SUPPORT=OFF
  cp "$zstd"/lib/{zstd.h,zstd_errors.h} include
  build "$png" png_static png16 -DPNG_SHARED=OFF -DPNG_TESTS=OFF -DPNG_HARDWARE_OPTIMIZATIONS=OFF \
    -DZLIB_LIBRARY="$PWD/libz.a" -DZLIB_INCLUDE_DIR="$PWD/include"
  cp "$png"/{png.h,pngconf.h} build/png_static/pnglibconf.h include
  build "$jpeg" jpeg-static jpeg -DENABLE_SHARED=OFF -DWITH_TURBOJPEG=OFF -DWITH_JPEG7=OFF -DWITH_SIMD=OFF \
    -DHAVE_SIZE_T=TRUE -DSIZE_T=4  # CMake does not find the size, because Emscripten's programs are files of JavaScript
  cp "$jpeg"/{jpeglib.h,jmorecfg.h,jerror.h} build/jpeg-static/jconfig.h include
  build "$mesh" meshoptimizer meshoptimizer
  cp "$mesh/src/meshoptimizer.h" include
  cp -r /usr/include/nlohmann include
  describe zlib z
  describe libzstd zstd
  describe libpng png16 zlib
  describe libjpeg jpeg
  package meshoptimizer meshoptimizer::meshoptimizer "$PWD/libmeshoptimizer.a"
  package nlohmann_json nlohmann_json::nlohmann_json
  touch complete
}
make_libraries one OFF
make_libraries threads ON
rm -rf "$folder"/{one,threads}/build
