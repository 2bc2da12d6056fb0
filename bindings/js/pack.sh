#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes shd-<version>.tgz, the package for npm, in a folder: pack.sh [folder]. SHD_WASM and SHD_WASM_THREADS are the
# paths of shd.wasm and shd-threads.wasm, by default those of the presets `wasm` and `wasm-threads`, which are built.
set -euo pipefail
source=$(cd "$(dirname "$0")" && pwd)
root=$source/../..
folder=$(cd "${1:-.}" && pwd)
build() { (cd "$root" && cmake --preset "$1" && cmake --build --preset "$1") >&2; }
if [ -z "${SHD_WASM:-}" ]; then
  build wasm
  SHD_WASM=$root/build/wasm/bindings/js/shd.wasm
fi
if [ -z "${SHD_WASM_THREADS:-}" ]; then
  build wasm-threads
  SHD_WASM_THREADS=$root/build/wasm-threads/bindings/js/shd-threads.wasm
fi
python3 "$source/../generate.py" js
stage=$(mktemp -d)
trap 'rm -rf "$stage"' EXIT
cp -r "$source"/{package.json,README.md,lib,examples} "$root/LICENSE" "$stage"
cp "$SHD_WASM" "$stage/lib/shd.wasm"
cp "$SHD_WASM_THREADS" "$stage/lib/shd-threads.wasm"
(cd "$stage" && npm pack --silent --pack-destination "$folder")
