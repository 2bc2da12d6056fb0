#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Gets the headers of GDNative from Debian's source package of Godot 3, which no binary package has.
#
#   fetch_headers.sh FOLDER     FOLDER/include then has gdnative/ and gdnative_api_struct.gen.h
#
# It downloads about 22 MB with apt, under an own configuration: the sources.list of the machine does not change. The
# API struct is written by Godot's own gdnative_builders.py.
set -euo pipefail
folder=$(realpath -m "${1:?usage: fetch_headers.sh FOLDER}")
# shellcheck source=/dev/null
suite=$(. /etc/os-release && echo "${VERSION_CODENAME:?the release of Debian is unknown}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mkdir -p "$work/lists/partial" "$work/cache/archives/partial"
echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian $suite main" \
  >"$work/sources.list"
options=(-o "Dir::Etc::sourcelist=$work/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::Lists=$work/lists"
  -o "Dir::Cache=$work/cache" -o APT::Sandbox::User=root -o APT::Get::List-Cleanup=0)
apt-get "${options[@]}" -q update
cd "$work"
apt-get "${options[@]}" -q --download-only source godot3

# Only the module that has the interface is unpacked.
tar -xf godot_*.orig.tar.* --wildcards '*/modules/gdnative/*' '*/LICENSE.txt'
module=$(echo "$work"/*/modules/gdnative)
python3 - "$module" <<'PYTHON'
import pathlib
import sys
import types

# The builders import a helper of the build for subprocesses, which is not needed here.
sys.modules["platform_methods"] = types.ModuleType("platform_methods")
sys.modules["platform_methods"].subprocess_main = None
sys.dont_write_bytecode = True
module = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(module))
import gdnative_builders

gdnative_builders.build_gdnative_api_struct(
    [str(module / "include/gdnative_api_struct.gen.h"), str(module / "gdnative_api_struct.gen.cpp")],
    [str(module / "gdnative_api.json")], None)
PYTHON
rm -rf "$folder/include"
mkdir -p "$folder"
cp -r "$module/include" "$folder/include"
cp "$work"/*/LICENSE.txt "$folder/"
test -s "$folder/include/gdnative_api_struct.gen.h"
echo "headers of GDNative: -DGODOT_HEADERS=$folder/include"
