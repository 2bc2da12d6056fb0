#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The footprints in docs/pictures are what the library draws. Usage: check_pictures.sh SHD-FOOTPRINTS FOLDER
set -euo pipefail
program=$1
folder=$2
rm -rf "$folder"
mkdir -p "$folder"
"$program" "$folder" >/dev/null
status=0
for picture in "$folder"/*.svg; do
  cmp "$picture" "$(dirname "$0")/pictures/${picture##*/}" || status=1
done
[ "$status" = 0 ] || echo "build the target docs-pictures, and look at the pictures"
exit "$status"
