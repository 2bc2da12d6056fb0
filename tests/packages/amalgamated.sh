# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2154,SC2034
# libshd as one source, compiled with one command; sourced by run.sh. The source has one SIMD target without libhwy, and
# then two targets, as in the preset core. The golden hashes of tests/golden/ are compared, too: they cover every filter
# and kind of frame, and with them overloads that the order of the joined sources could change.
rm -rf "$WORK"
mkdir -p "$WORK/include/shd"
"$PYTHON" "$SOURCE/src/packaging/amalgamate.py" "$WORK"
for header in "$SOURCE"/include/shd/*.h; do # programs include these names
  echo '#include "shd_all.h"' >"$WORK/include/shd/$(basename "$header")"
done

# name, libraries...: the determinism test of the API with the object file of that name
run_golden() {
  local name=$1
  shift
  if ! pkg-config --exists cmocka; then
    echo "not compared with tests/golden: no cmocka (Debian: libcmocka-dev)"
    return
  fi
  "$CC" -std=c99 -O1 "-DSHD_GOLDEN_DIR=\"$SOURCE/tests/golden\"" "-I$SOURCE/tests" "-I$WORK/include" "-I$WORK" \
    "$SOURCE/tests/api/test_determinism.c" "$WORK/$name.o" -o "$WORK/$name/determinism" -lcmocka -lstdc++ -lm \
    -pthread "$@"
  "$WORK/$name/determinism" >"$WORK/$name/determinism.log" 2>&1 || { cat "$WORK/$name/determinism.log" && exit 1; }
  echo "golden hashes: equal"
}

# name, definition, libraries...; snprintf cuts texts on purpose, hence -Wno-format-truncation
build_amalgamated() {
  local name=$1 definition=$2 start=$SECONDS
  shift 2
  "$CXX" -std=c++17 -O2 -ffp-contract=off -fno-math-errno -fvisibility=hidden -Wall -Wextra -Werror \
    -Wno-format-truncation "-I$WORK" "$definition" -c "$WORK/shd.cpp" -o "$WORK/$name.o"
  echo "$name: $((SECONDS - start)) s; $(stat -c %s "$WORK/$name.o") bytes of object file"
  mkdir -p "$WORK/$name"
  build_c_programs "$WORK/$name" "-I$WORK/include" "-I$WORK" "$WORK/$name.o" -lstdc++ -lm -pthread "$@"
  run_c_programs "$WORK/$name"
  run_golden "$name" "$@"
}

say "one SIMD target"
build_amalgamated static -DHWY_COMPILE_ONLY_STATIC
! ldd "$WORK/static/programs" | grep -F libhwy || die "a build for one SIMD target needs libhwy"
say "two SIMD targets, chosen at run time"
build_amalgamated few -DSHD_SIMD_FEW -lhwy
