#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Frames in LÖVE have the bits of frames in plain luajit. Usage: test.sh LOVE LUAJIT PICTURE.png
set -euo pipefail
here=$(dirname "$0")
ticks=7
export ALSOFT_DRIVERS=null
shown=$(timeout 60 "$1" "$here" --test "$ticks" "$3")
expected=$("$2" "$here/plain.lua" "$ticks")
echo "$shown in LÖVE, $expected in luajit"
[ "$shown" = "$expected" ]
[ -s "$3" ]
