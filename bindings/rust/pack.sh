#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes the packages of the crates in a folder: pack.sh FOLDER. shd-sys has the sources of libshd, in a copy of the
# crates, FOLDER/crates, because a package has files of its own folder only. Needs no network. CARGO and PYTHON are the
# commands. Packages of crates that depend on each other need Cargo 1.90; an older one packages shd-sys alone.
set -euo pipefail
rust=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$rust/../.." && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
cargo=${CARGO:-cargo}

"${PYTHON:-python3}" "$root/bindings/generate.py" rust
crates=$folder/crates
rm -rf "$crates"
mkdir -p "$crates"
cp -r "$rust"/{Cargo.toml,Cargo.lock,shd,shd-sys} "$crates"
cp "$root/LICENSE" "$crates/shd"
cp "$root/LICENSE" "$crates/shd-sys"
source=$crates/shd-sys/source
mkdir -p "$source/bindings/c" "$source/bindings/cpp"
cp -r "$root"/{CMakeLists.txt,include,src} "$source"
cp "$root/bindings/CMakeLists.txt" "$source/bindings"
cp "$root/bindings/c/CMakeLists.txt" "$source/bindings/c"
cp "$root"/bindings/cpp/{CMakeLists.txt,shd.hpp,shd_api.hpp} "$source/bindings/cpp"

cd "$crates"
export CARGO_TARGET_DIR=$folder/target
rm -rf "$CARGO_TARGET_DIR/package"
minor=$("$cargo" --version | sed -E 's/^cargo [0-9]+\.([0-9]+)\..*/\1/')
names=(-p shd-sys)
if [ "$minor" -ge 90 ]; then names+=(-p shd); else echo "shd is not packaged: Cargo 1.$minor"; fi
"$cargo" package --offline --allow-dirty --no-verify "${names[@]}"
cp "$CARGO_TARGET_DIR"/package/*.crate "$folder"
