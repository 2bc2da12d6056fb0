#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packs the npm package, installs the tarball in an empty folder, draws a picture there, and compiles programs with the
# declarations of the package. Exit code 77: the registry of npm, which has the compiler, cannot be reached.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
rm -rf "$WORK/empty"
mkdir -p "$WORK/empty"
tarball=$("$source/pack.sh" "$WORK/empty")
cd "$WORK/empty"
npm init -y >/dev/null
npm install --offline --no-audit --no-fund "./$tarball" >/dev/null
unset SHD_WASM SHD_WASM_THREADS  # the files of the package
cp node_modules/shd/examples/{hello,png}.mjs .
"$NODE" hello.mjs picture.png
"$NODE" -e '
  const bytes = require("fs").readFileSync("picture.png");
  const rows = require("zlib").inflateSync(bytes.subarray(41, -16));
  if (bytes.readUInt32BE(16) !== 480 || rows.length !== 320 * 1921) throw new Error("no picture of 480 x 320");
  const colours = new Set();
  for (let i = 0; i < rows.length - 4; i += 97) colours.add(rows.readUInt32BE(i));
  if (colours.size < 500) throw new Error(`only ${colours.size} colours`);'
"$NODE" --input-type=module --eval '
  import { load } from "shd/threads";
  const shd = await load({ threads: 2 });
  if (new shd.Context().workerCount !== 2) throw new Error("no threads");'
cd node_modules/shd/lib
for file in shd.wasm shd-threads.wasm; do
  echo "$file: $(stat -c %s "$file") bytes, by gzip $(gzip -9c "$file" | wc -c)"
done
cd ../../..
echo "$tarball: $(stat -c %s "$tarball") bytes"
WORK=$PWD "$source/tests/types.sh" node_modules/shd
