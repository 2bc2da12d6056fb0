#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compares the filters of shd with ground truth, OpenImageIO, llvmpipe and lavapipe on Debian 12, and writes the report
# out/shootout/shootout.html, which needs no network, with shootout.json and shootout.csv. Run it as root, or as a user
# who may use sudo. Without either it works if the packages are there.
# Usage: shootout.sh [--build FOLDER] [OPTION...]; FOLDER holds a finished build; options are those of shd-shootout.
#        shootout.sh --newer-mesa [OPTION...]; the same on Debian 13 with its Mesa 25 and OpenImageIO 2.5, in a chroot
#        of debootstrap, as root; the report is out/shootout-mesa25/shootout.html, and OPTION is not -o.
set -euo pipefail
cd "$(dirname "$0")/.."

if [ "${1:-}" = --newer-mesa ]; then
  shift
  # shellcheck source=bench/peers/newer_mesa.sh
  . bench/peers/newer_mesa.sh
  command -v debootstrap >/dev/null || die "needs debootstrap (Debian package debootstrap)"
  build_beside_newer_mesa shd-shootout xplanet-images
  newer_versions
  rm -rf "${root:?}/shd-build/shootout-mesa25"
  inside "$newer_build/examples/apps/shootout/shd-shootout" "$@" -o /shd-build/shootout-mesa25
  # Single figures and lists leave no report.
  if [ -d "$root/shd-build/shootout-mesa25" ]; then
    mkdir -p out/shootout-mesa25
    cp "$root"/shd-build/shootout-mesa25/* out/shootout-mesa25/
    echo "== Copied to out/shootout-mesa25"
  fi
  exit
fi

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
  libcli11-dev                                  # options
  libopenimageio-dev libosmesa6-dev             # the peers
  libvulkan-dev glslang-tools mesa-vulkan-drivers
  xplanet-images                                # a photograph: the map of the earth
)
install_packages "${packages[@]}"

if [ -z "$build" ]; then
  build=build/shootout
  echo "== Building shd and shd-shootout in $build: minutes on a few cores"
  # Without libshd_color and libshd_scene, whose parts the report does not need.
  cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSHD_BUILD_TESTS=OFF -DSHD_BUILD_EXAMPLES=ON \
    -DSHD_BUILD_TOOLS=OFF -DSHD_WITH_OCIO=OFF -DSHD_WITH_SCENE=OFF -DSHD_WITH_EMBREE=OFF -DSHD_WITH_OPENVDB=OFF
  cmake --build "$build" --parallel "$(compile_jobs)" --target shd-shootout
fi
"$build/examples/apps/shootout/shd-shootout" -o out/shootout "$@"
