#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# libraries.sh FOLDER: makes glibc.o and static libraries, with which libshd, libshd_io and libshd_scene need no library
# besides glibc, and files of pkg-config that name them.
#
# Debian's static libraries of C code do not fit into shared libraries, and some libraries have none. The sources come
# from Debian's archive, in the versions of the installed headers, through a private copy of the lists of apt: the
# system's lists stay as they are.
# Exit code 77: the sources cannot be had.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
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

skip() { echo "skipped: $*"; exit 77; }
command -v apt-get > /dev/null && command -v dpkg-source > /dev/null \
  || skip "no apt-get or dpkg-source (Debian: dpkg-dev)"
mkdir -p apt/sources apt/lists/partial apt/cache/archives/partial source
for file in /etc/apt/sources.list /etc/apt/sources.list.d/debian.sources; do
  if [ ! -e "$file" ]; then continue; fi
  sed -E 's/^Types: .*/Types: deb-src/; s/^deb /deb-src /' "$file" > "apt/sources/${file##*/}"
done
if [ -e apt/sources/sources.list ]; then mv apt/sources/sources.list apt/sources/main.list; fi
options=(-qq -o "Dir::Etc::SourceList=/dev/null" -o "Dir::Etc::SourceParts=$PWD/apt/sources"
         -o "Dir::State::Lists=$PWD/apt/lists" -o "Dir::Cache=$PWD/apt/cache" -o "APT::Sandbox::User=root")
apt-get "${options[@]}" update > apt/log 2>&1 || skip "apt-get update failed: $(tail -1 apt/log)"

# package of the headers, source package, folder of its files: the newest revision, which can be had, of the version of
# the headers
fetch() {
  local installed version
  installed=$(dpkg-query -W -f '${source:Version}' "$1") || skip "$1 is not installed (Debian: $1)"
  for version in $(apt-cache "${options[@]}" showsrc "$2" | sed -n "s/^Version: //p" | grep -F "${installed%-*}-" | sort -rV); do
    rm -rf "source/$3"
    mkdir -p "source/$3"
    (cd "source/$3" && apt-get "${options[@]}" source "$2=$version" > ../log 2>&1) || continue
    find "source/$3" -mindepth 1 -maxdepth 1 -type d
    return
  done
  skip "no source of $2 ${installed%-*}"
}
# source folder, target, name of the library, options of cmake...
build() {
  local source=$1 target=$2 library=$3
  shift 3
  cmake -S "$source" -B "build/$target" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF \
    -DCMAKE_POSITION_INDEPENDENT_CODE=ON "$@" > "build/$target.log" 2>&1
  cmake --build "build/$target" --target "$target" -j "$jobs" >> "build/$target.log" 2>&1 \
    || { tail -20 "build/$target.log"; exit 1; }
  find "build/$target" -name "lib$library.a" -exec cp {} . \;
  test -e "lib$library.a"
}
mkdir -p build
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
