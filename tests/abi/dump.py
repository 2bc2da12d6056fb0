#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Dumps of the binary interface of the public headers, by libabigail. They are made at a tag.

    dump.py write --include include --dumps FOLDER      writes FOLDER/abi_<library>.xml
    dump.py compare --include include --dumps FOLDER    compares the headers with the dumps
    dump.py test --include include --older FOLDER --dumps FOLDER
                                                        writes dumps; `compare` must accept the same headers and refuse
                                                        the older ones

The interface is taken from a library of stubs: every public function is defined as its header declares it, and every
public enum has a variable, so that constants of words of flags count too. C code compiled in a second with debug
information stands for the real library, whose functions the compiler has checked against the same headers, and whose
exported names symbols.py compares. A dump depends on the headers alone, not on optimisation or the C++ compiler.

Without abidw and abidiff (Debian: abigail-tools), and on other machines than x86_64, `test` is skipped.
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
from components import LIBRARIES, headers_of

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
            body = "" if returned.split() == ["void"] else f"static {returned} stub_result; return stub_result;"
            lines.append(f"{returned} {name}({parameters}) {{ {body} }}")
        lines += [f"{e} {e}_constants;" for e in ENUM.findall(text)]
    return "\n".join([*lines, ""])


def dump(compiler, include, library, folder):
    """Path of a fresh dump."""
    source, binary, out = folder / "stubs.c", folder / f"lib{library}.so", folder / "abi.xml"
    source.write_text(stubs(include, library), encoding="utf-8")
    subprocess.run([compiler, "-std=c99", "-g", "-O0", "-fPIC", "-shared", "-w", "-DSHD_BUILDING",
                    "-I", include.resolve(), f"-Wl,-soname,lib{library}.so", "-o", binary.name, source.name],
                   check=True, cwd=folder)
    subprocess.run(["abidw", "--no-corpus-path", "--no-comp-dir-path", "--no-show-locs", "--no-architecture",
                    "--no-elf-needed", "--no-parameter-names", "--no-write-default-sizes", "--type-id-style", "hash",
                    "--out-file", out, binary], check=True)
    return out


def for_each_dump(arguments, include, use):
    """Calls use(path of a fresh dump, path of the kept dump) for each library; the largest exit code."""
    codes = []
    for library in LIBRARIES:
        with tempfile.TemporaryDirectory() as folder:
            fresh = dump(arguments.compiler, include, library, pathlib.Path(folder))
            codes.append(use(fresh, arguments.dumps / f"abi_{library}.xml"))
    return max(codes)


def write(fresh, kept):
    kept.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(fresh, kept)
    print(f"{kept.name}: {kept.stat().st_size} bytes")
    return 0


def compare(fresh, kept):
    run = subprocess.run(["abidiff", "--no-show-locs", kept, fresh], capture_output=True, text=True)
    print(run.stdout + run.stderr + ("" if run.returncode else f"the interface is that of {kept.name}"))
    return int(run.returncode != 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=["write", "compare", "test"])
    parser.add_argument("--include", type=pathlib.Path, required=True)
    parser.add_argument("--dumps", type=pathlib.Path, required=True)
    parser.add_argument("--older", type=pathlib.Path)
    parser.add_argument("--compiler", default="cc")
    arguments = parser.parse_args()
    missing = [tool for tool in ["abidw", "abidiff"] if not shutil.which(tool)]
    if missing or platform.machine() != MACHINE:
        print(f"skipped: {' and '.join(missing) or platform.machine()} "
              + ("not installed (Debian: abigail-tools)" if missing else f"is not {MACHINE}"))
        return SKIPPED if arguments.action == "test" else 1
    if arguments.action != "test":
        return for_each_dump(arguments, arguments.include, write if arguments.action == "write" else compare)
    for_each_dump(arguments, arguments.include, write)
    if for_each_dump(arguments, arguments.include, compare):
        return 1
    if for_each_dump(arguments, arguments.older, compare):
        return 0
    print("the older headers were not refused")
    return 1


if __name__ == "__main__":
    sys.exit(main())
