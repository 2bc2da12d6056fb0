#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages the crates, builds the package of shd-sys from the sources of libshd inside it, and compares the three
# programs.
#   CARGO, PYTHON, WORK: commands and a folder for the files
set -euo pipefail
rust=$(cd "$(dirname "$0")/.." && pwd)
unset SHD_LIB_DIR
rm -rf "$WORK"
"$rust/pack.sh" "$WORK"

cd "$WORK/crates"
export CARGO_TARGET_DIR="$WORK/target"
package=$(echo "$WORK"/shd-sys-*.crate)
name=$(basename "$package" .crate)
list=$(tar -tzf "$package")
for file in src/api.rs build/main.rs source/CMakeLists.txt source/src/shd.map source/include/shd/shd.h LICENSE; do
  grep -qx "$name/$file" <<<"$list" || { echo "shd-sys: the package has no $file"; exit 1; }
done
"$CARGO" package --list --offline --allow-dirty -p shd | grep -x examples/programs.rs > /dev/null
echo "$(wc -l <<<"$list") files, $(stat -c %s "$package") bytes"

rm -rf shd-sys
mkdir shd-sys
tar -xzf "$package" -C shd-sys --strip-components 1
"$CARGO" build --release --offline -p shd --example programs
"$PYTHON" "$rust/../programs.py" check "$WORK/target/release/examples/programs"
# The program needs no libshd.so.
if ldd "$WORK/target/release/examples/programs" | grep libshd; then exit 1; fi
