#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs shd-bench on Debian 13 (trixie), beside its Mesa (25.0) and its OpenImageIO (2.5), in a chroot; as root on a
# Debian with debootstrap.
#
#   bench/peers/newer-mesa.sh [option of shd-bench...]
#
# The default is the rows of frames and lookups that README quotes. tests/support/debian13_chroot.sh describes the
# chroot. SHD_JOBS limits the number of jobs (default: one per core). Results are written to standard output.
set -euo pipefail
cd "$(dirname "$0")/../.."
# shellcheck source=tests/support/debian13_chroot.sh
. tests/support/debian13_chroot.sh

jobs=${SHD_JOBS:-$(nproc)}
options=("${@:---benchmark_filter=^frame/(spheres|quad|floor)/|^texture/.*/rgba8/.*/floor/edge:2048|^quality/}")
build=/shd-build/bench

open_chroot >&2
install_packages cmake g++ libbenchmark-dev libhwy-dev libopenimageio-dev libosmesa6-dev ninja-build pkg-config \
  python3 >&2
copy_sources >&2
inside cmake -S /shd -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSHD_BUILD_BENCH=ON -DSHD_BUILD_TESTS=OFF \
  -DSHD_BUILD_EXAMPLES=OFF -DSHD_WITH_OCIO=OFF -DSHD_WITH_TBB=OFF -DSHD_WITH_ASSIMP=OFF >&2
inside cmake --build "$build" -j "$jobs" --target shd-bench >&2
# shellcheck disable=SC2016 # dpkg-query expands it
inside dpkg-query -W -f '${Package} ${Version}\n' libosmesa6 'libopenimageio2*' 2>/dev/null | grep ' [0-9]'
inside "$build/bench/shd-bench" "${options[@]}"
