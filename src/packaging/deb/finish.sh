#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Completes Debian packages of CPack: copyright and changelogs, compressed manuals, a trigger in place of calls of
# ldconfig, Multi-Arch, and checksums of the files as they are then. The debug information of the files of a package
# goes to a package with the suffix -dbgsym, where Debian's debuggers look for it.
# Usage: finish.sh package.deb...
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(stat -c %Y "$here/../../../CHANGELOG.md")} # dpkg-deb writes it, too
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# key: its value in the control file
field() { sed -n "s/^$1: //p" "$work/tree/DEBIAN/control"; }

# key, value: adds or replaces a field of the control file, which ends with the description
set_field() {
  sed -i -e "/^$1: /d" -e "/^Description: /i $1: $2" "$work/tree/DEBIAN/control"
}

write_documents() {
  local folder=$work/tree/usr/share/doc/$1
  mkdir -p "$folder"
  python3 "$here/documents.py" "$folder" --version "$(field Version)" --maintainer "$(field Maintainer)"
  rm -f "$work/tree/usr/share/doc/shd/"{LICENSE,CHANGELOG.md} # they are in the files above
}

# Prints the files of the package that are programs or libraries.
list_binaries() {
  local file
  find "$work/tree/usr" -type f -print0 | while IFS= read -r -d '' file; do
    [ "$(head -c 4 "$file" | tr -d '\0')" != $'\x7fELF' ] || echo "$file"
  done
}

# Copies debug information to the tree of the -dbgsym package, below the number of the build.
split_debug() {
  local file id folder=$work/debug/usr/lib/debug/.build-id
  rm -rf "$work/debug"
  list_binaries | while IFS= read -r file; do
    readelf --wide --section-headers "$file" | grep -F ' .debug_info ' >/dev/null || continue
    id=$(readelf --notes "$file" | sed -n 's/^ *Build ID: //p')
    mkdir -p "$folder/${id:0:2}"
    objcopy --only-keep-debug --compress-debug-sections "$file" "$folder/${id:0:2}/${id:2}.debug"
    chmod 644 "$folder/${id:0:2}/${id:2}.debug"
  done
}

# Debian's tools strip these sections, too; CPack's strip does not.
strip_sections() {
  local file
  list_binaries | while IFS= read -r file; do
    strip --strip-unneeded --remove-section=.comment --remove-section=.note "$file"
  done
}

# tree, package file: checksums, and the package
pack() {
  (cd "$1" && find usr -type f -print0 | LC_ALL=C sort -z | xargs -0 md5sum >DEBIAN/md5sums)
  chmod -R u=rwX,go=rX "$1"
  chmod 644 "$1/DEBIAN/"*
  dpkg-deb --root-owner-group -Zxz --build "$1" "$2" >/dev/null
}

# package file, name of the package: the -dbgsym package, if there is debug information
pack_debug() {
  local field name=$2-dbgsym
  [ -d "$work/debug" ] || return 0
  mkdir -p "$work/debug/DEBIAN" "$work/debug/usr/share/doc"
  ln -s "$2" "$work/debug/usr/share/doc/$name"
  {
    echo "Package: $name"
    for field in Source Version Architecture Maintainer; do echo "$field: $(field "$field")"; done
    echo "Auto-Built-Package: debug-symbols"
    echo "Installed-Size: $(du -k --apparent-size -s "$work/debug/usr" | cut -f 1)"
    echo "Depends: $2 (= $(field Version))"
    echo "Section: debug"
    echo "Priority: optional"
    echo "Multi-Arch: same"
    echo "Description: debug symbols for $2"
    echo "Build-Ids: $(cd "$work/debug/usr/lib/debug/.build-id" && find . -name '*.debug' -printf '%P\n' |
      sed -e 's,/,,' -e 's/[.]debug$//' | LC_ALL=C sort | paste -s -d ' ')"
  } >"$work/debug/DEBIAN/control"
  pack "$work/debug" "$(dirname "$1")/$(basename "$1" | sed "s/^$2_/${name}_/")"
}

# The trigger of libc-bin runs ldconfig once after all packages of a call of dpkg.
write_trigger() {
  rm -f "$work/tree/DEBIAN/postinst" "$work/tree/DEBIAN/postrm"
  [ ! -f "$work/tree/DEBIAN/shlibs" ] || echo 'activate-noawait ldconfig' >"$work/tree/DEBIAN/triggers"
}

finish() {
  local name
  rm -rf "$work/tree"
  dpkg-deb --raw-extract "$1" "$work/tree"
  name=$(field Package)
  write_documents "$name"
  split_debug
  strip_sections
  write_trigger
  find "$work/tree/usr/share/man" -type f ! -name '*.gz' -exec gzip -9n {} + 2>/dev/null || true
  case $name in
    *-doc | *-tools | python3-*) set_field Multi-Arch foreign ;;
    *) set_field Multi-Arch same ;;
  esac
  # Any revision of a version has its functions.
  [ ! -f "$work/tree/DEBIAN/shlibs" ] || sed -i -E 's/-[0-9]+\)$/)/' "$work/tree/DEBIAN/shlibs"
  set_field Installed-Size "$(du -k --apparent-size -s "$work/tree/usr" | cut -f 1)"
  pack "$work/tree" "$1"
  pack_debug "$1" "$name"
}

for package in "$@"; do finish "$package"; done
