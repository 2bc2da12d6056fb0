#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests shd-render against its help text. Usage: check.sh SHD-RENDER FOLDER
set -euo pipefail
render=$1
folder=$2
assets=/usr/share/assimp/models
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
failed=0

# expect CODE TEXT ARGUMENTS...: exit code, and a part of the output
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

# Compares two pictures, which must be equal or different: two lists of options, separated by --.
small=(--size 48x32 --tessellation 4 --no-color)
compare() {
  local wanted=$1 first=()
  shift
  while [ "$1" != -- ]; do first+=("$1") && shift; done
  shift
  expect 0 "" "${small[@]}" "${first[@]}" -o first.png
  expect 0 "" "${small[@]}" "$@" -o second.png
  if cmp -s first.png second.png; then got=same; else got=other; fi
  if [ "$got" != "$wanted" ]; then
    echo "the pictures of ${first[*]} and $* are the $got"
    failed=1
  fi
}
same() { compare same "$@"; }
other() { compare other "$@"; }

expect 0 "Exit codes" --help
expect 0 "" --size 96x64 --tessellation 4 -o teapot.png
written teapot.png 89504e47
expect 0 "triangles" --stats --size 96x64 --aov --texture checker --model lambert --frequency flat -o teapot.exr
written teapot.exr 762f3101
expect 0 "" --size 64x64 --no-color --background 0.2,0.3,0.4 --light 2,2,2:8,8,8 --sun 0,1,0 --frequency gouraud \
  --filter nearest --orbit -90,90,3 -o top.png
expect 0 "" --size 64x64 --threads 1 --simd baseline --no-color -o one.png
expect 0 "" --size 64x64 --threads 5 --no-color -o many.png
cmp one.png many.png || failed=1

# Effects of options, tested on pairs of pictures.
models=(lambert phong blinn-phong normalized ggx gooch toon unlit matcap normal uv level barycentrics)
shows() { case $1 in normal | uv | level | barycentrics) echo "--show $1" ;; *) echo "--model $1" ;; esac; }
for i in "${!models[@]}"; do
  # shellcheck disable=SC2046
  expect 0 "" "${small[@]}" --texture checker $(shows "${models[i]}") -o "${models[i]}.png"
  for ((k = 0; k < i; ++k)); do
    if cmp -s "${models[k]}.png" "${models[i]}.png"; then
      echo "the models ${models[k]} and ${models[i]} look the same"
      failed=1
    fi
  done
done
same --model combined -- --model blinn-phong  # with the same colour for ambient light
for how in "--model unlit" "--model matcap" "--show normal" "--show uv" "--show barycentrics"; do
  # shellcheck disable=SC2086
  same $how -- $how --lights none --ambient 0
done
same --sun 1,1,1:1,1,1 --exposure 1 --ambient 0 -- --sun 1,1,1:2,2,2 --ambient 0
same --model toon --specular 0 -- --model toon --specular 0 --exponent 5
other --model ggx --metallic 0 -- --model ggx --metallic 1
other --model ggx --roughness 0.2 -- --model ggx --roughness 0.8
other --frequency phong -- --frequency gouraud
other --frequency phong -- --frequency flat
other --samples 1 -- --samples 8
other -- --floor
other --floor --spot 0,3,1:9,9,9 -- --floor --spot 0,3,1:9,9,9 --cookie window
other --floor --spot 0,3,1:9,9,9 -- --floor --light 0,3,1:9,9,9
other --floor --lamps 8 -- --floor --lamps 64
other --lights course -- --lights studio
same --lamps 64 --threads 1 --simd baseline -- --lamps 64 --threads 3
same --texture checker --uv-scale 1 -- --texture checker
other --texture checker --uv-scale 2 -- --texture checker
same --shape sphere -- --shape sphere --height checker
same --shape sphere -- --shape sphere --height checker --bump gradient --bump-scale 0
for form in gradient texel; do other --shape sphere -- --shape sphere --height checker --bump $form --bump-scale 0.2; done
other --shape plane --texture checker -- --shape plane --texture checker --height checker --parallax 0.2
expect 0 "" --size 64x64 --no-color --shape sphere --show normal -o normals.png
other --shape sphere -- --shape sphere --normal-map normals.png
other --shape plane --normal-map normals.png --uv-scale 30 -- \
  --shape plane --normal-map normals.png --uv-scale 30 --keep-roughness toksvig

other --shape plane --normal-map normals.png --uv-scale 30 -- \
  --shape plane --normal-map normals.png --uv-scale 30 --keep-roughness lean
for filter in hard pcf variance summed-area pcss; do
  other --floor --sun 1,1,0.5:1,1,1 -- --floor --sun 1,1,0.5:1,1,1 --shadows $filter
  other --floor --spot 1,3,1:9,9,9 -- --floor --spot 1,3,1:9,9,9 --shadows $filter
  same --floor --lamps 9 -- --floor --lamps 9 --shadows $filter
done
other --floor --light 1,2,1:9,9,9 -- --floor --light 1,2,1:9,9,9 --shadows hard
other -- --lines 1
other --lines 1 -- --lines 3
same --show normal -- --show normal --height checker --displace 0
other --shape sphere --height checker -- --shape sphere --height checker --displace 0.2

expect 2 "--colour is not an option" --colour
expect 2 "--colour is not an option" --colour red
expect 2 "--size needs a value" --size
expect 2 "WIDTHxHEIGHT" --size 0x10
expect 2 "WIDTHxHEIGHT" --size 10x10x10
expect 2 "one of lambert" --model shiny
expect 2 "one of normal uv level barycentrics" --show shiny
expect 2 "1, 2, 4, 8 or 16" --samples 3
expect 2 "INNER,OUTER" --cone 30,20
expect 2 "X,Y,Z" --spot 0,0,0
expect 2 "one of teapot" --shape cube
expect 2 "one of hard" --shadows none
expect 2 "16..8192" --shadow-size 8
expect 3 "no-such-normals.png" --normal-map no-such-normals.png
expect 3 "no-such-heights.png" --height no-such-heights.png
expect 3 "no-such-cookie.png" --spot 1,1,1 --cookie no-such-cookie.png
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

for model in Collada/duck.dae OBJ/spider.obj glTF2/BoxTextured-glTF-Binary/BoxTextured.glb \
  glTF/CesiumMilkTruck/CesiumMilkTruck.gltf glTF2/ClearCoat-glTF/ClearCoatTest.gltf \
  glTF2/textureTransform/TextureTransformTest.gltf; do
  [ ! -f "$assets/$model" ] || expect 0 "" --size 96x64 -o model.png "$assets/$model"
done
exit $failed
