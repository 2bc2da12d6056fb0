#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds and tests everything on Debian 12, from a fresh machine, as root or with sudo.
#
#   tests/run.sh [stage...]      all (default) | quick | format | highway | release | asan | tsan | core | small | arm
#
#   format    clang-format 14 over every tracked C and C++ file; the manual, by Doxygen and MkDocs, without warnings
#   highway   every file with kernels compiles with the headers of the newest Highway (tests/highway.sh)
#   release   optimised build of everything with benchmarks; every CTest test, exported symbols, layouts, headers
#   asan      address and undefined-behaviour sanitizers; every test but those about the binary
#   tsan      thread sanitizer on libshd alone; the tests that use threads
#   core      libshd alone, without OpenImageIO, OpenColorIO and oneTBB, on one generic SIMD target: the same bits, and
#             what users build with it
#   small     libshd_io and libshd_scene without OpenImageIO and assimp: their tests
#   arm       libshd for 64-bit ARM; its frames and lookups have the golden hashes under qemu. Skipped without a cross
#             compiler (g++-aarch64-linux-gnu, qemu-user); SHD_ARM=1 installs both, 320 MB
#   quick     format and release
#
# Missing Debian packages are installed first, by name and without recommendations. If all are there, only the stage
# highway uses the network. SHD_NO_INSTALL=1 never installs and skips that stage. Builds go to build/ci/<stage>; ccache
# is used when present.
set -uo pipefail
cd "$(dirname "$0")/.." || exit 1

packages=(abigail-tools assimp-testmodels ca-certificates ccache clang clang-format cmake doxygen g++ gcc gdb git
          libassimp-dev libastcenc-dev libbenchmark-dev libcli11-dev libcmocka-dev libboost-dev libdraco-dev libeigen3-dev
          libembree-dev libhwy-dev libimgui-dev libjpeg-dev libmeshoptimizer-dev libopencolorio-dev libopenimageio-dev
          libopenmpi-dev libopenvdb-dev libpng-dev libsdl2-dev libtbb-dev libzstd-dev
          doxygen-awesome-css libjs-katex mkdocs-material  # the manual
          mypy openimageio-tools python3-pil  # types of Python, maketx to compare with, images
          ninja-build nlohmann-json3-dev openmpi-bin pkg-config procps python3 python3-numpy zlib1g-dev)
arm_packages=(g++-aarch64-linux-gnu qemu-user)
[ "${SHD_ARM:-0}" = 1 ] && packages+=("${arm_packages[@]}")
jobs=$(nproc)
# Clones share what they compile, wherever they lie.
export CCACHE_BASEDIR=${CCACHE_BASEDIR:-$PWD} CCACHE_NOHASHDIR=${CCACHE_NOHASHDIR:-1}
# Dependencies come from the compiler itself: a cold cache costs no second preprocessing.
export CCACHE_DEPEND=${CCACHE_DEPEND:-1}
summary=()
failed=0

say() { printf '\n== %s\n' "$*"; }

# package...: prints those that are not installed, one a line
missing_packages() {
  local name
  for name in "$@"; do
    dpkg-query -W -f='${db:Status-Abbrev}' "$name" 2>/dev/null | grep -q '^ii' || printf '%s\n' "$name"
  done
}

install_packages() {
  local missing as_root=()
  mapfile -t missing < <(missing_packages "${packages[@]}")
  if [ "${#missing[@]}" -eq 0 ]; then
    say "packages: all ${#packages[@]} are installed"
    return 0
  fi
  if [ "${SHD_NO_INSTALL:-0}" = 1 ]; then
    say "packages: missing ${missing[*]} (SHD_NO_INSTALL=1)"
    return 0
  fi
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  say "packages: installing ${missing[*]}"
  "${as_root[@]}" apt-get update -q &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends "${missing[@]}"
}

# stage, CMake options...: configures build/ci/<stage> from the preset of that name and builds it, or the targets of it
# that the caller's `targets` names
build() {
  local stage=$1 launcher=()
  shift
  if command -v ccache >/dev/null; then
    launcher=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  fi
  cmake --preset "$stage" -B "build/ci/$stage" "${launcher[@]}" "$@" &&
    ninja -C "build/ci/$stage" -j "$jobs" "${targets[@]}"
}

# stage, ctest options...: leaves CTest's count for the summary in build/ci/<stage>.count
run_tests() {
  local stage=$1 log status
  shift
  log=build/ci/$stage.log
  "${runner[@]}" ctest --test-dir "build/ci/$stage" -j "$jobs" --output-on-failure --no-tests=error "$@" 2>&1 |
    tee "$log"
  status=${PIPESTATUS[0]}
  grep -E 'tests? passed' "$log" | tail -n 1 >"build/ci/$stage.count"
  return "$status"
}

stage_format() {
  tests/support/check_format.sh && python3 docs/site/build.py build/ci/docs
}
stage_highway() {
  tests/highway.sh | tee build/ci/highway.log && tail -n 1 build/ci/highway.log >build/ci/highway.count
}
stage_release() { build release && run_tests release; }
# The binary and the style are the release stage's matter; a sanitized library loads and exports more. Without the
# interceptor of __tls_get_addr: up to GCC 13 it takes some addresses for those of glibc 2.19, and the search for leaks
# then crashes (https://github.com/google/sanitizers/issues/1322).
stage_asan() {
  build asan -DSHD_BUILD_EXAMPLES=OFF &&
    ASAN_OPTIONS=detect_stack_use_after_return=1:strict_string_checks=1:allocator_may_return_null=1:intercept_tls_get_addr=0 \
      LSAN_OPTIONS=suppressions=$PWD/tests/support/lsan.supp:print_suppressions=0 \
      UBSAN_OPTIONS=print_stacktrace=1 SHD_ONE_PICTURE=1 run_tests asan -LE '^(abi|style|consumer|rebuild)$'
}
# Without address randomisation: the sanitizer of gcc 12 fails with the layouts of newer kernels. libshd starts no
# thread here, so tests that start none have nothing to show. Two SIMD targets have the threads of all.
stage_tsan() {
  local runner=() targets=(tests_threads)
  setarch "$(uname -m)" -R true 2>/dev/null && runner=(setarch "$(uname -m)" -R)
  build tsan -DSHD_SIMD=few -DSHD_WITH_IO=OFF -DSHD_WITH_OCIO=OFF -DSHD_BUILD_EXAMPLES=OFF &&
    TSAN_OPTIONS=suppressions=$PWD/tests/support/tsan.supp:halt_on_error=1 run_tests tsan -L '^threads$' -LE '^(slow|forks)$'
}
# The absence of the dependencies and the one SIMD target can change the binary, the bits, the process, and the programs
# and projects of users.
stage_core() {
  local targets=(shd tests_abi tests_bits tests_examples tests_host)
  build core -DSHD_SIMD=scalar && run_tests core -L '^(abi|bits|consumer|examples|host)$'
}
# Files by libpng, libjpeg and the own readers of models, without OpenImageIO and assimp.
stage_small() {
  local targets=(shd_io shd_scene tests_abi tests_files)
  build small && run_tests small -L '^(abi|files)$'
}
# Only the golden hashes and those of the bindings' programs: the emulator takes a minute for them.
stage_arm() {
  local missing targets=(test_api_determinism c_programs)
  missing=$(missing_packages "${arm_packages[@]}" | paste -sd, | sed 's/,/, /g')
  if [ -n "$missing" ]; then
    echo "skipped: packages $missing are absent" | tee build/ci/arm.count
    return 0
  fi
  build aarch64 && run_tests aarch64 --verbose && grep -o '[0-9]* of [0-9]* hashes are equal' build/ci/aarch64.log >build/ci/arm.count
}

run_stage() {
  local stage=$1 start=$SECONDS status=passed runner=() targets=() count
  say "stage $stage"
  rm -f "build/ci/$stage.count"
  if ! "stage_$stage"; then
    status=FAILED
    failed=1
  fi
  count=$(cat "build/ci/$stage.count" 2>/dev/null)
  summary+=("$(printf '%-8s %-7s %4d s  %s' "$stage" "$status" $((SECONDS - start)) "$count")")
}

stages=()
for argument in "${@:-all}"; do
  case $argument in
    all) stages+=(format highway release asan tsan core small arm) ;;
    quick) stages+=(format release) ;;
    format | highway | release | asan | tsan | core | small | arm) stages+=("$argument") ;;
    *)
      sed -n '3,22p' "$0" | sed 's/^# \{0,1\}//'
      exit 2
      ;;
  esac
done

mkdir -p build/ci
install_packages || exit 1
for stage in "${stages[@]}"; do run_stage "$stage"; done

say "summary"
printf '%s\n' "${summary[@]}"
[ "$failed" -eq 0 ] && echo "all stages passed" || echo "a stage FAILED"
exit "$failed"
