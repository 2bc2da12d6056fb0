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
transforms=$models/glTF2/textureTransform/TextureTransformTest.gltf
bark=$models/OBJ/drkwood2.jpg
stones=$models/IRRMesh/crackedground_1-6.jpg
earth=/usr/share/xplanet/images/earth.jpg
render=$build/src/tool/shd-render
out=out/gallery
mkdir -p "$out"
rm -f "$out"/*.png
sheet=()  # pictures in the order in which they are made

# picture NAME OPTIONS...: out/gallery/NAME.png
picture() {
  local name=$1
  shift
  echo "   $name"
  "$render" --size 640x480 --samples 8 --background 0.3 "$@" -o "$out/$name.png"
  sheet+=("$out/$name.png")
}

echo "== Models of reflectance"
pot=(--tessellation 32 --orbit 25,25)
sun=(--sun -0.5,0.9,0.9:1.7,1.65,1.5 --ambient 0.15)
for model in lambert phong blinn-phong normalized combined toon gooch ggx; do
  picture "model-$model" "${pot[@]}" "${sun[@]}" --model "$model" --diffuse 0.7,0.22,0.1 --specular 0.4 --exponent 50 \
    --roughness 0.35
done
picture model-metal "${pot[@]}" --model ggx --diffuse 1,0.71,0.29 --metallic 1 --roughness 0.4 --ambient 0.4
picture model-matcap "${pot[@]}" --model matcap --diffuse 1
for view in normal uv level barycentrics; do
  picture "show-$view" --orbit 35,15 --show "$view" "$duck"
done

echo "== Frequencies"
for frequency in flat gouraud phong; do
  picture "frequency-$frequency" --tessellation 4 --orbit 25,25 "${sun[@]}" --diffuse 0.15,0.4,0.5 --specular 0.8 \
    --exponent 40 --frequency "$frequency"
done

echo "== Textures and materials of models"
picture spider --orbit 35,30 "$spider"
picture truck --orbit 40,15 "$truck"
picture truck-ggx --orbit 40,15 --model ggx "$truck"
picture clear-coat-test --orbit 0,0 "$coat/ClearCoatTest.gltf"
picture uv-transforms --orbit 0,0 --model unlit "$transforms"
picture earth --shape sphere --tessellation 24 --orbit 20,20 --texture "$earth" --model lambert --sun 1,0.4,0.9:2,2,2 \
  --ambient 0.02 --background 0

echo "== Surface detail"
ball=(--shape sphere --tessellation 24 --orbit 20,10 "${sun[@]}" --diffuse 0.45)
picture bump-gradient "${ball[@]}" --height "$bark" --bump gradient --bump-scale 0.05
picture bump-texel "${ball[@]}" --height "$bark" --bump texel --bump-scale 8
picture normal-map "${ball[@]}" --specular 0.6 --exponent 60 --normal-map "$coat/PlasticWrap_normals.jpg"
for keep in none toksvig lean; do
  picture "minified-$keep" "${ball[@]}" --uv-scale 40 --specular 0.8 --exponent 200 --diffuse 0.2,0.2,0.25 \
    --normal-map "$coat/PlasticWrap_normals.jpg" --keep-roughness "$keep"
done
slab=(--shape plane --orbit 30,35 --texture "$stones" --specular 0)
picture parallax "${slab[@]}" --height "$stones" --bump gradient --bump-scale 0.05 --parallax 0.1
picture displacement "${slab[@]}" --height "$stones" --displace 0.16 --edge-length 2

echo "== Lights"
picture course-lights --lights course --exposure 2 --orbit 0,10 --specular 0.7937 --exponent 150 "$duck"
stage=(--floor --orbit 25,25 --tessellation 32 --ambient 0.03)
picture spot "${stage[@]}" --spot -1.5,2.5,1.5:12,11,9 --cone 12,18 --shadows pcf
picture cookie "${stage[@]}" --spot -1.5,2.5,1.5:20,20,20 --cone 26,28 --cookie window --shadows pcf
picture lamps-256 --floor --orbit 25,35,3.2 --tessellation 32 --diffuse 0.8 --ambient 0.01 --lamps 256

echo "== Shadows"
for filter in hard pcf variance summed-area pcss; do
  picture "shadow-$filter" --floor --orbit 30,35 --sun -0.8,1.1,0.3:1.6,1.5,1.4 --ambient 0.2 --shadow-size 1024 \
    --shadows "$filter" "$spider"
done

echo "== Lines"
picture line-drawing --orbit 40,15 --model unlit --texture none --diffuse 0.9 --background 0.9 --lines 1.6 "$truck"
picture line-gooch "${pot[@]}" "${sun[@]}" --model gooch --diffuse 0.7,0.22,0.1 --lines 2

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
