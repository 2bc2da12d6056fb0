#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs packages from the registry of npm in this folder: npm_install.sh PACKAGE... Exit code 77: the registry cannot
# be reached. Every other problem is a failure, and the messages of npm are printed.
set -euo pipefail
export npm_config_fetch_timeout=${npm_config_fetch_timeout:-30000}
export npm_config_fetch_retries=1 npm_config_fetch_retry_mintimeout=1000
[ -f package.json ] || npm init -y >/dev/null
if output=$(npm install --no-audit --no-fund "$@" 2>&1); then exit 0; fi
code=$(sed -nE 's/^npm (ERR!|error) code //p' <<<"$output" | head -n 1)
case $code in
  EAI_AGAIN | ENOTFOUND | ECONNREFUSED | ECONNRESET | EHOSTUNREACH | ENETUNREACH | ETIMEDOUT | *TIMEOUT) ;;
  FETCH_ERROR) grep -q 'network timeout at' <<<"$output" || code= ;;
  *) code= ;;
esac
if [ -n "$code" ]; then
  echo "skipped: the registry of npm cannot be reached ($code)"
  exit 77
fi
echo "$output"
exit 1
