# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2154,SC2034
# The port of vcpkg; sourced by run.sh. One SIMD target, which is quick to compile.
port=$SOURCE/src/packaging/vcpkg/shd
rm -rf "$WORK"
mkdir -p "$WORK"
write_archive "$WORK/shd.tar.gz"

# vcpkg itself, with this archive in place of the download. It builds the dependencies, too, and needs the network.
with_vcpkg() {
  local checksum
  checksum=$(sha512sum "$WORK/shd.tar.gz" | cut -d ' ' -f 1)
  mkdir -p "$WORK/ports"
  cp -r "$port" "$WORK/ports/shd"
  "$PYTHON" - "$WORK/ports/shd/portfile.cmake" "$WORK/shd.tar.gz" "$checksum" <<'END'
import re, sys
path, archive, checksum = sys.argv[1:]
text = open(path, encoding="utf-8").read()
local = (f'vcpkg_download_distfile(ARCHIVE URLS "file://{archive}" FILENAME shd.tar.gz SHA512 {checksum})\n'
         'vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${ARCHIVE}")')
open(path, "w", encoding="utf-8").write(re.sub(r"vcpkg_from_github\([^)]*\)", lambda match: local, text))
END
  vcpkg install 'shd[tbb]' "--overlay-ports=$WORK/ports" "--x-install-root=$WORK/installed" --triplet x64-linux
  prefix=$WORK/installed/x64-linux
}

with_harness() {
  say "vcpkg is not on PATH (no Debian package): a harness runs the port"
  # The port's build and its sources lie in one folder, for the compiler's cache.
  export CCACHE_BASEDIR=$WORK/buildtrees/shd
  options="-DSHD_SIMD=scalar;-DCMAKE_C_COMPILER=$CC;-DCMAKE_CXX_COMPILER=$CXX"
  options+=";-DCMAKE_CXX_COMPILER_LAUNCHER=$LAUNCHER"
  "$CMAKE" "-DPORT_DIR=$port" "-DARCHIVE=$WORK/shd.tar.gz" "-DWORK=$WORK" -DFEATURES=tbb "-DJOBS=$JOBS" \
    "-DOPTIONS=$options" -P "$here/vcpkg_harness.cmake"
  # vcpkg, too, moves a package after its build.
  prefix=$WORK/installed/x64-linux-release
  mkdir -p "$WORK/installed"
  mv "$WORK/packages/shd_x64-linux-release" "$prefix"
  rm -rf "$WORK/buildtrees"
}

if command -v vcpkg >/dev/null; then with_vcpkg; else with_harness; fi
"$CMAKE" -S "$here/consumer" -B "$WORK/build" -G "$GENERATOR" -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER="$CC" \
  -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_PREFIX_PATH="$prefix" -DPROGRAMS_DIR="$SOURCE"
"$CMAKE" --build "$WORK/build"
run_c_programs "$WORK/build"
"$WORK/build/hello_cpp"
