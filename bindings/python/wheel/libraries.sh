#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# libraries.sh FOLDER: makes libtbb.a, libhwy.a and glibc.o, with which libshd needs no library besides glibc.
#
# Debian has oneTBB and Highway as shared libraries only. Their sources come from Debian's archive, in the versions of
# the installed headers, through a private copy of the lists of apt: the system's lists stay as they are.
# Exit code 77: the sources cannot be had.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
cd "$1"
jobs=${JOBS:-$(nproc)}
${CC:-cc} -std=c99 -O2 -fPIC -Wall -Wextra -c "$here/glibc.c" -o glibc.o
if [ -e libtbb.a ] && [ -e libhwy.a ]; then exit 0; fi

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

# package of the headers, source package, folder of its files
fetch() {
  local version
  version=$(dpkg-query -W -f '${source:Version}' "$1") || skip "$1 is not installed (Debian: $1)"
  rm -rf "source/$3"
  mkdir -p "source/$3"
  (cd "source/$3" && apt-get "${options[@]}" source "$2=$version" > ../log 2>&1) || skip "no source of $2 $version"
  find "source/$3" -mindepth 1 -maxdepth 1 -type d
}
# source folder, target, options of cmake...
build() {
  local source=$1 target=$2
  shift 2
  cmake -S "$source" -B "build/$target" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF \
    -DCMAKE_POSITION_INDEPENDENT_CODE=ON "$@" > "build/$target.log" 2>&1
  cmake --build "build/$target" --target "$target" -j "$jobs" >> "build/$target.log" 2>&1 \
    || { tail -20 "build/$target.log"; exit 1; }
  find "build/$target" -name "lib$target.a" -exec cp {} . \;
  test -e "lib$target.a"
}
mkdir -p build
tbb=$(fetch libtbb-dev onetbb tbb)
hwy=$(fetch libhwy-dev highway hwy)
build "$tbb" tbb -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF -DTBB_DISABLE_HWLOC_AUTOMATIC_SEARCH=ON
build "$hwy" hwy -DBUILD_TESTING=OFF -DHWY_ENABLE_TESTS=OFF -DHWY_ENABLE_EXAMPLES=OFF -DHWY_ENABLE_CONTRIB=OFF
