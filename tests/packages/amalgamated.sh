# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2154,SC2034
# libshd as one source, compiled with one command; sourced by run.sh. The source has two SIMD targets here, as in the
# preset core, and one in a second build without libhwy.
rm -rf "$WORK"
mkdir -p "$WORK/include/shd"
"$PYTHON" "$SOURCE/src/packaging/amalgamate.py" "$WORK"
echo '#include "shd_all.h"' >"$WORK/include/shd/shd.h" # hello.c and programs.c include this name

# name, definition, libraries...
build_amalgamated() {
  local name=$1 definition=$2 start=$SECONDS
  shift 2
  "$CXX" -std=c++17 -O2 -ffp-contract=off -fno-math-errno -fvisibility=hidden -Wall -Wextra -Werror \
    "-I$WORK" "$definition" -c "$WORK/shd.cpp" -o "$WORK/$name.o"
  echo "$name: $((SECONDS - start)) s; $(stat -c %s "$WORK/$name.o") bytes of object file"
  mkdir -p "$WORK/$name"
  build_c_programs "$WORK/$name" "-I$WORK/include" "-I$WORK" "$WORK/$name.o" -lstdc++ -lm -pthread "$@"
  size "$WORK/$name/programs"
  run_c_programs "$WORK/$name"
}

say "one SIMD target"
build_amalgamated static -DHWY_COMPILE_ONLY_STATIC
! ldd "$WORK/static/programs" | grep -F libhwy || die "a build for one SIMD target needs libhwy"
say "two SIMD targets, chosen at run time"
build_amalgamated few -DSHD_SIMD_FEW -lhwy
