#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# chroot.sh SUITE: with the wheel of $WORK/dist, runs the tests of the package and draws a model in a fresh Debian of
# that suite, which has nothing but Python and NumPy; as root. bullseye has glibc 2.31 and Python 3.9, bookworm is
# Debian 12. Exit code 77: debootstrap or its packages cannot be had.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
suite=$1
wheel=$(echo "$WORK"/dist/shd-*.whl)
if [ ! -e "$wheel" ]; then
  echo "skipped: no wheel in $WORK/dist; wheels.sh makes it"
  exit 77
fi
if [ "$(id -u)" != 0 ] || ! command -v debootstrap > /dev/null; then
  echo "skipped: not root, or no debootstrap (Debian: debootstrap)"
  exit 77
fi
if [ "${2:-}" != mounted ]; then exec unshare --mount "$0" "$suite" mounted; fi  # mounts end with this process
chroot=$WORK/$suite
trap 'umount "$chroot/proc" 2> /dev/null || true; rm -rf --one-file-system "$chroot"' EXIT
rm -rf --one-file-system "$chroot"
mirror=$(grep -hoE 'https?://[^ ]+/debian/? *$' /etc/apt/sources.list.d/debian.sources \
  /etc/apt/sources.list 2> /dev/null | head -1 || true)
if ! debootstrap --variant=minbase --include=python3-numpy "$suite" "$chroot" $mirror > "$WORK/$suite.log" 2>&1; then
  echo "skipped: debootstrap failed: $(tail -1 "$WORK/$suite.log")"
  exit 77
fi
mount -t proc proc "$chroot/proc"
mkdir "$chroot/shd"
"$PYTHON" - "$wheel" "$chroot/shd/site" <<'UNPACK'
import pathlib
import sys
import zipfile
with zipfile.ZipFile(sys.argv[1]) as wheel:  # as pip does, which keeps programs executable
    for entry in wheel.infolist():
        path = pathlib.Path(wheel.extract(entry, sys.argv[2]))
        if entry.external_attr >> 16 & 0o111:
            path.chmod(0o755)
UNPACK
cp -r "$here/.." "$chroot/shd/tests"
inside() { chroot "$chroot" env PYTHONPATH=/shd/site PYTHONDONTWRITEBYTECODE=1 "$@"; }
inside getconf GNU_LIBC_VERSION
inside python3 -m shd /shd/picture.png --size 64 48
cmp "$chroot/shd/picture.png" "$WORK/expected.png"
inside python3 /shd/tests/wheel/model.py /shd/model.png
cmp "$chroot/shd/model.png" "$WORK/model.png"
# The package is that of the wheel, so the folder of the tests has no package beside it.
inside python3 /shd/tests/run.py
inside python3 /shd/tests/run.py golden
