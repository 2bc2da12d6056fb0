#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds and tests shd on Debian 13 (trixie) in a chroot, as root on a Debian with debootstrap.
#
#   tests/debian13.sh [preset...]
#
# The presets are those of CMakePresets.json; the default is core, libshd alone. tests/support/debian13_chroot.sh
# describes the chroot. SHD_JOBS limits the number of jobs (default: one per core).
set -euo pipefail
cd "$(dirname "$0")/.."
# shellcheck source=tests/support/debian13_chroot.sh
. tests/support/debian13_chroot.sh

jobs=${SHD_JOBS:-$(nproc)}
presets=("${@:-core}")
wanted=(cmake g++ libcmocka-dev libhwy-dev ninja-build pkg-config python3)
for preset in "${presets[@]}"; do
  [ "$preset" = core ] || wanted+=(libassimp-dev libbenchmark-dev libcli11-dev libdraco-dev libmeshoptimizer-dev nlohmann-json3-dev libeigen3-dev libboost-dev libembree-dev libopencolorio-dev libopenimageio-dev libopenvdb-dev libtbb-dev python3-numpy)
done

# consumer.add_subdirectory would build the library once more.
build_and_test() {
  local preset=$1
  say "preset $preset"
  inside cmake -S /shd --preset "$preset" -B "/shd-build/$preset"
  inside cmake --build "/shd-build/$preset" -j "$jobs" -- -k 0 # one call shows every error
  inside ctest --test-dir "/shd-build/$preset" -j "$jobs" --output-on-failure --no-tests=error \
    -E '^consumer\.add_subdirectory$'
}

open_chroot
install_packages "${wanted[@]}"
copy_sources
for preset in "${presets[@]}"; do build_and_test "$preset"; done
