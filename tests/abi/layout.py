#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the sizes of the public structs and the places of their members on this machine as layout_<library>.inc.

    layout.py --include include --output tests/abi [--compiler cc]

The files are for LP64. A change of a released struct is a field appended at its end; everything else breaks callers.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from components import headers_of

COMMENT = re.compile(r"/\*.*?\*/", re.S)
STRUCT = re.compile(r"typedef struct (\w+) \{(.*?)\n\} \1;", re.S)
DECLARATOR = re.compile(r"\(\*(\w+)\)|(\w+)(?:\[\w+\])*$")
TITLE = {
    "shd": "The public structs of libshd on LP64: members in order. Padding is a row of its own; it is never given to a "
           "member.",
    "shd_color": "The public structs of libshd_color on LP64; see layout_shd.inc.",
    "shd_io": "The public structs of libshd_io on LP64; see layout_shd.inc.",
    "shd_scene": "The public structs of libshd_scene on LP64; see layout_shd.inc.",
}


def structs(header):
    """Name and members of each struct of a header, in order."""
    text = COMMENT.sub("", header.read_text(encoding="utf-8"))
    for name, body in STRUCT.findall(text):
        members = []
        for declaration in body.split(";"):
            declaration = " ".join(declaration.split())
            if not declaration:
                continue
            if "(" in declaration:  # a callback, or a pointer to arrays
                members.append(re.search(r"\(\*(?:const )?(\w+)\)", declaration).group(1))
                continue
            for part in declaration.split(","):
                members.append(DECLARATOR.search(part.strip()).group(2))
        yield name, members


def program(headers, rows):
    lines = ["#include <stddef.h>", "#include <stdio.h>", *[f"#include <shd/{h}.h>" for h in headers],
             "int main(void)", "{", "    size_t end;"]
    for name, members in rows:
        lines += [f'    printf("SHD_STRUCT({name}, %zu)\\n", sizeof({name}));', "    end = 0;"]
        for member in members:
            size = f"sizeof((({name} *)0)->{member})"
            lines += [
                f"    if (offsetof({name}, {member}) != end)",
                f'        printf("SHD_PADDING({name}, %zu, %zu)\\n", end, offsetof({name}, {member}) - end);',
                f'    printf("SHD_FIELD({name}, {member}, %zu, %zu)\\n", offsetof({name}, {member}), {size});',
                f"    end = offsetof({name}, {member}) + {size};"]
        lines.append(f'    if (end != sizeof({name})) printf("SHD_PADDING({name}, %zu, %zu)\\n", end, '
                     f"sizeof({name}) - end);")
    return "\n".join([*lines, "    return 0;", "}", ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--include", type=pathlib.Path, required=True)
    parser.add_argument("--output", type=pathlib.Path, required=True)
    parser.add_argument("--compiler", default="cc")
    arguments = parser.parse_args()
    for library in TITLE:
        headers = headers_of(arguments.include, library)
        rows = sorted(r for h in headers for r in structs(arguments.include / "shd" / f"{h}.h"))
        with tempfile.TemporaryDirectory() as folder:
            source, binary = pathlib.Path(folder) / "layout.c", pathlib.Path(folder) / "layout"
            source.write_text(program(headers, rows), encoding="utf-8")
            subprocess.run([arguments.compiler, "-I", arguments.include, source, "-o", binary], check=True)
            text = subprocess.run([binary], check=True, capture_output=True, text=True).stdout
        head = f"/* SPDX-License-Identifier: MIT */\n/* {TITLE[library]}\n   Written by layout.py. */\n"
        kept = arguments.output / f"layout_{library.removeprefix('shd_')}.inc"
        kept.write_text(head + text, encoding="utf-8")
        print(f"{kept.name}: {len(rows)} structs")
    return 0


if __name__ == "__main__":
    sys.exit(main())
