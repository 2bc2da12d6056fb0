# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2154,SC2034
# A project that fetches an archive of the sources with CMake's FetchContent; sourced by run.sh. One SIMD target, which
# is quick to compile.
rm -rf "$WORK"
mkdir -p "$WORK"
write_archive "$WORK/shd.tar.gz"
# With the compiler's cache: the paths of the fetched copy are relative to this folder.
export CCACHE_BASEDIR=$WORK/build/_deps/shd-src
"$CMAKE" -S "$SOURCE/tests/consumer/fetch_content" -B "$WORK/build" -G "$GENERATOR" -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_CXX_COMPILER_LAUNCHER="$LAUNCHER" \
  -DSHD_URL="file://$WORK/shd.tar.gz" -DSHD_URL_HASH="$(sha256sum "$WORK/shd.tar.gz" | cut -d ' ' -f 1)" \
  -DPROGRAMS_DIR="$SOURCE" -DSHD_SIMD=scalar
"$CMAKE" --build "$WORK/build" -j "$JOBS"
[ -d "$WORK/build/_deps/shd-src/include/shd" ] || die "FetchContent did not unpack the archive"
run_c_programs "$WORK/build"
