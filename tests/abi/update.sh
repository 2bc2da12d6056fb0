#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Writes what the tree keeps of the headers: the exported functions, bindings/shd.json and bindings/cpp/shd_api.hpp. Run
# it after a change of include/shd that is meant. The lower layers of the other bindings are written, too.
set -euo pipefail
cd "$(dirname "$0")"
for library in shd shd_color shd_embree shd_io shd_scene; do
  python3 symbols.py "$library" --include ../../include --update
done
cd ../../bindings
python3 describe.py
python3 cpp/generate.py
python3 generate.py
