#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs the programs of README.md in Chromium. Screenshots are in $WORK/readme.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$WORK/readme"
cd "$WORK/readme"
[ -f package.json ] || npm init -y >/dev/null
if ! npm install --no-audit --no-fund --silent playwright-core three 2>/dev/null; then
  echo "skipped: playwright-core and three cannot be installed from the registry of npm"
  exit 77
fi
"$NODE" "$here/readme_pages.mjs" "$CHROMIUM" "$WORK/readme"
