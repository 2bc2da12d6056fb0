#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# libraries.sh FOLDER: makes glibc.o and static libraries, with which libshd, libshd_io and libshd_scene need no library
# besides glibc, and files of pkg-config that name them.
#
# Debian's static libraries of C code do not fit into shared libraries, and some libraries have none: they are built from
# Debian's sources.
# Exit code 77: the sources cannot be had.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../../../src/packaging/debian_sources.sh"
mkdir -p "$1"
cd "$1"
jobs=${JOBS:-$(nproc)}
for object in glibc start; do ${CC:-cc} -std=c99 -O2 -fPIC -Wall -Wextra -c "$here/$object.c" -o $object.o; done

# The headers are those of the system. Private needs of a library become needs of its users.
mkdir -p pkgconfig
for module in libpng zlib libzstd libjpeg; do
  file=$(pkg-config --variable=pcfiledir "$module")/$module.pc
  sed "s|^libdir=.*|libdir=$PWD|; s|^Requires.private:|Requires:|" "$file" > "pkgconfig/$module.pc"
done
libraries=(tbb hwy png16 z zstd jpeg meshoptimizer)
complete=1
for library in "${libraries[@]}"; do [ -e "lib$library.a" ] || complete=0; done
if [ "$complete" = 1 ]; then exit 0; fi

list_sources
build_options=(-DCMAKE_POSITION_INDEPENDENT_CODE=ON)
tbb=$(fetch libtbb-dev onetbb tbb)
build "$tbb" tbb tbb -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF -DTBB_DISABLE_HWLOC_AUTOMATIC_SEARCH=ON
hwy=$(fetch libhwy-dev highway hwy)
build "$hwy" hwy hwy -DBUILD_TESTING=OFF -DHWY_ENABLE_TESTS=OFF -DHWY_ENABLE_EXAMPLES=OFF -DHWY_ENABLE_CONTRIB=OFF
zlib=$(fetch zlib1g-dev zlib zlib)
(cd "$zlib" && CFLAGS="-O2 -fPIC" ./configure --static && make -j "$jobs" libz.a) > build/zlib.log 2>&1 \
  || { tail -20 build/zlib.log; exit 1; }
cp "$zlib/libz.a" .
zstd=$(fetch libzstd-dev libzstd zstd)
build "$zstd/build/cmake" libzstd_static zstd -DZSTD_BUILD_PROGRAMS=OFF -DZSTD_BUILD_SHARED=OFF
png=$(fetch libpng-dev libpng1.6 png)
build "$png" png_static png16 -DPNG_SHARED=OFF -DPNG_TESTS=OFF -DZLIB_LIBRARY="$PWD/libz.a" -DZLIB_INCLUDE_DIR=/usr/include
jpeg=$(fetch libjpeg62-turbo-dev libjpeg-turbo jpeg)
build "$jpeg" jpeg-static jpeg -DENABLE_SHARED=OFF -DWITH_TURBOJPEG=OFF -DWITH_JPEG7=OFF
mesh=$(fetch libmeshoptimizer-dev meshoptimizer mesh)
build "$mesh" meshoptimizer meshoptimizer
