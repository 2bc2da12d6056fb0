#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes shd-<version>.tgz, the package for npm, in a folder: pack.sh [folder]. SHD_WASM is the path of shd.wasm, by
# default that of the preset `wasm`, which is built.
set -euo pipefail
source=$(cd "$(dirname "$0")" && pwd)
root=$source/../..
folder=$(cd "${1:-.}" && pwd)
if [ -z "${SHD_WASM:-}" ]; then
  (cd "$root" && cmake --preset wasm && cmake --build --preset wasm) >&2
  SHD_WASM=$root/build/wasm/bindings/js/shd.wasm
fi
python3 "$source/../generate.py" js
stage=$(mktemp -d)
trap 'rm -rf "$stage"' EXIT
cp -r "$source"/{package.json,README.md,lib,examples} "$root/LICENSE" "$stage"
cp "$SHD_WASM" "$stage/lib/shd.wasm"
(cd "$stage" && npm pack --silent --pack-destination "$folder")
