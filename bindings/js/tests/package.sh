#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packs the npm package, installs the tarball in an empty folder, draws pictures there in Node and, if CHROMIUM is set, in
# a page, and compiles programs with the declarations of the package. Exit code 77: the registry of npm, which has the compiler, cannot be reached.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
rm -rf "$WORK/empty"
mkdir -p "$WORK/empty"
tarball=$("$source/pack.sh" "$WORK/empty")
cd "$WORK/empty"
npm init -y >/dev/null
npm install --offline --no-audit --no-fund "./$tarball" >/dev/null
unset SHD_WASM SHD_WASM_THREADS  # the files of the package
cp node_modules/shd/examples/{hello,model,png}.mjs .
# file, width, height, colours: the file is a picture of this size with at least so many colours
check_picture() {
  "$NODE" -e '
    const [file, width, height, least] = process.argv.slice(1);
    const bytes = require("fs").readFileSync(file);
    const rows = require("zlib").inflateSync(bytes.subarray(41, -16));
    if (bytes.readUInt32BE(16) !== +width || rows.length !== height * (4 * width + 1)) throw new Error("another size");
    const colours = new Set();
    for (let i = 0; i < rows.length - 4; i += 97) colours.add(rows.readUInt32BE(i));
    if (colours.size < least) throw new Error(`only ${colours.size} colours`);' "$@"
}
"$NODE" hello.mjs picture.png
check_picture picture.png 480 320 500
if grep -q shd_scene_load_memory node_modules/shd/lib/shd.wasm; then
  "$NODE" "$source/tests/scene_files.mjs" models
  for model in model.glb external.gltf square.obj; do
    "$NODE" model.mjs "models/$model" "$model.png"
    check_picture "$model.png" 640 480 100
  done
  [ -z "${CHROMIUM:-}" ] || "$NODE" "$source/tests/scene_page.mjs" "$CHROMIUM" "$PWD"
else
  echo "models were not drawn: the module reads no files"
fi
ls node_modules/shd/licenses
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
