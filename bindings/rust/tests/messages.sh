#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The build script of shd-sys fails with a message that names what is missing.
#   CARGO, WORK: the command and a folder for its files
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p "$WORK/empty"
unset SHD_LIB_DIR
failures=0

# text, variables and features...: a build with these fails and prints the text
expect() {
  local text=$1 output
  local check=("$CARGO" check --offline --locked -p shd-sys)
  shift
  if output=$(env "$@" CARGO_TARGET_DIR="$WORK/target" "${check[@]}" $features 2>&1); then
    echo "no failure, but expected: $text"
    failures=1
  elif [[ $output != *"shd-sys: $text"* ]]; then
    printf 'expected: %s\nprinted:\n%s\n' "$text" "$output"
    failures=1
  else
    echo "printed: $text"
  fi
}

features=""
expect "cmake cannot be run" CMAKE="$WORK/no-cmake"
expect "SHD_LIB_DIR: $WORK/absent:" SHD_LIB_DIR="$WORK/absent"
expect "SHD_LIB_DIR: $(cd "$WORK/empty" && pwd -P) has no libshd" SHD_LIB_DIR="$WORK/empty"
features="--features color,io"
expect "shd_io and shd_color must be installed" CMAKE="$WORK/no-cmake"
features="--features pkg-config"
expect "pkg-config shd:" PKG_CONFIG_LIBDIR="$WORK/empty" PKG_CONFIG_PATH=
exit "$failures"
