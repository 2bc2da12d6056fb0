#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compares the filters of shd with ground truth, OpenImageIO and llvmpipe on Debian 12, and writes the report
# out/shootout/shootout.html, which needs no network, with shootout.json and shootout.csv. Run it as root, or as a user
# who may use sudo. Without either it works if the packages are there.
# Usage: shootout.sh [--build FOLDER] [OPTION...]; FOLDER holds a finished build; options are those of shd-shootout.
set -euo pipefail
cd "$(dirname "$0")/.."

build=
if [ "${1:-}" = --build ]; then
  [ $# -ge 2 ] || { echo "shootout.sh: --build needs a folder" >&2; exit 1; }
  build=$2
  shift 2
fi

. examples/packages.sh
packages=(
  build-essential cmake ninja-build pkg-config  # to build
  libhwy-dev libtbb-dev zlib1g-dev              # SIMD (Highway), threads, PNG
  libopenimageio-dev libosmesa6-dev             # the peers
  xplanet-images                                # a photograph: the map of the earth
)
install_packages "${packages[@]}"

if [ -z "$build" ]; then
  build=build/shootout
  echo "== Building shd and shd-shootout in $build: minutes on a few cores"
  # Without libshd_color and libshd_scene, whose parts the report does not need.
  cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSHD_BUILD_TESTS=OFF -DSHD_BUILD_EXAMPLES=ON \
    -DSHD_WITH_OCIO=OFF -DSHD_WITH_ASSIMP=OFF -DSHD_WITH_EMBREE=OFF -DSHD_WITH_OPENVDB=OFF
  cmake --build "$build" --parallel "$(compile_jobs)" --target shd-shootout
fi
"$build/examples/shootout/shd-shootout" -o out/shootout "$@"
