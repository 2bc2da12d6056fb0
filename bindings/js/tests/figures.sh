#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Drives the figures in Chromium. Screenshots are in $WORK/figures. Exit code 77: the registry of npm cannot be reached.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$WORK/figures"
cd "$WORK/figures"
"$here/npm_install.sh" playwright-core
exec "$NODE" "$here/figures.mjs" "$CHROMIUM" "$WORK/figures"
