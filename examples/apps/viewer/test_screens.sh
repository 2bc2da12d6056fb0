#!/bin/sh
# SPDX-License-Identifier: MIT
# Screenshots of the viewer, compared with pictures that are rendered without a window.
#
#     test_screens.sh VIEWER CHECK_SCREEN FOLDER
#
# Runs under Xvfb, or with SDL's dummy video driver if there is no Xvfb. One test drags the mouse with xdotool.
set -u
viewer=$1 check=$2 folder=$3
mkdir -p "$folder" && cd "$folder" || exit 1
failures=0
server=

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

stop() {
  [ -z "$server" ] || kill "$server" 2>/dev/null
}
trap stop EXIT

if command -v Xvfb >/dev/null; then
  # Xvfb picks a free display and writes its number.
  rm -f display
  timeout 295 Xvfb -displayfd 3 -screen 0 1400x900x24 -nolisten tcp 3>display 2>/dev/null &
  server=$!
  for _ in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
    [ -s display ] && break
    sleep 0.25
  done
  DISPLAY=:$(cat display)
  export DISPLAY
  SDL_VIDEODRIVER=x11
else
  echo "no Xvfb (Debian: xvfb): SDL's dummy video driver instead"
  SDL_VIDEODRIVER=dummy
fi
export SDL_VIDEODRIVER

# name, options: a screenshot whose pixels and hash are those of the library alone
shoot() {
  name=$1
  shift
  timeout 100 "$viewer" --scale 1 "$@" --screenshot "$name.png" >"$name.txt" || fail "$name: exit code $?"
  timeout 100 "$check" "$name.png" --scale 1 "$@" >"$name.check" || fail "$name: $(cat "$name.check")"
  hash=$(sed -n 's/^hash //p' "$name.txt")
  grep -q "hash $hash" "$name.check" || fail "$name: the window has hash $hash, $(cat "$name.check")"
}

# name, pattern: a line of the report
expect() {
  grep -q "$2" "$1.txt" || fail "$1: no line \"$2\" in: $(cat "$1.txt")"
}

shoot default
shoot wipe --filter nearest --b --filter ewa --wipe 0.4
expect wipe "^divider 363$"
[ "$(sed -n 's/^hash //p' wipe.txt)" != "$(sed -n 's/^hash //p' default.txt)" ] || fail "wipe: the default picture"
shoot pixel --filter ewa --click 640,236
expect pixel "surface \"floor\" taps [1-9][0-9]"
expect pixel "^replay exact$"
shoot click-b --filter nearest --b --filter anisotropic --wipe 0.5 --click 700,110
expect click-b "side 1 surface \"floor\" taps [1-9][0-9]"
shoot magnifier --samples 1 --magnify 620,330
shoot level --show level --size 1000x700 --samples 1
shoot torus --model torus --surface toon --texture tiles --floor off --samples 1

# A file with a texture, which is a picture of the viewer itself.
timeout 60 "$viewer" --picture paint.png --samples 1 --size 700x430 || fail "picture: exit code $?"
cat >quad.obj <<EOF
mtllib quad.mtl
v -1 0 1
v 1 0 1
v 1 1 -1
v -1 1 -1
vt 0 0
vt 2 0
vt 2 2
vt 0 2
usemtl paint
f 1/1 2/2 3/3 4/4
EOF
printf 'newmtl paint\nKd 1 1 1\nmap_Kd paint.png\n' >quad.mtl
shoot file --model quad.obj --filter ripmap --click 460,400
expect file "surface \"paint\" taps 16 levels 4"

# The weighted sum of the taps is the sampled value, within 1e-5.
awk '/^weighted/ { for (i = 2; i <= 4; ++i) w[i] = $i } /^sampled/ { for (i = 2; i <= 4; ++i) s[i] = $i }
     END { for (i = 2; i <= 4; ++i) { d = w[i] - s[i]; if (d > 1e-5 || d < -1e-5 || s[i] == 0) exit 1 } }' pixel.txt ||
  fail "pixel: the weighted sum is not the sampled value: $(cat pixel.txt)"

# Bad input: a message in the window, a text on stderr, exit code 1; 2 for the command line.
printf 'ply\nformat ascii 1.0\nelement vertex 99999999\nnonsense' >corrupt.ply
for bad in /nonexistent/model.obj corrupt.ply; do
  name=bad-$(basename "$bad")
  timeout 60 "$viewer" --scale 1 --model "$bad" --screenshot "$name.png" >"$name.txt" 2>"$name.err"
  code=$?
  [ "$code" = 1 ] || fail "$name: exit code $code instead of 1"
  grep -q "shd-viewer: .*$(basename "$bad")" "$name.err" || fail "$name: stderr has no message: $(cat "$name.err")"
  "$check" "$name.png" --error >"$name.check" || fail "$name: no message: $(cat "$name.check")"
done
timeout 60 "$viewer" --filter fancy >usage.txt 2>&1
[ $? = 2 ] || fail "usage: exit code is not 2"

# id: presses S until there is a picture that differs from first.png, for at most half a minute. A picture under way
# is late on a busy machine.
save_other() {
  for _ in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
    timeout 10 xdotool windowfocus "$1" key s  # the focus, because Xvfb has no window manager
    sleep 1.5
    [ -s shd-viewer.png ] && ! cmp -s first.png shd-viewer.png && return 0
  done
  return 1
}

# A drag of the real mouse turns the camera: S then saves another picture than before.
if [ "$SDL_VIDEODRIVER" = x11 ] && command -v xdotool >/dev/null; then
  rm -f shd-viewer.png first.png
  timeout 120 "$viewer" --scale 1 --samples 1 --occlusion off &
  window=$!
  id=$(timeout 20 xdotool search --sync --onlyvisible --name shd-viewer | head -n 1)
  save_other "$id" || fail "drag: S saved no picture"
  mv shd-viewer.png first.png
  timeout 20 xdotool mousemove --window "$id" 400 400 mousedown 1 mousemove_relative --sync 60 0 \
    mousemove_relative --sync 80 20 mouseup 1
  save_other "$id" || fail "drag: the picture is the same"
  kill "$window" 2>/dev/null
  wait "$window" 2>/dev/null
else
  echo "no drag: it needs Xvfb and xdotool (Debian: xvfb xdotool)"
fi

[ "$failures" = 0 ] && echo "all good"
[ "$failures" = 0 ]
