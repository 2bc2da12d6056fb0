#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh PROGRAM: prints each handle of the program handles in gdb, and compares the lines with the texts below. Exit
# code 77: gdb is absent or may not trace.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
if ! command -v gdb > /dev/null; then
  echo "skipped: package gdb is absent"
  exit 77
fi
program=$1
names=(texture solid none kept sampler mesh material light shadow framebuffer released mistyped)
wanted=(
  "texture: (shd_texture *) 0x: 2D, 2 x 3, SHD_FORMAT_RGBA8, 1 level, 1 layer; 2 references"
  "solid: (shd_texture *) 0x: 3D, 2 x 1 x 3, SHD_FORMAT_RGBA8, 1 level, 1 layer; 1 reference"
  "none: (shd_texture *) 0x"
  "kept: (shd_texture *) 0x: 2D, 2 x 3, SHD_FORMAT_RGBA8, 1 level, 1 layer; 2 references"
  "sampler: (shd_sampler *) 0x: SHD_FILTER_TRILINEAR, wrap SHD_WRAP_REPEAT, SHD_WRAP_REPEAT, SHD_WRAP_REPEAT; 1 reference"
  "mesh: (shd_mesh *) 0x: 3 vertices, 1 triangle; 1 reference"
  "material: (shd_material *) 0x: SHD_MODEL_LAMBERT; 1 reference"
  "light: (shd_light *) 0x: SHD_LIGHT_KIND_POINT, intensity 1, 1, 1; 1 reference"
  "shadow: (shd_shadow *) 0x: SHD_SHADOW_FILTER_HARD, not rendered; 1 reference"
  "framebuffer: (shd_framebuffer *) 0x: 5 x 4, SHD_FORMAT_RGBA32F, 1 sample a pixel; 1 reference"
  "released: (shd_sampler *) 0x: released"
  "mistyped: (shd_mesh *) 0x: not a shd_mesh, but a texture"
)
commands=(-ex "source $root/src/packaging/gdb/libshd-gdb.py" -ex "break stop" -ex run -ex up)
for name in "${names[@]}"; do commands+=(-ex "printf \"$name: \"" -ex "output $name" -ex 'printf "\n"'); done
# ASan: leaks cannot be searched below a debugger.
out=$(ASAN_OPTIONS=detect_leaks=0 gdb -nx -batch -iex 'set auto-load off' -iex 'set debuginfod enabled off' \
  "${commands[@]}" "$program" < /dev/null 2>&1) || true
if grep -q 'ptrace: Operation not permitted' <<< "$out"; then
  echo "skipped: this system does not allow tracing"
  exit 77
fi
# Addresses vary: 0x alone stands in their place.
found=$(sed -E 's/0x[0-9a-f]+/0x/' <<< "$out")
status=0
for line in "${wanted[@]}"; do
  if ! grep -Fxq -- "$line" <<< "$found"; then
    echo "missing: $line"
    status=1
  fi
done
[ "$status" -eq 0 ] || printf '%s\n' "$out"
exit "$status"
