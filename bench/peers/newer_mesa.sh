# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Functions for programs beside the Mesa of Debian 13 (trixie, Mesa 25.0), to be sourced at the root of the project by a
# script that runs as root on a Debian with debootstrap. The chroot is that of tests/support/debian13_chroot.sh.
# SHD_JOBS limits the number of jobs (default: one per core).
# shellcheck source=tests/support/debian13_chroot.sh
. tests/support/debian13_chroot.sh

newer_build=/shd-build/bench

# Packages of the peers, of which a later Debian may have fewer: Mesa 25.1 and later have no OSMesa. The programs name
# the peers that they lack.
peer_packages=(glslang-tools libosmesa6-dev libopenimageio-dev libvulkan-dev mesa-vulkan-drivers)

# target package...: builds a program of the project and its peers in the chroot, with the packages that it needs. All
# messages go to standard error, because the output of benchmarks is data.
build_beside_newer_mesa() {
  local target=$1 package
  shift
  {
    open_chroot
    install_packages cmake g++ libbenchmark-dev libcli11-dev libhwy-dev ninja-build pkg-config python3 zlib1g-dev "$@"
    for package in "${peer_packages[@]}"; do
      if inside apt-cache show "$package" >/dev/null 2>&1; then
        install_packages "$package"
      else
        say "no package $package: its peer is left out"
      fi
    done
    copy_sources
    inside cmake -S /shd -B "$newer_build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSHD_BUILD_BENCH=ON \
      -DSHD_BUILD_TESTS=OFF -DSHD_BUILD_EXAMPLES=ON -DSHD_WITH_OCIO=OFF -DSHD_WITH_TBB=OFF -DSHD_WITH_SCENE=OFF \
      -DSHD_BUILD_TOOLS=OFF -DSHD_WITH_EMBREE=OFF -DSHD_WITH_OPENVDB=OFF "-DSHD_COMMIT=$(git describe --always --dirty)"
    inside cmake --build "$newer_build" -j "${SHD_JOBS:-$(nproc)}" --target "$target"
  } >&2
}

# Versions of Mesa and OpenImageIO in the chroot.
newer_versions() {
  # shellcheck disable=SC2016 # dpkg-query expands it
  inside dpkg-query -W -f '${Package} ${Version}\n' libosmesa6 mesa-vulkan-drivers 'libopenimageio2*' 2>/dev/null |
    grep ' [0-9]' || true
}
