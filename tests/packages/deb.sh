# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2154,SC2034
# Debian packages by CPack, and their installation in a chroot of Debian 12; sourced by run.sh.
command -v dpkg-shlibdeps >/dev/null || skip "no dpkg-shlibdeps (Debian: dpkg-dev)"
command -v file >/dev/null || skip "no file (Debian: file)"
# Beside the build that this test belongs to, so that the compiler's cache has the objects.
tree=$(dirname "${BUILD:-$SOURCE/build/packages}")/deb
export CCACHE_BASEDIR=$SOURCE
multiarch=$(dpkg-architecture -qDEB_HOST_MULTIARCH)

build_packages() {
  "$CMAKE" -S "$SOURCE" -B "$tree" -G "$GENERATOR" -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER="$CC" \
    -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_C_COMPILER_LAUNCHER="$LAUNCHER" -DCMAKE_CXX_COMPILER_LAUNCHER="$LAUNCHER" \
    -DCMAKE_INSTALL_PREFIX=/usr -DCMAKE_INSTALL_LIBDIR="lib/$multiarch" -DCMAKE_INSTALL_LIBEXECDIR="lib/$multiarch" \
    -DCMAKE_SKIP_INSTALL_RPATH=ON -DSHD_WERROR=ON -DSHD_DEB=ON -DSHD_BUILD_TESTS=OFF -DSHD_BUILD_EXAMPLES=OFF
  "$CMAKE" --build "$tree" -j "$JOBS"
  rm -rf "$tree/"*.deb "$tree/_CPack_Packages" "$WORK/packages"
  mkdir "$WORK/packages"
  (cd "$tree" && cpack -G DEB)
  mv "$tree/"*.deb "$WORK/packages"
}

check_with_lintian() {
  if ! command -v lintian >/dev/null; then
    echo "not checked: no lintian (Debian: lintian)"
    return
  fi
  lintian --allow-root --fail-on error,warning --suppress-tags initial-upload-closes-no-bugs "$WORK/packages/"*.deb
  echo "lintian: no error, no warning"
}

# gdb finds the debug information of the library, and prints a handle by it.
check_debugger() {
  if ! command -v gdb >/dev/null; then
    echo "not checked: no gdb (Debian: gdb)"
    return
  fi
  local package debug=$WORK/debug out
  rm -rf "$debug"
  for package in "$WORK/packages/"libshd[0-9]*.deb "$WORK/packages/"libshd-dev_*.deb; do dpkg-deb -x "$package" "$debug"; done
  "$CC" -std=c99 -g "-I$debug/usr/include" "$SOURCE/examples/hello.c" -o "$debug/hello" "-L$debug/usr/lib/$multiarch" -lshd
  out=$(LD_LIBRARY_PATH=$debug/usr/lib/$multiarch gdb -nx -batch -iex 'set debuginfod enabled off' \
    -iex "set debug-file-directory $debug/usr/lib/debug" \
    -ex "source $(echo "$debug/usr/share/gdb/auto-load/usr/lib/$multiarch/libshd.so."*-gdb.py)" \
    -ex 'break shd_texture_sample' -ex run -ex up -ex 'print texture' "$debug/hello" 2>&1 </dev/null)
  grep -qF ': 2D, 2 x 2, SHD_FORMAT_R8, 1 level, 1 layer; 1 reference' <<<"$out" || die "gdb does not print a texture: $out"
  echo "gdb prints a texture"
}

# Without root or debootstrap: the packages unpacked, and a search path.
run_unpacked() {
  local package
  say "unpacked: a chroot needs root and debootstrap (Debian: debootstrap)"
  rm -rf "$WORK/root"
  for package in "$WORK/packages/"*.deb; do dpkg-deb -x "$package" "$WORK/root"; done
  build_c_programs "$WORK" "-I$WORK/root/usr/include" "-L$WORK/root/usr/lib/$multiarch" -lshd
  LD_LIBRARY_PATH=$WORK/root/usr/lib/$multiarch run_c_programs "$WORK"
}

# Inside the chroot: no file of the packages is left behind, nor a package that they depend on.
purge_all() {
  # shellcheck disable=SC2016 # the shell inside expands it
  inside sh -c 'names=$(dpkg-query -W -f "\${Package}\n" "libshd*" shd-tools python3-shd 2>/dev/null); [ -z "$names" ] ||
    apt-get purge -qy $names >/dev/null; apt-get autoremove --purge -qy >/dev/null'
  local left
  left=$(find "$root/usr" "$root/etc" -name '*shd*' ! -path '*/share/zoneinfo/*' | head)
  [ -z "$left" ] || die "left behind by apt-get purge: $left"
}

# package...: installs packages of this build, and what they depend on from Debian
install_built() {
  local name files=()
  for name in "$@"; do files+=("/packages/$name"); done
  inside env DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends "${files[@]}" \
    >"$WORK/apt.log" 2>&1 || { cat "$WORK/apt.log" && exit 1; }
}

run_in_chroot() {
  # shellcheck source=tests/support/debian13_chroot.sh
  . "$SOURCE/tests/support/debian13_chroot.sh"
  suite=bookworm root=$SOURCE/build/debian12
  open_chroot
  inside apt-get update -q >/dev/null
  purge_all
  install_packages gcc libc6-dev pkg-config
  rm -rf "$root/packages"
  cp -r "$WORK/packages" "$root/packages"
  cp "$SOURCE/examples/hello.c" "$SOURCE/bindings/c/programs.c" "$root/packages"

  say "libshd alone"
  (cd "$WORK/packages" && install_built libshd[0-9]*.deb)
  ! inside test -e /usr/include/shd || die "the headers are in the package of the library"
  inside ldconfig -p | grep -F libshd.so || die "ldconfig did not run"

  say "every package"
  (cd "$WORK/packages" && install_built ./*.deb)
  for name in hello programs; do
    inside sh -c "cd /packages && gcc -std=c99 -O2 $name.c -o $name \$(pkg-config --cflags --libs shd)"
  done
  inside /packages/hello
  check_programs chroot "$root" /packages/programs
  for name in color io scene embree; do
    [ ! -e "$root/usr/include/shd/$name.h" ] || check_component "$name"
  done
  render_teapot
  [ -z "$(find "$WORK/packages" -name 'python3-shd_*')" ] || check_python
  purge_all
}

# name: a program that links the component starts, so that all of its libraries are there
check_component() {
  local object=$1
  [ "$1" != io ] || object=bitmap
  printf '#include <stddef.h>\n#include <shd/%s.h>\nint main(void) { shd_%s_release(NULL); return 0; }\n' "$1" \
    "$object" >"$root/packages/component.c"
  inside sh -c "cd /packages && gcc -std=c99 component.c -o component \$(pkg-config --cflags --libs shd_$1)"
  inside /packages/component
  echo "libshd_$1 starts"
}

# The programs of the Python package, which finds the libraries by their names.
check_python() {
  cp "$SOURCE/bindings/python/examples/programs.py" "$root/packages"
  check_programs chroot "$root" python3 /packages/programs.py
  inside python3 -c 'import shd.scene; print("python3-shd", shd.__file__)'
}

render_teapot() {
  inside shd-render --size 64x48 -o /packages/teapot.png
  [ "$(head -c 4 "$root/packages/teapot.png" | tail -c 3)" = PNG ] || die "shd-render wrote no PNG"
  for name in shd-render shd-check shd-maketx; do
    inside "$name" --version
    inside test -s "/usr/share/man/man1/$name.1.gz" || die "the manual of $name is missing"
    inside test -s "/usr/share/bash-completion/completions/$name" || die "the completion of $name is missing"
  done
}

build_packages
check_with_lintian
check_debugger
if [ "$(id -u)" -eq 0 ] && command -v debootstrap >/dev/null; then run_in_chroot; else run_unpacked; fi
