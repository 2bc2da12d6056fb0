#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes shd-<version>.tgz, the package for npm, in a folder: pack.sh [folder]. SHD_WASM and SHD_WASM_THREADS are the
# paths of shd.wasm and shd-threads.wasm, by default those of the presets `wasm` and `wasm-threads`, which are built with
# the libraries of libraries.sh if their sources can be had.
set -euo pipefail
source=$(cd "$(dirname "$0")" && pwd)
root=$source/../..
folder=$(cd "${1:-.}" && pwd)
make_libraries() { "$source/libraries.sh" "$root/build/wasm-libraries" >&2 || [ $? -eq 77 ]; }
build() { (cd "$root" && cmake --preset "$1" && cmake --build --preset "$1") >&2; }
if [ -z "${SHD_WASM:-}" ]; then
  make_libraries
  build wasm
  SHD_WASM=$root/build/wasm/bindings/js/shd.wasm
fi
if [ -z "${SHD_WASM_THREADS:-}" ]; then
  make_libraries
  build wasm-threads
  SHD_WASM_THREADS=$root/build/wasm-threads/bindings/js/shd-threads.wasm
fi
python3 "$source/../generate.py" js
stage=$(mktemp -d)
trap 'rm -rf "$stage"' EXIT
cp -r "$source"/{package.json,README.md,lib,examples} "$root/LICENSE" "$stage"
mkdir "$stage/licenses"  # of all that is linked in
packages=(emscripten libhwy-dev)
if grep -q shd_scene_load_memory "$SHD_WASM"; then
  packages+=(libpng-dev libjpeg62-turbo-dev zlib1g-dev libzstd-dev libmeshoptimizer-dev nlohmann-json3-dev)
fi
for package in "${packages[@]}"; do
  file=/usr/share/doc/$package/copyright
  [ -e "$file" ] || { echo "$file is absent: the package needs this licence (Debian: $package)" >&2; exit 1; }
  cp "$file" "$stage/licenses/$package.txt"
done
cp "$SHD_WASM" "$stage/lib/shd.wasm"
cp "$SHD_WASM_THREADS" "$stage/lib/shd-threads.wasm"
(cd "$stage" && npm pack --silent --pack-destination "$folder")
