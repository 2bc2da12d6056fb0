#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds shd.wasm, the program of the golden hashes and shd-check in a folder by the preset `wasm`, and shd-threads.wasm in
# another one by the preset `wasm-threads`: build.sh FOLDER FOLDER.
set -euo pipefail
cd "$(dirname "$0")/../../.."
export CCACHE_COMPILERTYPE=clang  # ccache does not recognise emcc
launcher=()
[ -z "${LAUNCHER:-}" ] || launcher=(-DCMAKE_C_COMPILER_LAUNCHER="$LAUNCHER" -DCMAKE_CXX_COMPILER_LAUNCHER="$LAUNCHER")
cmake --preset wasm -B "$1" -DSHD_BUILD_TOOLS=ON "${launcher[@]}"
cmake --build "$1" --target shd_wasm wasm_hashes shd-check -j "${JOBS:-2}"
cmake --preset wasm-threads -B "$2" "${launcher[@]}"
cmake --build "$2" --target shd_wasm -j "${JOBS:-2}"
ls -l "$1/bindings/js/shd.wasm" "$2/bindings/js/shd-threads.wasm"
