#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares what a library exports with the list that is kept in the tree, and the list with the headers.

    symbols.py shd_io --include include [--library libshd_io.so]   compare with symbols_shd_io.txt; 1 on any difference
    symbols.py shd_io --include include --update                   rewrite the list

A shared library may export the listed functions and nothing else. Without --library (static builds export
everything) only the headers are compared.
"""
import argparse
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True
from components import LIBRARIES, headers_of

DECLARATION = re.compile(r"\bSHD_API\b[^;(]*?\b(shd_\w+)\s*\(", re.S)
COMMENT = re.compile(r"/\*.*?\*/", re.S)
PREPROCESSOR = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.M)


def declared(headers):
    names = set()
    for header in headers:
        text = PREPROCESSOR.sub("", COMMENT.sub("", header.read_text(encoding="utf-8")))
        names.update(DECLARATION.findall(text))
    return names


def exported(nm, library):
    output = subprocess.run([nm, "-D", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    return {line.split()[-1].split("@")[0] for line in output.splitlines() if line.strip()}


def report(what, names):
    for name in sorted(names):
        print(f"{what}: {name}")
    return bool(names)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("name", choices=LIBRARIES)
    parser.add_argument("--include", type=pathlib.Path, required=True)
    parser.add_argument("--library", dest="path")
    parser.add_argument("--nm", default="nm")
    parser.add_argument("--update", action="store_true")
    arguments = parser.parse_args()

    kept = pathlib.Path(__file__).resolve().parent / f"symbols_{arguments.name}.txt"
    headers = headers_of(arguments.include, arguments.name)
    in_headers = declared(arguments.include / "shd" / f"{h}.h" for h in headers)
    if arguments.update:
        kept.write_text("".join(f"{name}\n" for name in sorted(in_headers)), encoding="utf-8")
        return 0
    lines = kept.read_text(encoding="utf-8").splitlines()
    listed = set(lines)
    failed = lines != sorted(listed)
    if failed:
        print(f"{kept.name}: not sorted, or a name twice")
    failed |= report("declared but not listed", in_headers - listed)
    failed |= report("listed but not declared", listed - in_headers)
    if arguments.path:
        found = exported(arguments.nm, arguments.path)
        failed |= report("listed but not exported", listed - found)
        failed |= report("exported but not listed", found - listed)
        print(f"{pathlib.Path(arguments.path).name}: {len(found)} symbols exported, {len(listed)} listed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
