#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Renders one picture for each way of shading, from models and textures that Debian 12 packages, into out/gallery/, and
# puts all of them on one sheet with headings and labels, examples/gallery.png. Run it as root, or as a user who may use
# sudo. Without either it works if the packages are there.
# Usage: gallery.sh [--build FOLDER]; FOLDER holds a finished build.
set -euo pipefail
cd "$(dirname "$0")/.."

build=
[ "${1:-}" != --build ] || build=$2

. examples/packages.sh
packages=(
  build-essential cmake ninja-build pkg-config      # to build
  libhwy-dev libtbb-dev                             # SIMD (Highway), threads
  libopenimageio-dev libopencolorio-dev             # image files, colour management
  libcli11-dev                                      # options of the programs
  libassimp-dev nlohmann-json3-dev assimp-testmodels xplanet-images  # the importer, models, and a map of the earth
  blender-data                                      # environments
  openimageio-tools fonts-dejavu-core               # oiiotool puts the sheet together, with labels
)
install_packages "${packages[@]}"

if [ -z "$build" ]; then
  build=build/demo
  echo "== Building shd in $build: about 240 files, minutes on a few cores"
  cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSHD_BUILD_TESTS=OFF -DSHD_BUILD_EXAMPLES=ON
  cmake --build "$build" --parallel "$(compile_jobs)" --target shd-render examples/all
fi

models=/usr/share/assimp/models
duck=$models/Collada/duck.dae
spider=$models/OBJ/spider.obj
truck=$models/glTF/CesiumMilkTruck/CesiumMilkTruck.gltf
engine=$models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb
coat=$models/glTF2/ClearCoat-glTF
transforms=$models/glTF2/textureTransform/TextureTransformTest.gltf
bark=$models/OBJ/drkwood2.jpg
stones=$models/IRRMesh/crackedground_1-6.jpg
earth=/usr/share/xplanet/images/earth.jpg
world=/usr/share/blender/datafiles/studiolights/world
render=$build/src/tool/shd-render
out=out/gallery
mkdir -p "$out"
rm -f "$out"/*.png

# The sheet: cells of 240 x 180 pixels, six in a row, each with a label below; groups with headings.
columns=6 cell=240 tall=180 gap=8 label=22 heading=40
column=0 y=0
pastes=() texts=()

# group TITLE: a heading on the sheet
group() {
  echo "== $1"
  [ "$column" = 0 ] || y=$((y + tall + label + gap))
  column=0
  texts+=("--text:x=$gap:y=$((y + 28)):size=19:font=DejaVuSans-Bold:color=.1,.1,.1" "$1")
  y=$((y + heading))
}

# place NAME LABEL: out/gallery/NAME.png on the sheet
place() {
  if [ "$column" = "$columns" ]; then column=0 y=$((y + tall + label + gap)); fi
  local x=$((gap + column * (cell + gap)))
  pastes+=("-i:ch=R,G,B" "$out/$1.png" --resize "${cell}x$tall" --swap --paste "+$x+$y")
  texts+=("--text:x=$((x + cell / 2)):y=$((y + tall + 15)):xalign=center:size=13:font=DejaVuSans:color=.1,.1,.1" "$2")
  column=$((column + 1))
}

# picture NAME LABEL OPTIONS...: renders out/gallery/NAME.png
behind=(--background 0.3)
picture() {
  local name=$1 text=$2
  shift 2
  echo "   $text"
  "$render" --size 640x480 --samples 8 "${behind[@]}" "$@" -o "$out/$name.png"
  place "$name" "$text"
}

group "Reflectance"
pot=(--tessellation 32 --orbit 25,25)
sun=(--sun -0.5,0.9,0.9:1.7,1.65,1.5 --ambient 0.15)
for model in "lambert Lambert" "phong Phong" "blinn-phong Blinn-Phong" "blinn-phong-normalized Blinn-Phong, normalised" \
  "combined Combined" "toon Toon" "gooch Gooch" "metallic-roughness Metallic-roughness (GGX)"; do
  picture "model-${model%% *}" "${model#* }" "${pot[@]}" "${sun[@]}" --model "${model%% *}" --diffuse 0.7,0.22,0.1 \
    --specular 0.4 --exponent 50 --roughness 0.35
done
picture model-metal "GGX, metal" "${pot[@]}" --model metallic-roughness --diffuse 1,0.71,0.29 --metallic 1 --roughness 0.4 --ambient 0.4
picture model-matcap "Matcap" "${pot[@]}" --model matcap --diffuse 1

group "Debug views"
for view in "normal Normals" "uv Texture coordinates" "level Mip levels" "barycentrics Barycentric coordinates"; do
  picture "show-${view%% *}" "${view#* }" --orbit 35,15 --show "${view%% *}" "$duck"
done

group "Shading frequency"
for frequency in "flat Flat" "gouraud Gouraud" "phong Phong"; do
  picture "frequency-${frequency%% *}" "${frequency#* }" --tessellation 4 --orbit 25,25 "${sun[@]}" \
    --diffuse 0.15,0.4,0.5 --specular 0.8 --exponent 40 --frequency "${frequency%% *}"
done

group "Models with their materials"
picture spider "OBJ, five textures" --orbit 35,30 "$spider"
picture truck "glTF, Blinn-Phong" --orbit 40,15 "$truck"
picture truck-ggx "glTF, metallic-roughness" --orbit 40,15 --model metallic-roughness "$truck"
picture clear-coat-test "glTF 2.0: ClearCoatTest" --orbit 0,0 "$coat/ClearCoatTest.gltf"
picture uv-transforms "glTF 2.0: TextureTransformTest" --orbit 0,0 --model unlit "$transforms"
picture earth "A texture on a sphere" --shape sphere --tessellation 24 --orbit 20,20 --texture "$earth" --model lambert \
  --sun 1,0.4,0.9:2,2,2 --ambient 0.1

group "Solid textures"
declare -A sizes=([marble]=0.8 [wood]=0.22 [perlin]=0.9 [simplex]=0.8 [worley]=0.5 [checker]=0.4)
for solid in "marble Marble" "wood Wood" "perlin Perlin noise, 6 octaves" "simplex Turbulence of simplex noise" \
  "worley Worley noise, F2 - F1" "checker A checker of cubes"; do
  picture "solid-${solid%% *}" "${solid#* }" "${pot[@]}" "${sun[@]}" --solid "${solid%% *}" --solid-size "${sizes[${solid%% *}]}" \
    --specular 0.3 --exponent 60
done

group "Surface detail"
ball=(--shape sphere --tessellation 24 --orbit 20,10 "${sun[@]}" --diffuse 0.45)
picture bump-gradient "Bumps: gradient of heights" "${ball[@]}" --height "$bark" --bump gradient --bump-scale 0.05
picture bump-texel "Bumps: texel differences" "${ball[@]}" --height "$bark" --bump texel --bump-scale 8
picture normal-map "Normal map" "${ball[@]}" --specular 0.6 --exponent 60 --normal-map "$coat/PlasticWrap_normals.jpg"
for keep in "none Minified normal map" "toksvig with roughness: Toksvig" "lean with roughness: LEAN"; do
  picture "minified-${keep%% *}" "${keep#* }" "${ball[@]}" --uv-scale 40 --filter ewa --specular 0.8 --exponent 200 \
    --diffuse 0.2,0.2,0.25 --normal-map "$coat/PlasticWrap_normals.jpg" --keep-roughness "${keep%% *}"
done
slab=(--shape plane --orbit 30,35 --texture "$stones" --specular 0 --exposure 0.7)
picture parallax "Parallax occlusion" "${slab[@]}" --height "$stones" --bump gradient --bump-scale 0.05 --parallax 0.1
picture displacement "Displacement" "${slab[@]}" --height "$stones" --displace 0.16 --edge-length 2

group "Lights"
picture course-lights "Two points of a course" --lights course --exposure 2 --orbit 0,10 --specular 0.7937 \
  --exponent 150 "$duck"
stage=(--floor --orbit 25,25,3.4 --tessellation 32 --ambient 0.2)
picture spot "Spot" "${stage[@]}" --spot -1.5,2.5,1.5:16,15,13 --cone 16,30 --shadows pcf
picture cookie "Light cookie" "${stage[@]}" --spot -1.5,2.5,1.5:20,20,20 --cone 28,30 --cookie window --shadows pcf
picture lamps-256 "256 lamps with a range" --floor --orbit 25,35,3.2 --tessellation 32 --diffuse 0.8 --ambient 0.06 \
  --exposure 0.8 --lamps 256

group "Shadows"
for filter in "hard Hard" "pcf PCF" "variance Variance" "summed-area-variance Summed-area variance" "pcss PCSS"; do
  picture "shadow-${filter%% *}" "${filter#* }" --floor --orbit 30,35,3.2 --sun -0.8,1.1,0.3:1.6,1.5,1.4 --ambient 0.2 \
    --shadow-size 1024 --shadows "${filter%% *}" "$spider"
done

group "Ambient occlusion"
clay=(--floor --orbit 25,25,3.4 --tessellation 32 --model lambert --diffuse 0.7 --sun -0.5,0.9,0.9:0.25,0.25,0.25
  --ambient 0.75 --specular 0)
picture occlusion-none "Without" "${clay[@]}"
picture occlusion "With" "${clay[@]}" --occlusion 256
picture occlusion-radius "With rays of a fifth of its size" "${clay[@]}" --occlusion 256 --occlusion-radius 0.4
steel=(--environment "$world/courtyard.exr" --environment-blur 0.35 --orbit 140,20 --metallic 1 --roughness 0.3)
behind=()
picture engine-none "Under an environment, without" "${steel[@]}" "$engine"
picture engine "Under an environment, with" "${steel[@]}" --occlusion 256 "$engine"

group "Light from environments"
behind=(--environment-blur 0.2)
for roughness in 0 0.25 0.5 0.75 1; do
  picture "environment-metal-$roughness" "Metal, roughness $roughness" --environment "$world/courtyard.exr" \
    --shape sphere --tessellation 64 --metallic 1 --diffuse 0.9,0.65,0.3 --roughness "$roughness"
done
picture environment-dielectric "Dielectric" --environment "$world/courtyard.exr" --shape sphere --tessellation 64 \
  --diffuse 0.5,0.08,0.05 --roughness 0.15
picture environment-mirror "Mirror" --environment "$world/forest.exr" --metallic 1 --diffuse 0.95 --roughness 0
picture environment-glass "Glass" --environment "$world/sunset.exr" --model glass --diffuse 0.93,0.97,0.95 --roughness 0
picture environment-coat "Clear coat" --environment "$world/studio.exr" --environment-blur 0.4 --orbit 0,0 --exposure 1 \
  "$coat/ClearCoatTest.gltf"
behind=(--background 0.3)

group "Lines"
picture line-drawing "Silhouettes and creases" --orbit 40,15 --model unlit --texture none --diffuse 0.9 --background 0.9 \
  --lines 1.6 "$truck"
picture line-gooch "Lines over Gooch" "${pot[@]}" "${sun[@]}" --model gooch --diffuse 0.7,0.22,0.1 --lines 2

group "Fragment programs of a course"
for program in "normal Normals" "phong Blinn-Phong" "texture Texture" "bump Bump mapping" "displacement Displacement"; do
  name=${program%% *}
  model=()
  if [ "$name" = bump ]; then model=(-); fi
  if [ "$name" = displacement ]; then model=(--move small --light 3,4,6:40 --light -4,2,6:25 -); fi
  echo "   ${program#* }"
  "$build/examples/course/$name" -o "$out/program.png" "${model[@]}"
  oiiotool "$out/program.png" --create 512x512 4 --fill:color=.5,.5,.5,1 512x512 --over --cut 512x384+0+64 \
    --ch R,G,B -o "$out/course-$name.png"
  rm "$out/program.png"
  place "course-$name" "${program#* }"
done

group "Programs of examples/"
programs=$(cd "$build/examples" && pwd)
(
  cd "$out"
  "$programs/globe" "$earth" "${earth%/*}/night.jpg"
  "$programs/distance_field" 640
  "$programs/volume"
  "$programs/polygon"
)

# program NAME LABEL OPTIONS...: out/gallery/program-NAME.png by oiiotool
program() {
  local name=program-$1 text=$2
  shift 2
  oiiotool "$@" --ch R,G,B -o "$out/$name.png"
  place "$name" "$text"
}
program globe "globe: two maps, one program" "$out/globe.png" --fit:pad=1 640x480
program distance-field "distance_field: no triangles" "$out/distance_field.png" --cut 533x400+53+0
program cloud "volume: a cloud" "$out/volume.png" --cut 320x240+0+60
program head "volume: a head, its rear half" "$out/volume.png" --cut 320x240+320+60
program polygon "polygon: four kinds of weights" --create 720x600 4 --fill:color=1,1,1,1 720x600 \
  "$out/polygon.png" --cut 300x300+0+0 --swap --paste +50+0 "$out/polygon.png" --cut 300x300+300+0 --swap --paste +370+0 \
  "$out/polygon.png" --cut 300x300+600+0 --swap --paste +50+300 "$out/polygon.png" --cut 300x300+900+0 --swap --paste +370+300

echo "== The picture that opens README.md"
"$render" --size 1280x720 --samples 8 "${steel[@]}" --occlusion 256 --dither -o examples/engine.png "$engine"

echo "== The sheet"
size=$((gap + columns * (cell + gap)))x$((y + tall + label + gap))
oiiotool --create "$size" 3 --fill:color=1,1,1 "$size" "${pastes[@]}" "${texts[@]}" -d uint8 --compression zip:9 \
  -o examples/gallery.png
echo "== Done: $PWD/$out, $PWD/examples/engine.png, examples/gallery.png ($(stat -c %s examples/gallery.png) bytes)"
