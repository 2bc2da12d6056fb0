#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a shared library loads directly, and what it runs when it is loaded.

    needed.py libraries libshd.so --allow libhwy libm ...   each NEEDED entry is an allowed name
    needed.py constructors libshd.so [--entries 1]          .init_array holds so many entries: 1 is the compiler's
                                                            frame_dummy, which runs no code of the library
"""
import argparse
import pathlib
import re
import struct
import subprocess
import sys

NEEDED = re.compile(r"\(NEEDED\).*\[(.+)\]")
# name, type, address, offset, size as readelf -SW prints them
INIT_ARRAY = re.compile(r"\.init_array\s+INIT_ARRAY\s+[0-9a-f]+\s+[0-9a-f]+\s+([0-9a-f]+)")
# Libraries that any link of C++ adds.
ALWAYS = ["libgcc_s", "libc"]


def readelf(option, library):
    return subprocess.run(["readelf", option, library], check=True, capture_output=True, text=True).stdout


def check_libraries(library, allowed):
    needed = NEEDED.findall(readelf("-dW", library))
    extra = [n for n in needed if n.split(".so")[0] not in {*allowed, *ALWAYS} and not n.startswith("ld-linux")]
    print(f"{pathlib.Path(library).name} loads: {' '.join(needed)}")
    for name in extra:
        print(f"not allowed: {name}")
    return bool(extra) or not needed


def check_constructors(library, entries):
    size = sum(int(s, 16) for s in INIT_ARRAY.findall(readelf("-SW", library)))
    pointer = struct.calcsize("P")
    print(f"{pathlib.Path(library).name}: {size // pointer} entries in .init_array, {entries} expected")
    return size != entries * pointer


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("check", choices=["libraries", "constructors"])
    parser.add_argument("path", metavar="library")
    parser.add_argument("--allow", nargs="*", default=[])
    parser.add_argument("--entries", type=int, default=1)
    arguments = parser.parse_args()
    if arguments.check == "libraries":
        return int(check_libraries(arguments.path, arguments.allow))
    return int(check_constructors(arguments.path, arguments.entries))


if __name__ == "__main__":
    sys.exit(main())
