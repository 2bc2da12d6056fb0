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
# shellcheck source=bench/peers/newer_mesa.sh
. bench/peers/newer_mesa.sh

options=("${@:---benchmark_filter=^frame/(spheres|quad|floor)/|^texture/.*/rgba8/.*/floor/edge:2048|^quality/}")

build_beside_newer_mesa shd-bench
newer_versions
inside "$newer_build/bench/shd-bench" "${options[@]}"
