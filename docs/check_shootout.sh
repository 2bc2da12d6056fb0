#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks the choice of the report that the target docs copies: that of the user, that of examples/shootout.sh, a quick one
# of the program, or none with a message.
# Usage: check_shootout.sh CMAKE FOLDER
set -euo pipefail
cmake=$1 folder=$2
script=$(cd "$(dirname "$0")" && pwd)/add_shootout.cmake
rm -rf "$folder"
mkdir -p "$folder"

fail() {
  echo "docs.shootout: $1" >&2
  exit 1
}

# report, default report, program
add() {
  rm -rf "$folder/html"
  "$cmake" "-DREPORT=$1" "-DDEFAULT_REPORT=$2" "-DPROGRAM=$3" "-DSCRATCH=$folder/quick" "-DTO=$folder/html" \
    -P "$script" 2>&1
}

expect() {
  [ "$(cat "$folder/html/shootout.html")" = "$1" ] || fail "the page is not that of $1"
}

echo user >"$folder/user.html"
echo default >"$folder/default.html"
cat >"$folder/program" <<'END'
#!/bin/sh
[ "$1" = --quick ] && [ "$2" = -o ] && mkdir -p "$3" && echo program >"$3/shootout.html"
END
printf '#!/bin/sh\nexit 3\n' >"$folder/broken"
chmod +x "$folder/program" "$folder/broken"

add "$folder/user.html" "$folder/default.html" "$folder/program" >/dev/null
expect user
add "" "$folder/default.html" "$folder/program" >/dev/null
expect default
add "" "$folder/none.html" "$folder/program" >/dev/null
expect program
add "" "$folder/none.html" "$folder/none" | grep -q "examples/shootout.sh" || fail "no report, and no message"
if add "$folder/none.html" "$folder/default.html" "" >"$folder/log"; then fail "a missing report of the user is accepted"; fi
grep -q "SHD_SHOOTOUT_REPORT" "$folder/log" || fail "the message has no name of the variable"
if add "" "$folder/none.html" "$folder/broken" >"$folder/log"; then fail "a program that fails is accepted"; fi
echo "docs.shootout: 6 choices"
