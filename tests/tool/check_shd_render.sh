#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests shd-render against its help text. Usage: check_shd_render.sh SHD-RENDER FOLDER HAS-COLOR
set -euo pipefail
render=$1
folder=$2
has_color=$3
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

# picture OPTIONS...: draws a small picture unless these options have drawn one before. Its hash is in `drawn`.
small=(--size 48x32 --tessellation 4 --no-color)
declare -A pictures=()
picture() {
  drawn=${pictures["options: $*"]:-}
  [ -z "$drawn" ] || return 0
  expect 0 "" "${small[@]}" "$@" --hash
  drawn=$(grep -xE '[0-9a-f]{16}' said.txt) || { echo "no hash of $*" && failed=1; }
  pictures["options: $*"]=$drawn
}

# Compares two pictures, which must be equal or different: two lists of options, separated by --. With SHD_ONE_PICTURE
# only the second one is drawn: a sanitizer looks for errors, and another run compares.
compare() {
  local wanted=$1 first=() got=other one drawn
  shift
  while [ "$1" != -- ]; do first+=("$1") && shift; done
  shift
  if [ -n "${SHD_ONE_PICTURE:-}" ]; then
    picture "$@"
    return
  fi
  picture "${first[@]}"
  one=$drawn
  picture "$@"
  if [ "$one" = "$drawn" ]; then got=same; fi
  if [ "$got" != "$wanted" ]; then
    echo "the pictures of ${first[*]} and $* are the $got"
    failed=1
  fi
}
same() { compare same "$@"; }
other() { compare other "$@"; }

# rounded NAME OPTIONS...: the picture NAME.png; two pictures that differ in the rounding of floats are the same file.
rounded() { expect 0 "" "${small[@]}" "${@:2}" -o "$1.png"; }

expect 0 "Exit status" --help
expect 0 "shd-render 0." --version
expect 0 "teapot.png: 96 x 64" --size 96x64 --tessellation 4 -o teapot.png
written teapot.png 89504e47
expect 0 "triangles" --stats --size 96x64 --aov --texture checker --model lambert --frequency flat -o teapot.exr
written teapot.exr 762f3101
expect 0 "" --size 64x64 --no-color --background 0.2,0.3,0.4 --light 2,2,2:8,8,8 --sun 0,1,0 --frequency gouraud \
  --filter nearest --orbit -90,90,3 -o top.png
same --threads 1 --simd baseline -- --threads 5
expect 0 "" --size 64x64 --hash --turntable 2 -o hashed.png
[ "$(grep -cxE '[0-9a-f]{16}' said.txt)" = 2 ] || failed=1
written hashed-0002.png 89504e47
expect 2 "need -o FILE.exr" --aov --hash
expect 0 "mipmap.png: 384 x 256" --table mipmap --texture checker -o mipmap.png
written mipmap.png 89504e47
expect 0 "ripmap.exr: 766 x 511" --table ripmap --texture mipmap.png --compression none -o ripmap.exr
expect 0 "sums.png: 384 x 256" --table summed-area --texture mipmap.png -o sums.png
expect 0 "depths.png: 96 x 16" --table shadow-map --tessellation 4 --light 1,2,1 --shadow-size 16 \
  --shadows summed-area-variance -o depths.png
expect 2 "--table needs a --texture" --table ripmap -o none.png
expect 2 "--table shadow-map: no light casts a shadow" --table shadow-map --lights none -o none.png
expect 2 "not with --show and --zoom" --table mipmap --texture checker --zoom 3,3,2 -o none.png
expect 2 "not with --compare" --table mipmap --texture checker --compare ":samples=1" -o none.png
expect 3 "absent.png" --table mipmap --texture absent.png -o none.png

# Effects of options, tested on pairs of pictures.
models=(lambert phong blinn-phong blinn-phong-normalized metallic-roughness gooch toon unlit matcap)
views=(normal uv barycentrics depth position overdraw level level-nearest tangents footprint uv-layout)
shows() { case " ${views[*]} " in *" $1 "*) echo "--show $1" ;; *) echo "--model $1" ;; esac; }
models+=("${views[@]}")
for i in "${!models[@]}"; do
  for ((k = 0; k < i; ++k)); do
    # shellcheck disable=SC2046
    other --texture checker $(shows "${models[k]}") -- --texture checker $(shows "${models[i]}")
  done
done
rounded combined --model combined
rounded blinn-phong --model blinn-phong
cmp combined.png blinn-phong.png || failed=1  # with the same colour for ambient light
for how in "--model unlit" "--model matcap" "--show normal" "--show uv" "--show barycentrics" "--show depth" \
  "--show position" "--show overdraw" "--show level" "--show uv-layout"; do
  # shellcheck disable=SC2086
  same $how -- $how --lights none --ambient 0
done
same --sun 1,1,1:1,1,1 --exposure 1 --ambient 0 -- --sun 1,1,1:2,2,2 --ambient 0
same --model toon --specular 0 -- --model toon --specular 0 --exponent 5
other --model metallic-roughness --metallic 0 -- --model metallic-roughness --metallic 1
other --model metallic-roughness --roughness 0.2 -- --model metallic-roughness --roughness 0.8
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
other --texture checker --uv-scale 20 -- --texture checker --uv-scale 20 --lod-bias -2
kinds=(mesh planar spherical cylindrical box triplanar camera)
for i in "${!kinds[@]}"; do
  for ((k = 0; k < i; ++k)); do
    other --texture checker --uv "${kinds[k]}" -- --texture checker --uv "${kinds[i]}"
  done
done
same --shape box --texture checker --uv box -- --shape box --texture checker
same --texture checker --uv camera --uv-scale 1 -- --texture checker --uv camera
for kind in stripes checker perlin value simplex worley wood; do other --solid marble -- --solid $kind; done
other --solid marble -- --solid marble --solid-size 0.25
same --solid perlin -- --solid perlin --solid-octaves 6 --solid-fade quintic
other --solid perlin -- --solid perlin --solid-octaves 1
other --solid perlin -- --solid perlin --solid-turbulence
other --solid perlin -- --solid perlin --solid-table
other --solid value -- --solid value --solid-fade cubic
other --solid value --solid-fade linear -- --solid value --solid-fade cubic
same --solid simplex -- --solid simplex --solid-turbulence
same --solid marble --texture checker -- --solid marble
same --texture checker --lod-bias 0 -- --texture checker
same --shape sphere -- --shape sphere --height checker
same --shape sphere -- --shape sphere --height checker --bump gradient --bump-scale 0
for form in gradient texel; do other --shape sphere -- --shape sphere --height checker --bump $form --bump-scale 0.2; done
other --shape plane --texture checker -- --shape plane --texture checker --height checker --parallax 0.2
expect 0 "" --size 64x64 --no-color --shape sphere --show normal -o normals.png
other --shape sphere -- --shape sphere --normal-map normals.png
for kind in box triplanar camera; do
  other --normal-map normals.png -- --normal-map normals.png --uv $kind
done
other --shape plane --normal-map normals.png --uv-scale 30 -- \
  --shape plane --normal-map normals.png --uv-scale 30 --keep-roughness toksvig

other --shape plane --normal-map normals.png --uv-scale 30 -- \
  --shape plane --normal-map normals.png --uv-scale 30 --keep-roughness lean
for filter in hard pcf variance summed-area-variance pcss; do
  other --floor --sun 1,1,0.5:1,1,1 -- --floor --sun 1,1,0.5:1,1,1 --shadows $filter
  other --floor --spot 1,3,1:9,9,9 -- --floor --spot 1,3,1:9,9,9 --shadows $filter
  same --floor --lamps 9 -- --floor --lamps 9 --shadows $filter
done
other --floor --light 1,2,1:9,9,9 -- --floor --light 1,2,1:9,9,9 --shadows hard
other --floor -- --floor --occlusion 8
other --floor --occlusion 8 -- --floor --occlusion 8 --occlusion-radius 0.2
rounded dark --ambient 0
rounded occluded --ambient 0 --occlusion 8
cmp dark.png occluded.png || failed=1
other -- --lines 1
other -- --wireframe 1
other --wireframe 1 -- --wireframe 3
other --samples 4 --shape plane --texture checker --uv-scale 9 -- \
  --samples 4 --shape plane --texture checker --uv-scale 9 --sample-shading
same --samples 1 -- --samples 1 --sample-shading
same -- --samples 4
other -- --samples 1
other --shape plane --texture checker --uv-scale 4 --orbit 30,10 -- \
  --shape plane --texture checker --uv-scale 4 --orbit 30,10 --affine
for filter in nearest bicubic hermite; do
  other --shape plane --texture checker --uv-scale 0.01 -- \
    --shape plane --texture checker --uv-scale 0.01 --magnify $filter
done
same --shape plane --texture checker --uv-scale 0.01 -- \
  --shape plane --texture checker --uv-scale 0.01 --magnify bilinear
same --shape plane --texture checker --uv-scale 0.01 --filter bilinear --magnify hermite -- \
  --shape plane --texture checker --uv-scale 0.01 --filter hermite
other --lines 1 -- --lines 3
same --show normal -- --show normal --height checker --displace 0
other --shape sphere --height checker -- --shape sphere --height checker --displace 0.2

expect 0 "" --size 64x32 --background 0.2,0.4,0.8 -o around.exr
other -- --environment around.exr
# Six faces of 4 x 4 texels in all layouts give one picture. A square with a blank border is a probe.
python3 - <<'PYTHON'
import struct
import zlib


def png(path, width, height, texel):
    rows = b"".join(b"\0" + b"".join(bytes(texel(x, y)) for x in range(width)) for y in range(height))
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                   chunk(b"sRGB", b"\0") + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def face(f, x, y):
    return 40 * f + 10, 60 * x + 15, 60 * y + 15


def layout(path, columns, rows, places, turned=None):
    def texel(x, y):
        for f, place in enumerate(places):
            if place == (x // 4, y // 4):
                return face(f, 3 - x % 4, 3 - y % 4) if f == turned else face(f, x % 4, y % 4)
        return 0, 0, 0
    png(path, 4 * columns, 4 * rows, texel)


layout("strip.png", 1, 6, [(0, f) for f in range(6)])
layout("row.png", 6, 1, [(f, 0) for f in range(6)])
layout("cross.png", 4, 3, [(2, 1), (0, 1), (1, 0), (1, 2), (1, 1), (3, 1)])
layout("tall.png", 3, 4, [(2, 1), (0, 1), (1, 0), (1, 2), (1, 1), (1, 3)], turned=5)
png("square.png", 32, 32, lambda x, y: (x * 8, y * 8, 99))
png("ball.png", 64, 64, lambda x, y: (x * 4, y * 4, 99) if (x - 31.5) ** 2 + (y - 31.5) ** 2 < 1024 else (0, 0, 0))
head = [124, 0x100f, 4, 4, 16, 0, 0] + [0] * 11 + [32, 0x41, 0, 32, 0xff, 0xff00, 0xff0000, 0xff000000, 0x1008, 0xfe00]
with open("cube.dds", "wb") as file:
    file.write(b"DDS " + struct.pack("<31I", *head, 0, 0, 0))
    file.write(b"".join(bytes((*face(f, x, y), 255)) for f in range(6) for y in range(4) for x in range(4)))
PYTHON
expect 0 "square.png: 32 x 32 pixels, taken as lat-long (--environment-projection)" --size 8x8 --environment square.png
expect 0 "" --size 8x8 --environment square.png --environment-projection lat-long
grep "^shd-render:" said.txt && failed=1
other --environment square.png -- --environment square.png --environment-projection angular
other --environment square.png --environment-projection mirror-ball -- \
  --environment square.png --environment-projection octahedral
for file in row.png cross.png tall.png cube.dds; do
  same --environment strip.png -- --environment $file
  grep "^shd-render:" said.txt && failed=1
done
other --environment strip.png -- --environment strip.png --environment-projection lat-long
same --environment ball.png -- --environment ball.png --environment-projection angular
expect 0 "ball.png: 64 x 64 pixels, taken as an angular probe, not a mirror-ball" --size 8x8 --environment ball.png
expect 2 "cube.dds is a cube map: --environment-projection cube" --environment cube.dds \
  --environment-projection lat-long
expect 3 "64 x 32 pixels are no cube map: a strip of 1:6 or 6:1, or a cross of 4:3 or 3:4" \
  --environment around.exr --environment-projection cube
other --environment around.exr -- --environment around.exr --environment-turn 90
other --environment around.exr -- --environment around.exr --environment-blur 0.6
other --environment around.exr -- --environment around.exr --background 0
other --environment around.exr -- --environment around.exr --exposure 1
other --environment around.exr -- --environment around.exr --model glass
other --environment around.exr -- --environment around.exr --lights headlight

# A volume of 16^3 voxels, brightest in the middle row, as voxels and as a stack of two pictures.
for ((i = 0; i < 256; ++i)); do printf '%b' "\\0$((i / 64))$((i / 8 % 8))$((i % 8))"; done >row.raw
for ((i = 0; i < 16; ++i)); do cat row.raw; done >cube.raw
cube=(--volume cube.raw --volume-size 16x16x16)
other -- "${cube[@]}"
other "${cube[@]}" -- "${cube[@]}" --volume-up z
other "${cube[@]}" -- "${cube[@]}" --volume-range 100,120
other "${cube[@]}" -- "${cube[@]}" --volume-density 0.1
other "${cube[@]}" -- "${cube[@]}" --model unlit
other "${cube[@]}" -- "${cube[@]}" --volume-spacing 1,2,1
same "${cube[@]}" -- "${cube[@]}" --volume-header rest
other "${cube[@]}" -- --volume cube.raw --volume-size 16x16x8 --volume-format u16be
expect 0 "" --size 32x24 --no-color -o slice-1.png
expect 0 "" --size 32x24 --no-color --shape box -o slice-2.png
expect 0 "" "${small[@]}" --volume slice-%d.png --volume-slices 1,2 --volume-spacing 1,1,9 -o stack.png
expect 2 "cube.raw needs --volume-size" --volume cube.raw
expect 3 "has 4096 bytes, not 0 of a header and 4352" --volume cube.raw --volume-size 16x17x16
cp row.raw row.vdb
expect 3 "OpenVDB" --volume row.vdb  # not an OpenVDB file, or built without
expect 2 "WIDTHxHEIGHTxDEPTH" --volume-size 16x16
expect 2 "u8, u16" --volume-format u64
expect 2 "FIRST,LAST" --volume-slices 2,1
expect 2 "LOW,HIGH" --volume-range 1,1
expect 2 "y or z" --volume-up x
expect 2 "--volume is drawn instead of a model" --volume cube.raw model.obj

shapes=(teapot sphere plane box torus)
other --shape cycle --visibility painter -- --shape cycle
same --shape cycle -- --shape cycle --orbit 0,0
for ((i = 1; i < 5; ++i)); do other --shape teapot -- --shape "${shapes[i]}"; done
other --shape plane --texture checker -- --shape plane --texture checker --supersampling 3
same --shape plane -- --shape plane --supersampling 1
for filter in nearest bilinear bicubic nearest-mip nearest-mip-linear bilinear-mip ripmap summed-area anisotropic ewa \
  stochastic exact hermite; do
  other --shape plane --texture checker --uv-scale 4 --orbit 30,10 -- \
    --shape plane --texture checker --uv-scale 4 --orbit 30,10 --filter $filter
done
expect 0 "" "${small[@]}" --shape box --visibility painter -o painted.png
same --shape box -- --shape box --visibility newell
expect 0 "" "${small[@]}" -o plain.png
expect 0 "" "${small[@]}" --dither -o dithered.png
cmp -s plain.png dithered.png && { echo "--dither changes nothing" && failed=1; }
expect 0 "tiles " --stats --size 32x32 -o stats.png
expect 0 "" --size 32x32 --aovs position,overdraw -o planes.exr
expect 0 "" --size 32x32 --aovs all -o all.exr
[ "$(wc -c <all.exr)" -gt "$(wc -c <planes.exr)" ] || failed=1
expect 0 "s left" --progress --turntable 3 --size 512x512 --samples 16 --supersampling 8 -o slow.png
expect 0 "" "${small[@]}" --turntable 4 -o turn.png
cmp -s turn-0001.png turn-0002.png && { echo "the turntable does not turn" && failed=1; }
expect 0 "" "${small[@]}" -o still.png
cmp turn-0001.png still.png || failed=1

expect 2 "a whole number 1..9999" --turntable 2.5
expect 2 "1..16" --supersampling 17
expect 2 "a number 0.0625..64 pixels" --wireframe 0
expect 2 "one of depth" --visibility scanline
expect 2 "a list of uv, normal," --aovs uv,albedo
expect 2 "did you mean barycentrics?" --aovs uv,barycentric
expect 2 "--turntable turns no --camera" --turntable 4 --camera 0
expect 2 "does not end in .exr" --aovs uv -o picture.png
expect 3 "no such camera" --camera 0
expect 3 "has no lights" --lights file
expect 2 "--colour is not an option" --colour
expect 2 "--colour is not an option" --colour red
expect 2 "--size needs a value: WIDTHxHEIGHT" --size
expect 2 "--size needs a value" --size=
expect 2 "--floor takes no value" --floor=yes
expect 2 "--smaples is not an option: did you mean --samples? (shd-render --help)" --smaples 4
expect 2 "--env is not an option: did you mean --environment?" --env=sky.hdr
expect 2 "did you mean trilinear?" --filter trilinaer
if [ "$has_color" = 1 ]; then
  expect 2 "--display: \"sRBG\" is not one of sRGB" --display sRBG
  expect 2 "did you mean Plain?" --view Plan
fi
expect 2 "--shape is drawn instead of a model" --shape box model.obj
expect 2 "the name of a file is empty" ""
expect 3 "--weird.obj" -- --weird.obj
expect 0 "short.png: 8 x 8" --size=8x8 -oshort.png
expect 2 "WIDTHxHEIGHT" --size 0x10
expect 2 "WIDTHxHEIGHT" --size 10x10x10
expect 2 "one of lambert" --model shiny
expect 2 "one of none, normal, uv, barycentrics, depth" --show shiny
expect 2 "did you mean level-nearest?" --show level-neerest
expect 2 "1, 2, 4, 8 or 16" --samples 3
expect 2 "INNER,OUTER" --cone 30,20
expect 2 "X,Y,Z" --spot 0,0,0
expect 2 "one of sphere" --shape cube
expect 2 "or cycle" --shape cube
expect 2 "one of hard" --shadows none
expect 2 "a whole number 1..65536" --occlusion 0
expect 2 "a number 1e-6..1e6" --occlusion-radius 0
expect 2 "16..8192" --shadow-size 8
expect 3 "no-such-normals.png" --normal-map no-such-normals.png
expect 3 "no-such-heights.png" --height no-such-heights.png
expect 3 "no-such-sky.hdr" --environment no-such-sky.hdr
expect 2 "-360..360" --environment-turn 400
expect 2 "one of lat-long, mirror-ball, angular, cube or octahedral" --environment-projection round
expect 2 "0..1" --environment-blur 2
expect 3 "no-such-cookie.png" --spot 1,1,1 --cookie no-such-cookie.png
expect 2 "one of trilinear, nearest, bilinear" --filter best
expect 2 "one model at a time" a.obj b.obj
expect 2 "X,Y,Z" --sun 0,0,0
expect 2 "X,Y,Z" --light 1,2,nan
expect 2 "does not end in" -o picture.gif
expect 2 "does not end in .exr" --aov -o picture.png
expect 3 "no-such-model.obj" no-such-model.obj
expect 3 "no-such-texture.png" --texture no-such-texture.png
expect 4 "there is no folder \"no-such-folder/\"" -o no-such-folder/picture.png
printf 'v 0 0 0\nv 1 0 0\nl 1 2\n' >line.obj
expect 3 "line.obj" line.obj
printf 'mtllib tri.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3\n' >tri.obj
printf 'newmtl m\nKd 1 1 1\nmap_Kd C:\\art\\Missing.png\n' >tri.mtl
expect 0 "its material is plain" --size 8x8 tri.obj
expect 0 "its material is plain" --size 8x8 --texture checker tri.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >bare.obj
expect 0 "meshes without texture coordinates, which show one texel of a texture: 1 of 1" --size 8x8 --texture checker \
  bare.obj
grep -q "(--uv box)" said.txt || failed=1
expect 0 "" --size 8x8 bare.obj
grep "^shd-render:" said.txt && failed=1
for kind in planar spherical cylindrical box triplanar camera; do
  expect 0 "" --size 8x8 --texture checker --uv $kind bare.obj
  grep "^shd-render:" said.txt && failed=1
done
expect 2 "triplanar or camera" --uv round bare.obj
cat >single.gltf <<'END'
{"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "buffers": [{"byteLength": 36, "uri": "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAA"}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}]}
END
expect 0 "all faces are seen from behind" --size 8x8 --orbit 180,0 single.gltf
expect 0 "" --size 8x8 --orbit 0,0 single.gltf
grep "^shd-render:" said.txt && failed=1
mkdir -p Textures
cp teapot.png Textures/Skin.PNG
printf 'newmtl m\nKd 1 1 1\nmap_Kd ../skin.png\n' >tri.mtl
expect 0 "which takes --any-folder" --size 8x8 tri.obj
printf 'newmtl m\nKd 1 1 1\nmap_Kd TEXTURES\\skin.png\n' >tri.mtl
expect 0 "" --size 8x8 tri.obj
diff said.txt <(echo "out.png: 8 x 8") || { cat said.txt; failed=1; }

for model in Collada/duck.dae OBJ/spider.obj glTF2/BoxTextured-glTF-Binary/BoxTextured.glb \
  glTF/CesiumMilkTruck/CesiumMilkTruck.gltf glTF2/ClearCoat-glTF/ClearCoatTest.gltf \
  glTF2/textureTransform/TextureTransformTest.gltf; do
  [ ! -f "$assets/$model" ] || expect 0 "" --size 96x64 -o model.png "$assets/$model"
done

# Cameras and lights of a file.
room=$assets/glTF2/cameras/Cameras.gltf
if [ -f "$room" ]; then
  expect 0 "" --size 48x32 --no-color --camera 0 -o camera.png "$room"
  expect 0 "not used: 1 (--camera 0)" --size 48x32 --no-color -o orbit.png "$room"
  cmp -s camera.png orbit.png && { echo "--camera changes nothing" && failed=1; }
  expect 3 "no such camera" --camera 77 "$room"
fi
printf '%s' '{"asset":{"version":"2.0"},"extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":
{"lights":[{"type":"directional","intensity":2}]}},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0},{"name":
"sun","extensions":{"KHR_lights_punctual":{"light":0}}}],"materials":[{}],"meshes":[{"primitives":[{"attributes":
{"POSITION":0},"material":0}]}],"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
"min":[0,0,0],"max":[1,1,0]}]}' >lit.gltf
expect 0 "" --size 48x32 --no-color --lights file -o lit.png lit.gltf
expect 0 "not used: 1 (--lights file)" --size 48x32 --no-color --lights none -o dark.png lit.gltf
cmp -s lit.png dark.png && { echo "--lights file changes nothing" && failed=1; }
exit $failed
