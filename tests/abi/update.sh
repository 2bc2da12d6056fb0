#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Writes the interface that the tree keeps, from the headers: exported functions, layouts of structs, and with
# abigail-tools the dumps. Run it, and then bindings/update.sh, after a change of include/shd that is meant.
set -euo pipefail
cd "$(dirname "$0")"
include=../../include
for library in shd shd_color shd_embree shd_io shd_scene; do
  python3 symbols.py "$library" --include "$include" --update
  python3 dump.py --include "$include" --library "$library" --dumps . --update || [ $? -eq 77 ]
done
python3 layout.py --include "$include" --output .
