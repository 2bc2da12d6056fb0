#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests the pages that a program writes about itself: every option of --help is in the manual page and in the completion
# of bash, the manual page has no warnings, and bash completes options and values.
# Usage: check_pages.sh PROGRAM PAGES; PAGES.1 and PAGES.bash are those that are installed.
set -euo pipefail
program=$1
page=$2.1
completion=$2.bash
name=$(basename "$program")
failed=0

fail() {
  echo "$name: $*"
  failed=1
}

diff "$page" <("$program" --man) >/dev/null || fail "$page is not of this program"
diff "$completion" <("$program" --completion) >/dev/null || fail "$completion is not of this program"
options=$("$program" --help | grep -oE '^  (-[a-z], )?--[a-z-]+' | grep -oE '[-]-[a-z-]+')
[ "$(wc -l <<<"$options")" -ge 15 ] || fail "--help has few options: $options"
bash -n "$completion"
for option in $options; do
  grep -qF "\\fB${option//-/\\-}\\fP" "$page" || fail "$option is not in $page"
  grep -qE -- "[ \"(|]${option}[ \"|)]" "$completion" || fail "$option is not in $completion"
done

# completed WANTED WORD...: what bash offers for the last word
completed() {
  local wanted=$1 offered
  shift
  # shellcheck disable=SC2016
  offered=$(bash -c '. "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); "_${1//-/_}"; echo "${COMPREPLY[*]}"' \
    bash "$completion" "$@")
  [ "$offered" = "$wanted" ] || fail "completes $* to \"$offered\", not \"$wanted\""
}

completed "--version" "$name" --ver
completed "" "$name" some-file
case $name in
  shd-render) completed "bilinear bicubic bilinear-mip" "$name" --filter bi ;;
  shd-check) completed "less less-equal" "$name" --compare less ;;
  shd-maketx) completed "packbits piz" "$name" --compression p ;;
esac

for section in NAME SYNOPSIS DESCRIPTION OPTIONS "EXIT STATUS" EXAMPLES "SEE ALSO"; do
  grep -qx ".SH $section" "$page" || fail "no section $section in $page"
done
[ "$failed" = 0 ] || exit 1
if command -v mandoc >/dev/null; then
  warnings=$(mandoc -Tlint -W warning "$page" | grep -v "missing date" || true)
elif command -v groff >/dev/null; then
  warnings=$(groff -man -Tutf8 -ww -z "$page" 2>&1)
else
  echo "skipped: neither mandoc nor groff (Debian: groff-base)"
  exit 77
fi
[ -z "$warnings" ] || fail "$page: $warnings"
exit $failed
