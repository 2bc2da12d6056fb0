#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds and tests every binding, package and host program on Debian 12, as root or with sudo, and compares their speed.
#
#   bindings/run.sh [pattern]     only the tests whose names match the regular expression; default: all, and the ARM
#                                 build under qemu
#
# Missing Debian packages are installed first. The build is build/bindings.
set -uo pipefail
cd "$(dirname "$0")/.." || exit 1
# shellcheck source=examples/packages.sh
. examples/packages.sh

pattern=${1:-'^bindings\.'}
build=build/bindings
packages=(ca-certificates clang cmake g++ gcc git ninja-build pkg-config python3
          libassimp-dev libbenchmark-dev libboost-dev libcli11-dev libcmocka-dev libdraco-dev libeigen3-dev libembree-dev
          libhwy-dev libjpeg-dev libmeshoptimizer-dev nlohmann-json3-dev
          libopencolorio-dev libopenimageio-dev libopenvdb-dev libpng-dev libtbb-dev libzstd-dev zlib1g-dev
          assimp-testmodels
          mypy python3-numpy python3-pil python3-pip python3-pytest python3-setuptools python3-venv python3-wheel
          chromium emscripten
          luajit love godot3-server
          cargo rustc
          mono-mcs mono-runtime
          imagemagick libimgui-dev libsdl2-dev xauth xdotool xvfb
          debootstrap dpkg-dev fakeroot file lintian nasm)

# Node from another source has its own npm.
command -v npm >/dev/null || packages+=(npm)

say() { printf '\n== %s\n' "$*"; }

# The table of all tests from ctest's report.
table() {
  python3 - "$1" <<'PYTHON'
import sys
import xml.etree.ElementTree
for case in xml.etree.ElementTree.parse(sys.argv[1]).getroot().iter("testcase"):
    state = {"run": "passed", "fail": "FAILED", "notrun": "skipped", "disabled": "skipped"}[case.get("status")]
    lines = (case.findtext("system-out") or "").split("\n")
    why = next((line for line in lines if line.startswith("skipped")), "") if state == "skipped" else ""
    print(f"{case.get('name'):40} {state:8} {float(case.get('time')):7.1f} s  {why}")
PYTHON
}

install_packages "${packages[@]}" || exit 1
launcher=()
if command -v ccache >/dev/null; then
  export CCACHE_BASEDIR=${CCACHE_BASEDIR:-$PWD} CCACHE_NOHASHDIR=${CCACHE_NOHASHDIR:-1}
  launcher=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi
jobs=$(compile_jobs)
say "headers of Godot"
examples/apps/godot/fetch_headers.sh "$build/godot" || echo "bindings.godot will be skipped"
say "build"
cmake --preset release -B "$build" -DSHD_BUILD_BENCH=OFF -DSHD_TEST_ARTEFACTS=ON "${launcher[@]}" &&
  ninja -C "$build" -j "$jobs" bindings || exit 1

say "tests"
failed=0
ctest --test-dir "$build" -R "$pattern" -j "$jobs" --output-on-failure --no-tests=error \
  --output-junit bindings.xml || failed=1
arm=''
if [ $# -eq 0 ]; then
  say "ARM"
  SHD_ARM=1 tests/run.sh arm | tee "$build/arm.log"
  [ "${PIPESTATUS[0]}" -eq 0 ] || failed=1
  arm=$(grep -E '^arm ' "$build/arm.log")
fi

say "speed"
python3 bindings/programs.py speed "$build/bindings/programs.list"
SHD_LIBRARY=$build/src/libshd.so /usr/bin/python3 bindings/python/start_time.py
say "summary"
table "$build/bindings.xml"
[ -z "$arm" ] || echo "$arm"
[ "$failed" -eq 0 ] && echo "all tests passed" || echo "a test FAILED"
exit "$failed"
