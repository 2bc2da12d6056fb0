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

# command...: runs it in the chroot. Its mounts belong to a namespace that ends with it, even if a script is killed:
# otherwise build/ would hold the /dev of the host, and deleting build/ would delete devices.
inside() {
  # shellcheck disable=SC2016 # the inner bash expands it
  unshare --mount --propagation private bash -euc '
    root=$1
    shift
    mount -t proc proc "$root/proc"
    mount --rbind /dev "$root/dev"
    exec chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 "$@"' bash "$root" "$@"
}

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

# Makes the chroot if it is missing.
open_chroot() {
  [ "$(id -u)" -eq 0 ] || die "needs root, for chroot and mount"
  make_chroot
}
