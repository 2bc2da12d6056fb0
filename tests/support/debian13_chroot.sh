# SPDX-License-Identifier: MIT
# Functions for a chroot of Debian 13 (trixie) in build/debian13, to be sourced at the root of the project by a script
# that runs as root on a Debian with debootstrap. The chroot is made at the first call and reused later, with the
# packages and builds that are in it. Delete it while no call runs to start afresh. The mirror is the one that the host's
# apt uses; SHD_MIRROR=<url> names another one.

suite=trixie
root=$PWD/build/debian13

say() { printf '\n== %s\n' "$*"; }
die() {
  echo "$0: $*" >&2
  exit 1
}

mirror() {
  local url=${SHD_MIRROR:-}
  # shellcheck disable=SC2016 # apt expands it
  [ -n "$url" ] || url=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Origin: Debian' \
    'Label: Debian' | head -n 1)
  [ -n "$url" ] || die "apt knows no mirror of Debian: run apt-get update, or set SHD_MIRROR"
  echo "$url"
}

unmount() {
  local folder
  for folder in dev proc; do
    if mountpoint -q "$root/$folder"; then umount -R "$root/$folder"; fi
  done
}

mount_folders() {
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  mount --make-rslave "$root/dev" # so that unmounting here leaves the host's /dev alone
}

# A chroot that is complete has a file .ready; a failed debootstrap leaves none behind.
make_chroot() {
  [ ! -e "$root/.ready" ] || return 0
  local url
  url=$(mirror)
  say "debootstrap $suite from $url"
  rm -rf --one-file-system "$root"
  mkdir -p "$root"
  debootstrap --variant=minbase "$suite" "$root" "$url"
  touch "$root/.ready"
}

inside() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 "$@"; }

# package...: installs those that are missing
install_packages() {
  # shellcheck disable=SC2016 # dpkg-query expands it
  if inside dpkg-query -W -f '${db:Status-Abbrev}\n' "$@" 2>/dev/null | grep -qv '^ii' ||
    ! inside dpkg-query -W "$@" >/dev/null 2>&1; then
    say "packages: $*"
    inside apt-get update -q
    inside DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends "$@"
  fi
}

# The time stamps of the files stay, so that a later call builds what has changed.
copy_sources() {
  rm -rf "$root/shd"
  mkdir -p "$root/shd" "$root/shd-build"
  git ls-files -z | tar --create --null --files-from - | tar --extract --directory "$root/shd"
}

# Makes the chroot if it is missing, and opens it until the script ends.
open_chroot() {
  [ "$(id -u)" -eq 0 ] || die "needs root, for chroot and mount"
  unmount # what a killed call may have left
  make_chroot
  trap unmount EXIT
  mount_folders
}
