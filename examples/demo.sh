#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# From a fresh Debian 12 to three pictures: installs what is missing, builds shd, renders a duck, a spider and a teapot.
# Run it as root, or as a user who may use sudo. Without either it works if the packages are there.
set -euo pipefail
cd "$(dirname "$0")/.."

. examples/packages.sh
packages=(
  build-essential cmake ninja-build pkg-config  # to build
  libhwy-dev                                    # SIMD (Highway)
  libtbb-dev                                    # threads
  libopenimageio-dev                            # image files
  libopencolorio-dev                            # colour management
  libcli11-dev                                  # options of the programs
  libassimp-dev nlohmann-json3-dev assimp-testmodels  # 3D models: the importer, and the duck and the spider
)

install_packages "${packages[@]}"

echo "== Building shd in build/demo: minutes on a few cores"
# SHD_SIMD=few: kernels for AVX2 and the baseline alone, in half of the time. Pictures have the same bits on every target.
cmake -S . -B build/demo -G Ninja -DCMAKE_BUILD_TYPE=Release -DSHD_BUILD_TESTS=OFF -DSHD_BUILD_EXAMPLES=ON -DSHD_SIMD=few
cmake --build build/demo --parallel "$(compile_jobs)" --target shd-render

models=/usr/share/assimp/models
render=build/demo/src/tool/shd-render
mkdir -p out

# picture NAME MODEL OPTIONS...: renders MODEL, or the checkered teapot where that is not installed
picture() {
  local name=$1 model=$2
  shift 2
  if [ ! -f "$model" ]; then
    echo "   $model is not there: the teapot stands in"
    "$render" --stats --samples 8 --size 1280x960 --texture checker -o "out/$name.png"
  else
    "$render" --stats --samples 8 --size 1280x960 "$@" -o "out/$name.png" "$model"
  fi
}

echo "== Rendering"
picture duck "$models/Collada/duck.dae" --orbit 35,15 --specular 0.35 --exponent 60 --background 0.75
picture spider "$models/OBJ/spider.obj" --orbit 35,30 --background 0.75
"$render" --stats --samples 8 --size 1280x960 --tessellation 32 --orbit 25,25 --background 0.1,0.12,0.15 --exponent 120 \
  -o out/teapot.png

echo "== Done. The pictures:"
for name in duck spider teapot; do
  echo "   $PWD/out/$name.png"
done
echo "Your own model: $render MODEL -o OUT.png; $render --help lists the options."
