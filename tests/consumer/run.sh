#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds and runs the examples as a user of shd would.
# Usage: run.sh find_package | pkg_config | add_subdirectory | host | preset, with the settings of the build in the
# environment (see CMakeLists.txt). Exit code 77: not for this build.
set -euo pipefail
kind=$1
course=(normal phong texture bump displacement)  # these without assimp: they draw a sphere
examples=(hello lookup levels program custom_allocator own_threads frame shadows "${course[@]}")
[ "$HAS_IO" = 0 ] || [ "$kind" = add_subdirectory ] || examples+=(triangle)
warnings=(-std=c99 -pedantic -Wall -Wextra -Werror)

if [ -n "$SANITIZE" ]; then
  echo "a sanitized library needs a sanitized program: not run"
  exit 77
fi
rm -rf "$WORK"
mkdir -p "$WORK/run"

install_shd() {
  "$CMAKE" --install "$BUILD" --config "$CONFIG" --prefix "$WORK/prefix" >"$WORK/install.log"
}

# run FOLDER: every example in it, from a folder of their own because some write files
run() {
  local example
  cd "$WORK/run"
  for example in "${examples[@]}"; do
    "$1/$example"
  done
}

# build FOLDER OPTIONS...: configures and builds that project
build() {
  local project=$1
  shift
  "$CMAKE" -S "$project" -B "$WORK/build" -G "$GENERATOR" -DCMAKE_BUILD_TYPE="$CONFIG" \
    -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_C_FLAGS="${warnings[*]}" \
    -DEXAMPLES_DIR="$SOURCE/examples" "$@"
  "$CMAKE" --build "$WORK/build" --config "$CONFIG"
}

with_find_package() {
  local components=() file
  [ "$HAS_COLOR" = 0 ] || components+=(color)
  [ "$HAS_IO" = 0 ] || components+=(io)
  [ "$HAS_SCENE" = 0 ] || components+=(scene)
  [ "$HAS_EMBREE" = 0 ] || components+=(embree)
  install_shd
  for file in LICENSE README.md docs/index.md docs/pictures/pipeline.svg examples/hello.c; do
    [ -s "$WORK/prefix/share/doc/shd/$file" ] || { echo "$file is not installed" && exit 1; }
  done
  build "$SOURCE/tests/consumer/find_package" -DCMAKE_PREFIX_PATH="$WORK/prefix" \
    "-DCOMPONENTS=$(IFS=';' && echo "${components[*]:-}")"
  run "$WORK/build"
  "$WORK/build/hello_cpp"
}

# The .pc files of shared libraries work on a machine that has no other .pc file.
check_shared_pc() {
  local path module flags
  for path in "$WORK/prefix/$LIBDIR"/pkgconfig/*.pc; do
    module=$(basename "$path" .pc)
    flags=$(PKG_CONFIG_PATH='' PKG_CONFIG_LIBDIR="$WORK/prefix/$LIBDIR/pkgconfig" pkg-config --cflags --libs "$module")
    if grep -qE -- '-D|-pthread|hwy|tbb|Open|assimp|embree[34]' <<<"${flags//$WORK/}"; then
      echo "$module.pc asks for what is private: $flags"
      exit 1
    fi
  done
}

# A program that links one component, and has a search path for it alone: the component finds libshd beside it.
check_siblings() {
  local lib=$WORK/prefix/$LIBDIR
  find_sibling() {
    printf '#include <shd/%s.h>\nint main(void) { %s return 0; }\n' "$1" "$2" >"$WORK/sibling.c"
    "$CC" -std=c99 -Wall -Wextra -Werror -I"$WORK/prefix/include" "$WORK/sibling.c" -o "$WORK/sibling" "$lib/libshd_$1.so" \
      -Wl,-rpath,"$lib" -Wl,--enable-new-dtags
    env -u LD_LIBRARY_PATH "$WORK/sibling"
  }
  [ "$HAS_COLOR" = 0 ] || find_sibling color 'shd_color_release(NULL);'
  [ "$HAS_IO" = 0 ] || find_sibling io 'shd_bitmap_release(NULL);'
  [ "$HAS_SCENE" = 0 ] || find_sibling scene 'shd_scene_release(NULL);'
  [ "$HAS_EMBREE" = 0 ] || find_sibling embree 'shd_embree_release(NULL);'
}

with_pkg_config() {
  local example modules sources defines flags
  install_shd
  [ "$SHARED" = 0 ] || check_shared_pc
  [ "$SHARED" = 0 ] || check_siblings
  export PKG_CONFIG_PATH="$WORK/prefix/$LIBDIR/pkgconfig" LD_LIBRARY_PATH="$WORK/prefix/$LIBDIR"
  for example in "${examples[@]}"; do
    modules=(shd) sources=("$SOURCE/examples/$example.c") defines=()
    if [[ " ${course[*]} " == *" $example "* ]]; then
      sources=("$SOURCE/examples/course/"{"$example",course,course_model,course_options}.c)
      [ "$HAS_IO" = 0 ] || { modules+=(shd_io) && defines+=(-DEXAMPLE_HAS_IO); }
    elif [ "$example" = triangle ]; then
      modules+=(shd_io)
    elif [ "$example" = frame ] || [ "$example" = shadows ]; then
      sources+=("$SOURCE/examples/frame_scene.c")
      [ "$HAS_COLOR" = 0 ] || { modules+=(shd_color) && defines+=(-DEXAMPLE_HAS_COLOR); }
      [ "$HAS_IO" = 0 ] || { modules+=(shd_io) && defines+=(-DEXAMPLE_HAS_IO); }
      [ "$HAS_SCENE" = 0 ] || modules+=(shd_scene)
    fi
    read -ra flags <<<"$(pkg-config --cflags --libs "${modules[@]}")"
    "$CC" "${warnings[@]}" "${defines[@]}" "${sources[@]}" -o "$WORK/$example" "${flags[@]}" -lm -pthread
  done
  run "$WORK"
  read -ra flags <<<"$(pkg-config --cflags --libs shd)"
  "$CXX" -std=c++17 -Wall -Wextra -Werror "$SOURCE/bindings/cpp/hello.cpp" -o "$WORK/hello_cpp" "${flags[@]}" -pthread
  "$WORK/hello_cpp"
}

# One generic SIMD target and no files or colour: quick to build, and the options an embedder would turn. A compiler
# cache shares the objects with a build of the preset `core`, which has warnings as errors.
# One SIMD target, because the build of the stage compiles the others with the same options.
with_add_subdirectory() {
  build "$SOURCE/tests/consumer/add_subdirectory" -DSHD_SOURCE_DIR="$SOURCE" -DBUILD_SHARED_LIBS="$SHARED" \
    -DSHD_WERROR=ON -DSHD_SIMD=scalar \
    -DSHD_WITH_TBB="$HAS_TBB" -DCMAKE_CXX_COMPILER_LAUNCHER="$LAUNCHER"
  run "$WORK/build"
}

# A host that sets nothing, not even a build type: it keeps its settings, and installs its own file alone. The sources of
# shd are optimised.
with_host() {
  "$CMAKE" -S "$SOURCE/tests/consumer/host" -B "$WORK/build" -G "$GENERATOR" -DCMAKE_C_COMPILER="$CC" \
    -DCMAKE_CXX_COMPILER="$CXX" -DSHD_SOURCE_DIR="$SOURCE" -DSHD_WITH_TBB="$HAS_TBB" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
  grep '"command"' "$WORK/build/compile_commands.json" | grep -F "$SOURCE/src/" >"$WORK/commands"
  [ -s "$WORK/commands" ]
  if grep -vE -- ' -O[23] .*-DNDEBUG ' "$WORK/commands"; then
    echo "these sources of shd are compiled without optimisation" && exit 1
  fi
  "$CMAKE" --install "$WORK/build" --prefix "$WORK/prefix"
  diff <(cd "$WORK/prefix" && find . -type f) <(echo ./host.txt)
}

# The commands of README for the libraries alone configure without the packages of the tests.
with_preset() {
  grep -qF 'cmake --preset library' "$SOURCE/README.md"
  command -v ninja >/dev/null || exit 77
  cd "$SOURCE"
  "$CMAKE" --preset library -B "$WORK/build" -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" \
    -DSHD_WITH_IO="$HAS_IO" -DSHD_WITH_OCIO="$HAS_COLOR" -DSHD_WITH_TBB="$HAS_TBB" -DSHD_WITH_SCENE="$HAS_SCENE" \
    -DCMAKE_DISABLE_FIND_PACKAGE_cmocka=ON -DCMAKE_DISABLE_FIND_PACKAGE_Python3=ON \
    -DCMAKE_DISABLE_FIND_PACKAGE_benchmark=ON
  grep -qx 'SHD_WERROR:BOOL=OFF' "$WORK/build/CMakeCache.txt"
}

"with_$kind"
