#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds each package of shd, installs it where nothing else of shd is, and runs examples/hello.c and the three programs
# of bindings/c/programs.c with it. Their hashes are those of bindings/programs.txt.
#
#   tests/packages/run.sh [stage...]     deb | vcpkg | conan | fetchcontent | amalgamated; default: all
#
#   deb           Debian packages by CPack, lintian, and their installation in a chroot of Debian 12
#   vcpkg         the port of vcpkg; by a harness if vcpkg is not installed
#   conan         the recipe of Conan 2; by a harness if conan is not installed
#   fetchcontent  a project that fetches an archive of the sources with CMake's FetchContent
#   amalgamated   libshd as one source
#
# CTest sets the variables below. Exit code 77 of one stage: skipped.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
SOURCE=${SOURCE:-$(readlink -f "$here/../..")}
WORK=${WORK:-$SOURCE/build/packages}
CMAKE=${CMAKE:-cmake}
GENERATOR=${GENERATOR:-Ninja}
CC=${CC:-cc} CXX=${CXX:-c++} PYTHON=${PYTHON:-python3}
LAUNCHER=${LAUNCHER-$(command -v ccache || true)}
JOBS=${SHD_JOBS:-1}
export SOURCE WORK CMAKE GENERATOR CC CXX PYTHON LAUNCHER JOBS
# Copies of the sources in other folders share what they compile.
export CCACHE_NOHASHDIR=1

say() { printf '\n== %s\n' "$*"; }
die() {
  echo "$0: $*" >&2
  exit 1
}
skip() {
  echo "skipped: $*"
  exit 77
}

version() { sed -n 's/^project(shd VERSION \([0-9.]*\).*/\1/p' "$SOURCE/CMakeLists.txt"; }

# file: an archive of the tracked sources as they are in the working tree, with the folder shd-<version>
write_archive() {
  git -C "$SOURCE" rev-parse --git-dir >/dev/null 2>&1 || skip "the sources are no clone of git"
  git -C "$SOURCE" ls-files -z |
    tar --create --gzip --file "$1" --directory "$SOURCE" --null --files-from - \
      --transform "flags=r;s,^,shd-$(version)/,"
}

# command...: it prints the stored hashes
check_programs() { "$PYTHON" "$SOURCE/bindings/programs.py" check "$@"; }

# folder, compiler options...: hello and programs as C99, in this folder
build_c_programs() {
  local folder=$1 name
  shift
  for name in examples/hello bindings/c/programs; do
    "$CC" -std=c99 -pedantic -O2 -Wall -Wextra -Werror "$SOURCE/$name.c" -o "$folder/$(basename "$name")" "$@"
  done
}

# folder: runs what build_c_programs made
run_c_programs() {
  "$1/hello"
  check_programs "$1/programs"
}

run_all() {
  local stage status failed=0 summary=()
  for stage in "$@"; do
    status=0
    "$0" "$stage" || status=$?
    case $status in
      0) summary+=("$stage: passed") ;;
      77) summary+=("$stage: skipped") ;;
      *) summary+=("$stage: failed ($status)") && failed=1 ;;
    esac
  done
  say "packages"
  printf '%s\n' "${summary[@]}"
  exit "$failed"
}

stages=(deb vcpkg conan fetchcontent amalgamated)
[ $# -ne 0 ] || run_all "${stages[@]}"
[ $# -eq 1 ] || run_all "$@"
[[ " ${stages[*]} " == *" $1 "* ]] || die "no stage $1; the stages are: ${stages[*]}"
mkdir -p "$WORK/$1"
WORK=$WORK/$1
# shellcheck source=/dev/null
. "$here/$1.sh"
