#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Completes Debian packages of CPack: copyright and changelogs, compressed manuals, a trigger in place of calls of
# ldconfig, Multi-Arch, and checksums of the files as they are then.
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

# Debian's tools strip these sections, too; CPack's strip does not.
strip_sections() {
  local file
  find "$work/tree/usr" -type f -print0 | while IFS= read -r -d '' file; do
    [ "$(head -c 4 "$file" | tr -d '\0')" = $'\x7fELF' ] || continue
    strip --strip-unneeded --remove-section=.comment --remove-section=.note "$file"
  done
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
  strip_sections
  write_trigger
  find "$work/tree/usr/share/man" -type f ! -name '*.gz' -exec gzip -9n {} + 2>/dev/null || true
  case $name in
    *-doc | *-tools) set_field Multi-Arch foreign ;;
    *) set_field Multi-Arch same ;;
  esac
  # Any revision of a version has its functions.
  [ ! -f "$work/tree/DEBIAN/shlibs" ] || sed -i -E 's/-[0-9]+\)$/)/' "$work/tree/DEBIAN/shlibs"
  set_field Installed-Size "$(du -k --apparent-size -s "$work/tree/usr" | cut -f 1)"
  chmod -R u=rwX,go=rX "$work/tree"
  (cd "$work/tree" && find usr -type f -print0 | LC_ALL=C sort -z | xargs -0 md5sum >DEBIAN/md5sums)
  chmod 644 "$work/tree/DEBIAN/"*
  dpkg-deb --root-owner-group -Zxz --build "$work/tree" "$1" >/dev/null
}

for package in "$@"; do finish "$package"; done
