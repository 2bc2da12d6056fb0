# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2154,SC2034
# The recipe of Conan 2; sourced by run.sh. One SIMD target, which is quick to compile.
recipe=$SOURCE/src/packaging/conan/conanfile.py
rm -rf "$WORK"
mkdir -p "$WORK/recipe"
write_archive "$WORK/shd.tar.gz"

# Conan itself. It builds or downloads Highway and oneTBB, and needs the network.
with_conan() {
  cp "$recipe" "$WORK/recipe"
  cat >"$WORK/recipe/conandata.yml" <<END
sources:
  "$(version)":
    url: "file://$WORK/shd.tar.gz"
    sha256: "$(sha256sum "$WORK/shd.tar.gz" | cut -d ' ' -f 1)"
END
  export CONAN_HOME=$WORK/home
  conan profile detect
  conan create "$WORK/recipe" --version "$(version)" -o 'shd/*:simd=scalar' --build missing
  conan install --requires "shd/$(version)" -o 'shd/*:simd=scalar' -g CMakeDeps -g CMakeToolchain -of "$WORK/deps"
  "$CMAKE" -S "$here/consumer" -B "$WORK/build" -G "$GENERATOR" -DCMAKE_BUILD_TYPE=Release -DPROGRAMS_DIR="$SOURCE" \
    -DCMAKE_TOOLCHAIN_FILE="$WORK/deps/conan_toolchain.cmake"
  "$CMAKE" --build "$WORK/build"
  run_c_programs "$WORK/build"
}

with_harness() {
  local flags
  say "conan is not on PATH (PyPI: conan; no Debian package): a harness runs the recipe"
  export CCACHE_BASEDIR=$WORK
  HARNESS_CMAKE_OPTIONS="-DCMAKE_C_COMPILER=$CC -DCMAKE_CXX_COMPILER=$CXX"
  export HARNESS_CMAKE_OPTIONS+=" -DCMAKE_CXX_COMPILER_LAUNCHER=$LAUNCHER"
  "$PYTHON" "$here/conan_harness.py" "$recipe" --archive "$WORK/shd.tar.gz" --work "$WORK" | tee "$WORK/harness.log"
  read -ra flags <<<"$(tail -n 1 "$WORK/harness.log")"
  rm -rf "$WORK/build" "$WORK/src" # the package needs neither
  build_c_programs "$WORK" "${flags[@]}"
  run_c_programs "$WORK"
}

if command -v conan >/dev/null; then with_conan; else with_harness; fi
