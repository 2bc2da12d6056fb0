#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the module, and makes a folder with it and the project that Godot can open.
#
#   GODOT_HEADERS=FOLDER/include SHD_LIBRARY=/usr/local/lib/libshd.so build.sh OUTPUT
#
# SHD_INCLUDE is the folder of the headers of shd, CC the compiler.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
output=${1:?usage: build.sh OUTPUT}
library=$(realpath "${SHD_LIBRARY:?the path of libshd.so}")
mkdir -p "$output"
cp "$here"/project/* "$output/"
"${CC:-cc}" -std=c99 -O2 -fPIC -shared -fvisibility=hidden -ffp-contract=off -Wall -Wextra -Werror \
  -I "${SHD_INCLUDE:-$here/../../../include}" -isystem "${GODOT_HEADERS:?the folder of gdnative_api_struct.gen.h}" \
  "$here/module.c" "$here/scene.c" "$library" -lm -Wl,-rpath,"$(dirname "$library")" -o "$output/libshd_godot.so"
