#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Padding of the public structs on LP64, from the sizes and offsets of bindings/shd.json, which bindings.offsets checks.

    layout.py DESCRIPTION                   no sized struct ends with padding, where an appended field would lie that
                                            older callers leave undefined
    layout.py DESCRIPTION --paddings FILE   writes a row of C for each piece of padding
"""
import argparse
import json
import pathlib
import sys


def paddings(struct):
    """Offset and size of each piece of padding."""
    end = 0
    for field in [*struct["fields"], {"offset": struct["size"], "size": 0}]:
        if field["offset"] != end:
            yield end, field["offset"] - end
        end = field["offset"] + field["size"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("description", type=pathlib.Path)
    parser.add_argument("--paddings", type=pathlib.Path)
    arguments = parser.parse_args()
    structs = json.loads(arguments.description.read_text(encoding="utf-8"))["structs"]
    rows = [(s, offset, size) for s in structs for offset, size in paddings(s)]
    if arguments.paddings:
        text = "".join(f"SHD_PADDING({s['name']}, {offset}, {size})\n" for s, offset, size in rows)
        arguments.paddings.write_text(text, encoding="utf-8")
        return 0
    wrong = [s["name"] for s, offset, size in rows
             if s["fields"][0]["name"] == "struct_size" and offset + size == s["size"]]
    print("".join(f"{name}: ends with padding\n" for name in wrong) + f"{len(structs)} structs, {len(rows)} paddings")
    return int(bool(wrong))


if __name__ == "__main__":
    sys.exit(main())
