#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# wheel.sh FOLDER [option of cmake]...: builds the wheels shd and shd-color in FOLDER/dist, and audits them. The builds are
# FOLDER-core and FOLDER-color. ccache finds objects of another build whose folder has equal depth.
#
# The wheel shd has libshd, libshd_io with the decoders of its own, the program that decodes, and libshd_scene with its
# readers. All they need besides glibc is linked in; glibc 2.28 suffices. PYTHON is the interpreter with pip, wheel and
# setuptools; JOBS the number of compilers; COLOR=0 leaves out shd-color.
# Exit code 77: a tool or the sources of the libraries are absent.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
mkdir -p "$1"
work=$(cd "$1" && pwd)
shift
python=${PYTHON:-python3}
jobs=${JOBS:-$(nproc)}
if ! "$python" -c 'import setuptools, pip, wheel' 2> /dev/null || ! command -v strip > /dev/null; then
  echo "skipped: no strip, or $python lacks pip, setuptools or wheel (Debian: binutils python3-pip python3-wheel)"
  exit 77
fi
"$here/wheel/libraries.sh" "$work/libraries"
dist=$work/dist
rm -rf "$dist"
mkdir -p "$dist"

# folder, linker flags, option of cmake...: configures a build with RPATH $ORIGIN
configure() {
  local build=$1 link=$2
  shift 2
  cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DSHD_BUILD_TESTS=OFF -DSHD_BUILD_EXAMPLES=OFF \
    -DSHD_BUILD_TOOLS=OFF -DSHD_WITH_EMBREE=OFF -DSHD_WHEEL_LIBRARIES="$work/libraries" \
    -Dhwy_DIR="$here/wheel/static" -DTBB_DIR="$here/wheel/static" \
    -Ddraco_DIR="$here/wheel/static" -Dmeshoptimizer_DIR="$here/wheel/static" \
    -DCMAKE_BUILD_WITH_INSTALL_RPATH=ON -DCMAKE_INSTALL_RPATH="\$ORIGIN" \
    -DCMAKE_SHARED_LINKER_FLAGS="$link" -DCMAKE_MODULE_LINKER_FLAGS="$link" "$@" > "$build.log" 2>&1 \
    || { tail -20 "$build.log"; exit 1; }
}
build() {
  cmake --build "$1" -j "$jobs" --target "${@:2}" >> "$1.log" 2>&1 || { tail -40 "$1.log"; exit 1; }
}

# glibc 2.28 has the functions of threads and of dlopen in two libraries of their own.
link="-static-libstdc++ -static-libgcc $work/libraries/glibc.o \
-Wl,--push-state,--no-as-needed,-l:libpthread.so.0,-l:libdl.so.2,-lm,--pop-state -Wl,--exclude-libs,ALL,--gc-sections"
PKG_CONFIG_PATH=$work/libraries/pkgconfig configure "$work-core" "$link" -DCMAKE_EXE_LINKER_FLAGS="$link $work/libraries/start.o" \
  -DSHD_WITH_OIIO=OFF -DSHD_WITH_ASSIMP=OFF -DSHD_WITH_OPENVDB=OFF -DSHD_WITH_ASTCENC=OFF -DSHD_WITH_OCIO=OFF "$@"
files=(libshd.so libshd_io.so libshd_scene.so libshd_scene_readers.so shd-io-worker)
build "$work-core" shd shd_io shd_scene
files=("${files[@]/#/$work-core/src/}")
sources=$work/sources  # pip builds inside the sources
rm -rf "$sources"
mkdir -p "$sources/bindings"
cp -r "$here"/../{shd.json,generate.py,generated.py} "$here" "$sources/bindings/"
mkdir "$sources/bindings/python/licenses"  # of all that is linked in
cp "$root/LICENSE" "$sources/bindings/python/licenses/shd.txt"
libstdcxx=$(dpkg -S "$("${CXX:-c++}" -print-file-name=libstdc++.a | xargs realpath)" | cut -d: -f1)
for package in libtbb-dev libhwy-dev libeigen3-dev "$libstdcxx" libpng-dev libjpeg62-turbo-dev zlib1g-dev libzstd-dev \
               libdraco-dev libmeshoptimizer-dev nlohmann-json3-dev; do
  cp "/usr/share/doc/$package/copyright" "$sources/bindings/python/licenses/$package.txt"
done
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-315532800}  # times in the wheel: equal bytes from equal sources
SHD_PLATFORM=$("$here/audit.py" --tag "${files[@]}") SHD_BUNDLE=$(IFS=:; echo "${files[*]}") \
  "$python" -m pip wheel --quiet --disable-pip-version-check --no-index --no-build-isolation --no-deps \
  --wheel-dir "$dist" "$sources/bindings/python"
"$here/audit.py" "$dist"/shd-*.whl
size=$(stat -c %s "$dist"/shd-*.whl)
if [ "$size" -gt 6291456 ]; then
  echo "the wheel has $size bytes, more than 6 MiB"
  exit 1
fi

# libshd_color shares classes of libstdc++ with OpenColorIO, so it needs that of the system. RPATH, unlike RUNPATH, also
# serves the libraries that it needs.
if [ "${COLOR:-1}" = 0 ]; then exit 0; fi
configure "$work-color" "-Wl,--disable-new-dtags" -DSHD_WITH_IO=OFF "$@"
build "$work-color" shd_color
wheel=$("$here/wheel/component.py" color --build "$work-color/src" --output "$dist")
"$here/audit.py" --libstdc++ --beside libshd.so.0.1 "$wheel"
