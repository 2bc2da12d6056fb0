#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Writes everything under bindings/ that is generated from the headers. Run it after a change of include/shd.
set -euo pipefail
cd "$(dirname "$0")"
python3 describe.py
for language in cpp csharp js lua python rust; do
  python3 "$language/generate.py"
done
