#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs the programs of README.md in Chromium. Screenshots are in $WORK/readme.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$WORK/readme"
cd "$WORK/readme"
"$here/npm_install.sh" playwright-core three
"$NODE" "$here/readme_pages.mjs" "$CHROMIUM" "$WORK/readme"
