#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# One picture for each way of shading, from models and textures that Debian 12 packages, into out/gallery/; and all of
# them on one sheet, examples/gallery.png. Run it as root, or as a user who may use sudo; without either it works if the
# packages are there. Usage: gallery.sh [--build FOLDER], a tree that is built already.
set -euo pipefail
cd "$(dirname "$0")/.."

build=
[ "${1:-}" != --build ] || build=$2

packages=(
  build-essential cmake ninja-build pkg-config      # to build
  libhwy-dev libtbb-dev                             # SIMD (Highway), threads
  libopenimageio-dev libopencolorio-dev             # image files, colour management
  libassimp-dev assimp-testmodels xplanet-images    # the importer, models, and a map of the earth
  openimageio-tools                                 # oiiotool puts the sheet together
)
missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
if [ ${#missing[@]} -gt 0 ]; then
  echo "== Installing ${missing[*]}"
  as_root=()
  [ "$(id -u)" = 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
fi

if [ -z "$build" ]; then
  build=build/demo
  echo "== Building shd in $build"
  cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSHD_BUILD_TESTS=OFF -DSHD_BUILD_EXAMPLES=ON
  cmake --build "$build" --target shd-render examples/course/all
fi

models=/usr/share/assimp/models
duck=$models/Collada/duck.dae
spider=$models/OBJ/spider.obj
truck=$models/glTF/CesiumMilkTruck/CesiumMilkTruck.gltf
coat=$models/glTF2/ClearCoat-glTF
bark=$models/OBJ/drkwood2.jpg
earth=/usr/share/xplanet/images/earth.jpg
render=$build/examples/shd-render/shd-render
out=out/gallery
mkdir -p "$out"
rm -f "$out"/*.png
sheet=()  # pictures in the order in which they are made

# picture NAME OPTIONS...: out/gallery/NAME.png
picture() {
  local name=$1
  shift
  echo "   $name"
  "$render" --size 640x480 --samples 8 --background 0.6 "$@" -o "$out/$name.png"
  sheet+=("$out/$name.png")
}

echo "== Models of reflectance"
for model in lambert phong blinn-phong normalized combined toon gooch ggx matcap; do
  picture "model-$model" --tessellation 32 --orbit 25,25 --diffuse 0.7,0.25,0.12 --exponent 60 --roughness 0.35 \
    --model "$model"
done
picture model-metal --tessellation 32 --orbit 25,25 --model ggx --diffuse 1,0.71,0.29 --metallic 1 --roughness 0.4 \
  --ambient 0.4
for model in normal uv level barycentrics; do
  picture "show-$model" --orbit 35,15 --filter trilinear --model "$model" "$duck"
done

echo "== Frequencies"
for frequency in flat gouraud phong; do
  picture "frequency-$frequency" --tessellation 5 --orbit 25,25 --specular 0.6 --exponent 40 --frequency "$frequency"
done

echo "== Textures and materials of real models"
picture duck --orbit 35,15 --specular 0.35 --exponent 60 "$duck"
picture spider --orbit 35,30 "$spider"
picture truck-blinn-phong --orbit 40,15 "$truck"
picture truck-ggx --orbit 40,15 --model ggx "$truck"
picture clear-coat-test --orbit 0,0 "$coat/ClearCoatTest.gltf"
picture earth --shape sphere --tessellation 24 --orbit 20,20 --texture "$earth" --model lambert --sun 1,0.4,0.9:2,2,2 \
  --ambient 0.02 --background 0

echo "== Surface detail"
picture bump-gradient --shape sphere --tessellation 24 --orbit 20,10 --height "$bark" --bump gradient --bump-scale 0.05
picture bump-texel --shape sphere --tessellation 24 --orbit 20,10 --height "$bark" --bump texel --bump-scale 6
picture normal-map --shape sphere --tessellation 24 --orbit 20,10 --uv-scale 2 --specular 0.6 --exponent 60 \
  --normal-map "$coat/PlasticWrap_normals.jpg"
for keep in none toksvig; do
  picture "minified-$keep" --shape plane --orbit 20,14,1.8 --lights none --sun -0.4,0.5,-1:2,2,2 --uv-scale 30 \
    --specular 0.6 --exponent 120 --normal-map "$coat/RibsNormal.png" --keep-roughness "$keep"
done
picture parallax --shape plane --orbit 30,35 --texture "$bark" --height "$bark" --bump gradient --bump-scale 0.12 \
  --parallax 0.12

echo "== Lights"
picture course-lights --lights course --exposure 2 --orbit 0,10 --specular 0.7937 --exponent 150 "$duck"
picture spot --floor --orbit 25,25 --spot -1.5,2.5,1.5:12,11,9 --cone 14,20 --ambient 0.03 --tessellation 32
picture cookie --floor --orbit 25,25 --spot -1.5,2.5,1.5:18,18,18 --cone 30,32 --cookie window --ambient 0.03 \
  --tessellation 32
picture lamps-256 --floor --orbit 25,35,3 --lamps 256 --ambient 0.01 --tessellation 32 --diffuse 0.8

echo "== Fragment programs of a course"
for program in normal phong texture bump displacement; do
  "$build/examples/course/$program" "" "$out/course-$program.png"
  sheet+=("$out/course-$program.png")
done

echo "== The sheet"
columns=8
rows=$(((${#sheet[@]} + columns - 1) / columns))
inputs=()
for picture in "${sheet[@]}"; do inputs+=("-i:ch=R,G,B" "$picture"); done
oiiotool "${inputs[@]}" --mosaic:pad=2:fit=160x120 "${columns}x$rows" -d uint8 --compression zip:9 -o examples/gallery.png
echo "== Done: $PWD/$out, $PWD/examples/gallery.png ($(stat -c %s examples/gallery.png) bytes)"
