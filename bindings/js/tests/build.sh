#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds shd.wasm, shd-figures.wasm, the program of the golden hashes and shd-check in a folder by the preset `wasm`, and
# shd-threads.wasm in another one by the preset `wasm-threads`, with libraries in a third one: build.sh FOLDER FOLDER FOLDER. If the sources
# of the libraries cannot be had, the modules read no files.
set -euo pipefail
cd "$(dirname "$0")/../../.."
export CCACHE_COMPILERTYPE=clang  # ccache does not recognise emcc
options=(-DSHD_WASM_LIBRARIES="$3")
[ -z "${LAUNCHER:-}" ] || options+=(-DCMAKE_C_COMPILER_LAUNCHER="$LAUNCHER" -DCMAKE_CXX_COMPILER_LAUNCHER="$LAUNCHER")
bindings/js/libraries.sh "$3" || [ $? -eq 77 ]
cmake --preset wasm -B "$1" -DSHD_BUILD_TOOLS=ON "${options[@]}"
cmake --build "$1" --target shd_wasm shd_wasm_figures wasm_hashes shd-check -j "${JOBS:-2}"
cmake --preset wasm-threads -B "$2" "${options[@]}"
cmake --build "$2" --target shd_wasm -j "${JOBS:-2}"
ls -l "$1"/bindings/js/shd*.wasm "$2/bindings/js/shd-threads.wasm"
