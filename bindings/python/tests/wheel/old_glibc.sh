#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs the tests of the package with the wheel of $WORK/dist in Debian 11 (glibc 2.31, Python 3.9), as root.
# Exit code 77: debootstrap or its packages cannot be had.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
wheel=$(echo "$WORK"/dist/shd-*.whl)
if [ ! -e "$wheel" ]; then
  echo "skipped: no wheel in $WORK/dist; wheels.sh makes it"
  exit 77
fi
if [ "$(id -u)" != 0 ] || ! command -v debootstrap > /dev/null; then
  echo "skipped: not root, or no debootstrap (Debian: debootstrap)"
  exit 77
fi
if [ "${1:-}" != mounted ]; then exec unshare --mount "$0" mounted; fi  # mounts end with this process
chroot=$WORK/debian11
trap 'umount "$chroot/proc" 2> /dev/null || true; rm -rf --one-file-system "$chroot"' EXIT
rm -rf "$chroot"
mirror=$(grep -hoE 'https?://[^ ]+/debian/? *$' /etc/apt/sources.list.d/debian.sources \
  /etc/apt/sources.list 2> /dev/null | head -1 || true)
if ! debootstrap --variant=minbase --include=python3-numpy bullseye "$chroot" $mirror > "$WORK/debian11.log" 2>&1; then
  echo "skipped: debootstrap failed: $(tail -1 "$WORK/debian11.log")"
  exit 77
fi
mount -t proc proc "$chroot/proc"
mkdir "$chroot/shd"
"$PYTHON" -m zipfile -e "$wheel" "$chroot/shd/site"
cp -r "$here/.." "$chroot/shd/tests"
inside() { chroot "$chroot" env PYTHONPATH=/shd/site PYTHONDONTWRITEBYTECODE=1 "$@"; }
inside getconf GNU_LIBC_VERSION
inside python3 -m shd /shd/picture.png --size 64 48
cmp "$chroot/shd/picture.png" "$WORK/expected.png"
# The package is that of the wheel, so the folder of the tests has no package beside it.
inside python3 /shd/tests/run.py
inside python3 /shd/tests/run.py golden
