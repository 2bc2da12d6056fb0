# SPDX-License-Identifier: MIT
# Static libraries from the sources of Debian's packages, for scripts of bash that are in the folder of the build. The
# sources are those of the installed headers, from Debian's archive, through a private copy of the lists of apt: the
# system's lists stay as they are. Exit code 77: the sources cannot be had.

skip() { echo "skipped: $*"; exit 77; }

# Sets apt_options, once the lists are there.
list_sources() {
  local file
  command -v apt-get > /dev/null && command -v dpkg-source > /dev/null \
    || skip "no apt-get or dpkg-source (Debian: dpkg-dev)"
  mkdir -p apt/sources apt/lists/partial apt/cache/archives/partial source
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/debian.sources; do
    if [ ! -e "$file" ]; then continue; fi
    sed -E 's/^Types: .*/Types: deb-src/; s/^deb /deb-src /' "$file" > "apt/sources/${file##*/}"
  done
  if [ -e apt/sources/sources.list ]; then mv apt/sources/sources.list apt/sources/main.list; fi
  apt_options=(-qq -o "Dir::Etc::SourceList=/dev/null" -o "Dir::Etc::SourceParts=$PWD/apt/sources"
               -o "Dir::State::Lists=$PWD/apt/lists" -o "Dir::Cache=$PWD/apt/cache" -o "APT::Sandbox::User=root")
  apt-get "${apt_options[@]}" update > apt/log 2>&1 || skip "apt-get update failed: $(tail -1 apt/log)"
}

# package of the headers, source package, folder of its files: the newest revision, which can be had, of the version of
# the headers
fetch() {
  local installed version
  installed=$(dpkg-query -W -f '${source:Version}' "$1" 2> /dev/null) || skip "$1 is not installed (Debian: $1)" >&2
  for version in $(apt-cache "${apt_options[@]}" showsrc "$2" | sed -n "s/^Version: //p" | grep -F "${installed%-*}-" | sort -rV); do
    rm -rf "source/$3"
    mkdir -p "source/$3"
    (cd "source/$3" && apt-get "${apt_options[@]}" source "$2=$version" > ../log 2>&1) || continue
    find "source/$3" -mindepth 1 -maxdepth 1 -type d
    return
  done
  skip "no source of $2 ${installed%-*}" >&2
}

# source folder, target, name of the library, options of cmake...: makes lib<name>.a here unless it is there, with the
# options in build_options, too
build() {
  local source=$1 target=$2 library=$3
  shift 3
  if [ -e "lib$library.a" ]; then return; fi
  mkdir -p build
  rm -rf "build/$target"  # of an attempt with other options
  cmake -S "$source" -B "build/$target" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF \
    "${build_options[@]}" "$@" > "build/$target.log" 2>&1 || { tail -20 "build/$target.log"; exit 1; }
  cmake --build "build/$target" --target "$target" -j "$jobs" >> "build/$target.log" 2>&1 \
    || { tail -20 "build/$target.log"; exit 1; }
  find "build/$target" -name "lib$library.a" -exec cp {} . \;
  test -e "lib$library.a"
}
