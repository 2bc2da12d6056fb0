#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the binary interface of the public headers with the one that is kept in the tree, by libabigail.

    dump.py --include include --library shd|shd_color|shd_embree|shd_io|shd_scene --dumps tests/abi [--compiler cc] [--update]

The interface is taken from a library of stubs: every public function is defined as its header declares it, and every
public enum has a variable, so that constants of words of flags count too. C code compiled in a second with debug
information stands for the real library, whose functions the compiler has checked against the same headers, and whose
exported names symbols.py compares. A dump depends on the headers alone, not on optimisation or the C++ compiler.

abi_<library>.xml is the dump. --update rewrites it, after a change that is meant and stands in CHANGELOG.md. Without
abidw and abidiff (Debian: abigail-tools), and on other machines than the dump's, the test is skipped.
"""
import argparse
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from components import headers_of

SKIPPED = 77
MACHINE = "x86_64"
COMMENT = re.compile(r"/\*.*?\*/", re.S)
FUNCTION = re.compile(r"\bSHD_API\b([^;{]*?)\b(shd_\w+)\s*\(([^;]*)\)\s*;", re.S)
ENUM = re.compile(r"typedef enum (\w+) \{")


def stubs(include, library):
    """C source that defines what the headers of a library declare."""
    headers = headers_of(include, library)
    lines = [f"#include <shd/{h}.h>" for h in headers]
    for header in headers:
        text = COMMENT.sub("", (include / "shd" / f"{header}.h").read_text(encoding="utf-8"))
        text = re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", "", text, flags=re.M)
        for returned, name, parameters in FUNCTION.findall(text):
            body = "" if returned.split() == ["void"] else f"static {returned} value; return value;"
            lines.append(f"{returned} {name}({parameters}) {{ {body} }}")
        lines += [f"{e} {e}_constants;" for e in ENUM.findall(text)]
    return "\n".join([*lines, ""])


def dump(arguments, folder):
    """Path of a fresh dump."""
    source, library, out = folder / "stubs.c", folder / f"lib{arguments.name}.so", folder / "abi.xml"
    source.write_text(stubs(arguments.include, arguments.name), encoding="utf-8")
    subprocess.run([arguments.compiler, "-std=c99", "-g", "-O0", "-fPIC", "-shared", "-w", "-DSHD_BUILDING",
                    "-I", arguments.include.resolve(), f"-Wl,-soname,lib{arguments.name}.so", "-o", library.name,
                    source.name], check=True, cwd=folder)
    subprocess.run(["abidw", "--no-corpus-path", "--no-comp-dir-path", "--no-show-locs", "--no-architecture",
                    "--no-elf-needed", "--no-parameter-names", "--no-write-default-sizes", "--type-id-style", "hash",
                    "--out-file", out, library], check=True)
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--include", type=pathlib.Path, required=True)
    parser.add_argument("--library", dest="name", required=True)
    parser.add_argument("--dumps", type=pathlib.Path, required=True)
    parser.add_argument("--compiler", default="cc")
    parser.add_argument("--update", action="store_true")
    arguments = parser.parse_args()
    missing = [tool for tool in ["abidw", "abidiff"] if not shutil.which(tool)]
    if missing or platform.machine() != MACHINE:
        print(f"skipped: {' and '.join(missing) or platform.machine()} "
              + ("not installed (Debian: abigail-tools)" if missing else f"is not {MACHINE}"))
        return SKIPPED
    kept = arguments.dumps / f"abi_{arguments.name}.xml"
    with tempfile.TemporaryDirectory() as name:
        fresh = dump(arguments, pathlib.Path(name))
        if arguments.update:
            shutil.copyfile(fresh, kept)
            print(f"{kept.name}: {kept.stat().st_size} bytes")
            return 0
        run = subprocess.run(["abidiff", "--no-show-locs", kept, fresh], capture_output=True, text=True)
    print(run.stdout + run.stderr)
    if run.returncode == 0:
        print(f"lib{arguments.name}: the interface is that of {kept.name}")
        return 0
    print(f"lib{arguments.name}: the interface changed. If it was meant to, say so in CHANGELOG.md and run\n"
          f"    tests/abi/update.sh")
    return 1


if __name__ == "__main__":
    sys.exit(main())
