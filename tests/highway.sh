#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compiles every file with kernels against the headers of the newest Highway, so that the sources stay portable to it.
#
#   tests/highway.sh [suite]     a suite of Debian; the default, sid, has the newest package. `trixie` is Debian 13
#
# Only the syntax and the templates are checked, for AVX-512: its vectors of 64 bytes have the most levels of halves.
# The headers of libhwy-dev are unpacked below build/highway and not installed. CXX names the compiler (default: g++).
# Skipped if the package cannot be fetched.
set -euo pipefail
cd "$(dirname "$0")/.."

suite=${1:-sid}
root=$PWD/build/highway/$suite
keyring=/usr/share/keyrings/debian-archive-keyring.gpg

# Options of apt for a state of its own, so that the machine's lists of packages stay as they are.
fetch_headers() {
  local url apt=(-q -o "Dir::Etc::sourcelist=$root/sources.list" -o Dir::Etc::sourceparts=-
                 -o "Dir::State::lists=$root/lists" -o "Dir::Cache=$root/cache" -o Acquire::Languages=none
                 -o APT::Sandbox::User=root)
  # shellcheck disable=SC2016 # apt expands it
  url=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Origin: Debian' 'Label: Debian' | head -n 1)
  rm -rf "$root"
  mkdir -p "$root/lists/partial" "$root/cache/archives/partial"
  echo "deb [signed-by=$keyring] ${url:-http://deb.debian.org/debian} $suite main" >"$root/sources.list"
  apt-get "${apt[@]}" update && (cd "$root" && apt-get "${apt[@]}" download libhwy-dev) &&
    dpkg -x "$root"/libhwy-dev_*.deb "$root/headers"
}

mkdir -p build
if [ "${SHD_NO_INSTALL:-0}" = 1 ]; then
  echo "skipped: SHD_NO_INSTALL=1"
  exit 0
fi
fetch_headers >build/highway.log 2>&1 || {
  echo "skipped: libhwy-dev of $suite cannot be fetched (build/highway.log)"
  exit 0
}

mapfile -t files < <(grep -rl --include='*.cpp' 'hwy/foreach_target.h' src | sort)
echo "$(basename "$root"/libhwy-dev_*.deb): ${#files[@]} files with kernels"
printf '%s\n' "${files[@]}" |
  xargs -P "$(nproc)" -I{} "${CXX:-g++}" -std=c++17 -fsyntax-only -march=skylake-avx512 -ffp-contract=off -Wall -Wextra \
    -DHWY_COMPILE_ONLY_STATIC -DSHD_BUILDING -Iinclude -Isrc -isystem "$root/headers/usr/include" {} ||
  { echo "FAILED"; exit 1; }
echo "all of them compile"
