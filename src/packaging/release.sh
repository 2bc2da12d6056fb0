#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes every package of a commit: release.sh [FOLDER [COMMIT]], by default build/release-<version> and HEAD. It signs and
# publishes nothing. The last lines are the files with their sizes; FOLDER/SHA256SUMS has their hashes. A second run for
# the same commit gives the same bytes.
#
#   shd-<version>.tar.gz            the sources, by git archive
#   shd-amalgamated-<version>.tar.gz  libshd as one source
#   *.deb                           Debian packages
#   shd-*.whl                       wheels for Python
#   shd-<version>.tgz               the package for npm
#   *.crate                         the crates
#   Shd.<version>.nupkg             the package for .NET, with the libraries of the wheel
#
# Each is built from the archive of the sources, in FOLDER/stage. A part whose tool is absent is skipped with a message,
# and the exit code is then 77.
set -uo pipefail
root=$(readlink -f "$(dirname "$0")/../..")
commit=$(git -C "$root" rev-parse --verify "${2:-HEAD}^{commit}") || exit 1
version=$(git -C "$root" show "$commit:CMakeLists.txt" | sed -n 's/^project(shd VERSION \([0-9.]*\).*/\1/p')
folder=${1:-$root/build/release-$version}
mkdir -p "$folder/stage"
folder=$(readlink -f "$folder")
stage=$folder/stage source=$folder/stage/shd-$version
export SOURCE_DATE_EPOCH
SOURCE_DATE_EPOCH=$(git -C "$root" show -s --format=%ct "$commit")
export CCACHE_BASEDIR=$source CCACHE_NOHASHDIR=1
jobs=$(nproc)
export JOBS=$jobs
launcher=()
if command -v ccache >/dev/null; then
  launcher=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi

# archive, folder: a tar.gz that depends on the files alone
pack() {
  tar --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX \
    -C "$(dirname "$2")" -c "$(basename "$2")" | gzip -9n >"$1"
}

make_sources() {
  git -C "$root" archive --format=tar --prefix="shd-$version/" "$commit" | gzip -9n >"$folder/shd-$version.tar.gz" &&
    rm -rf "$source" && tar -xzf "$folder/shd-$version.tar.gz" -C "$stage"
}

make_amalgamated() {
  local one=$stage/shd-amalgamated-$version
  python3 "$source/src/packaging/amalgamate.py" "$one" && pack "$one.tar.gz" "$one" && mv "$one.tar.gz" "$folder"
}

make_deb() {
  local multiarch build=$stage/deb
  multiarch=$(dpkg-architecture -qDEB_HOST_MULTIARCH) && command -v file >/dev/null || return 77
  cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr \
    -DCMAKE_INSTALL_LIBDIR="lib/$multiarch" -DCMAKE_INSTALL_LIBEXECDIR="lib/$multiarch" -DCMAKE_SKIP_INSTALL_RPATH=ON \
    -DSHD_DEB=ON -DSHD_BUILD_TESTS=OFF -DSHD_BUILD_EXAMPLES=OFF "${launcher[@]}" &&
    cmake --build "$build" -j "$jobs" && (cd "$build" && rm -f ./*.deb && cpack -G DEB) && mv "$build/"*.deb "$folder"
}

make_wheel() {
  PYTHON=/usr/bin/python3 "$source/bindings/python/wheel.sh" "$stage/wheel" -G Ninja "${launcher[@]}" &&
    cp "$stage/wheel/dist/"*.whl "$folder"
}

make_npm() {
  command -v emcc >/dev/null && command -v npm >/dev/null || return 77
  "$source/bindings/js/pack.sh" "$folder"
}

make_crates() {
  command -v cargo >/dev/null || return 77
  "$source/bindings/rust/pack.sh" "$stage/crates" && cp "$stage/crates/"*.crate "$folder"
}

# The libraries of the wheel need nothing besides glibc.
make_nuget() {
  local native=$stage/native
  ls "$folder/"shd-"$version"-*.whl >/dev/null || return 77
  rm -rf "$native" && python3 -m zipfile -e "$folder/"shd-"$version"-*.whl "$native" &&
    "$source/bindings/csharp/pack.py" "$folder" --native "$native/shd"
}

status=0
for part in sources amalgamated deb wheel npm crates nuget; do
  printf '\n== %s\n' "$part"
  "make_$part"
  result=$?
  case $result in
    0) ;;
    77) echo "skipped: $part needs a tool that is absent"; [ "$status" -ne 0 ] || status=77 ;;
    *) echo "FAILED: $part ($result)"; status=1 ;;
  esac
done

printf '\n== %s\n' "$folder"
cd "$folder" || exit 1
find . -maxdepth 1 -type f ! -name SHA256SUMS -printf '%P\n' | LC_ALL=C sort | xargs sha256sum >SHA256SUMS
while read -r hash name; do printf '%10d  %s  %s\n' "$(stat -c %s "$name")" "${hash:0:16}" "$name"; done <SHA256SUMS
exit "$status"
