#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Does shd-render do what its help says? Usage: check.sh SHD-RENDER FOLDER
set -euo pipefail
render=$1
folder=$2
models=/usr/share/assimp/models
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
failed=0

# expect CODE TEXT ARGUMENTS...: exit code, and a piece of what is said
expect() {
  local code=$1 text=$2 got=0
  shift 2
  "$render" "$@" >said.txt 2>&1 || got=$?
  if [ "$got" != "$code" ] || ! { [ -z "$text" ] || grep -qF -- "$text" said.txt; }; then
    echo "shd-render $*: exit code $got, wanted $code and \"$text\"; said:"
    cat said.txt
    failed=1
  fi
}

# written FILE SIGNATURE: the file begins with these bytes, in hexadecimal
written() {
  if [ "$(head -c 4 "$1" | od -An -tx1 | tr -d ' \n')" != "$2" ]; then
    echo "$1 is missing or not what its name says"
    failed=1
  fi
}

expect 0 "Exit codes" --help
expect 0 "" --size 96x64 --tessellation 4 -o teapot.png
written teapot.png 89504e47
expect 0 "triangles" --stats --size 96x64 --aov --texture checker --model lambert --frequency flat -o teapot.exr
written teapot.exr 762f3101
expect 0 "" --size 64x64 --no-color --background 0.2,0.3,0.4 --light 2,2,2:8,8,8 --sun 0,1,0 --frequency gouraud \
  --filter nearest --orbit -90,90,3 -o top.png
expect 0 "" --size 64x64 --threads 1 --simd scalar --no-color -o one.png
expect 0 "" --size 64x64 --threads 5 --no-color -o many.png
cmp one.png many.png || failed=1

expect 2 "--colour is not an option" --colour
expect 2 "--colour is not an option" --colour red
expect 2 "--size needs a value" --size
expect 2 "WIDTHxHEIGHT" --size 0x10
expect 2 "WIDTHxHEIGHT" --size 10x10x10
expect 2 "one of nearest bilinear trilinear" --filter best
expect 2 "one model at a time" a.obj b.obj
expect 2 "X,Y,Z" --sun 0,0,0
expect 2 "X,Y,Z" --light 1,2,nan
expect 2 "does not end in" -o picture.gif
expect 2 "does not end in .exr" --aov -o picture.png
expect 3 "no-such-model.obj" no-such-model.obj
expect 3 "no-such-texture.png" --texture no-such-texture.png
expect 4 "no-such-folder" --size 8x8 -o no-such-folder/picture.png
printf 'v 0 0 0\nv 1 0 0\nl 1 2\n' >line.obj
expect 3 "line.obj" line.obj
printf 'mtllib tri.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3\n' >tri.obj
printf 'newmtl m\nKd 1 1 1\nmap_Kd C:\\art\\Missing.png\n' >tri.mtl
expect 0 "its material is plain" --size 8x8 tri.obj
mkdir -p Textures
cp teapot.png Textures/Skin.PNG
printf 'newmtl m\nKd 1 1 1\nmap_Kd TEXTURES\\skin.png\n' >tri.mtl
expect 0 "" --size 8x8 tri.obj
[ ! -s said.txt ] || { cat said.txt; failed=1; }

for model in Collada/duck.dae OBJ/spider.obj glTF2/BoxTextured-glTF-Binary/BoxTextured.glb; do
  [ ! -f "$models/$model" ] || expect 0 "" --size 96x64 -o model.png "$models/$model"
done
exit $failed
