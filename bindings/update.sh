#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Writes everything under bindings/ that is generated from the headers. Run it after a change of include/shd.
set -euo pipefail
cd "$(dirname "$0")"
python3 describe.py
python3 cpp/generate.py
python3 python/generate.py
python3 js/generate.py
python3 lua/generate.py
