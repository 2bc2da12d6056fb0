#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages shd-sys with the sources of libshd, builds the package from these sources, and compares the three programs.
# The sources are copied into a copy of the crates, because a package has files of its own folder only.
#   CARGO, PYTHON, WORK: commands and a folder for the files
set -euo pipefail
rust=$(cd "$(dirname "$0")/.." && pwd)
root=$(cd "$rust/../.." && pwd)
crates="$WORK/crates"
unset SHD_LIB_DIR

"$PYTHON" "$root/bindings/generate.py" rust
rm -rf "$crates" "$WORK/target"
mkdir -p "$crates"
cp -r "$rust"/{Cargo.toml,Cargo.lock,shd,shd-sys} "$crates"
cp "$root/LICENSE" "$crates/shd"
cp "$root/LICENSE" "$crates/shd-sys"
source="$crates/shd-sys/source"
mkdir -p "$source/bindings/c" "$source/bindings/cpp"
cp -r "$root"/{CMakeLists.txt,include,src} "$source"
cp "$root/bindings/CMakeLists.txt" "$source/bindings"
cp "$root/bindings/c/CMakeLists.txt" "$source/bindings/c"
cp "$root"/bindings/cpp/{CMakeLists.txt,shd.hpp,shd_api.hpp} "$source/bindings/cpp"

cd "$crates"
export CARGO_TARGET_DIR="$WORK/target"
list=$("$CARGO" package --list --offline --allow-dirty -p shd-sys)
for file in src/api.rs build/main.rs source/CMakeLists.txt source/src/shd.map source/include/shd/shd.h LICENSE; do
  grep -qx "$file" <<<"$list" || { echo "shd-sys: the package has no $file"; exit 1; }
done
"$CARGO" package --list --offline --allow-dirty -p shd | grep -qx examples/programs.rs
"$CARGO" package --offline --allow-dirty --no-verify -p shd-sys
package=$(echo "$WORK"/target/package/shd-sys-*.crate)
echo "$(wc -l <<<"$list") files, $(stat -c %s "$package") bytes"

rm -rf shd-sys
mkdir shd-sys
tar -xzf "$package" -C shd-sys --strip-components 1
"$CARGO" build --release --offline -p shd --example programs
"$PYTHON" "$root/bindings/programs.py" check "$WORK/target/release/examples/programs"
# The program needs no libshd.so.
if ldd "$WORK/target/release/examples/programs" | grep libshd; then exit 1; fi
