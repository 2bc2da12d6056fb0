#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Copies the public headers as another version would have them: sized structs with fewer or with more fields at the end.

    resize_headers.py older|newer --include include --description bindings/shd.json --table src/core/sized_structs.h --output DIR

`older` takes the last field from each sized struct, and the line that gives it a default; another one where padding
would be left at the end, which no version has. Fields up to the required one of the table stay. `newer` appends 12 or 16 bytes.
What was done is written to DIR/resized.txt.
"""
import argparse
import json
import pathlib
import re
import sys

TABLE = re.compile(r"^ +ROW\(\w+, (\w+), (\w+),", re.M)
# Elements whose size the struct that lists them has.
ELEMENTS = ["shd_tap", "shd_blend_step"]
COMMENT = re.compile(r"/\*.*?\*/", re.S)


def read_layouts(description):
    """Size, and name and end of each field, of every struct."""
    structs = json.loads(description.read_text(encoding="utf-8"))["structs"]
    return {s["name"]: (s["size"], [(f["name"], f["offset"] + f["size"]) for f in s["fields"]]) for s in structs}


def fields_to_drop(struct, required, layouts):
    size, fields = layouts[struct]
    alignment = 8 if size % 8 == 0 else 4
    names = [name for name, _ in fields]
    for keep in range(len(fields) - 1, names.index(required), -1):
        if fields[keep - 1][1] % alignment == 0:
            return names[keep:]
    return []


def drop(text, struct, names):
    begin = text.index(f"typedef struct {struct} {{")
    end = text.index(f"\n}} {struct};", begin)
    body = COMMENT.sub("", text[begin:end])
    for name in names:
        body, count = re.subn(rf"[^;{{]*\b{name}\b(\[\w+\])*;", "", body, count=1)
        assert count == 1, f"{struct}.{name}"
    text = text[:begin] + body + text[end:]
    for name in names:
        function = re.search(rf"static inline {struct} {struct}_default\(.*?\n}}\n", text, re.S)
        if function:
            kept = [line for line in function.group(0).split("\n") if not re.search(rf"\.{name}\b", line)]
            text = text[:function.start()] + "\n".join(kept) + text[function.end():]
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("version", choices=["older", "newer"])
    for name in ["include", "description", "table", "output"]:
        parser.add_argument(f"--{name}", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    layouts = read_layouts(arguments.description)
    rows = TABLE.findall(arguments.table.read_text(encoding="utf-8"))
    log = []
    (arguments.output / "shd").mkdir(parents=True, exist_ok=True)
    for header in sorted((arguments.include / "shd").glob("*.h")):
        text = header.read_text(encoding="utf-8")
        for struct, required in rows:
            if f"typedef struct {struct} {{" not in text:
                continue
            names = fields_to_drop(struct, required, layouts)
            if arguments.version == "newer":
                count = 3 if layouts[struct][0] % 8 else 4  # appended fields bring no padding
                text = text.replace(f"\n}} {struct};", f"\n    uint32_t added[{count}];\n}} {struct};")
                names = ["added"]
            elif names:
                text = drop(text, struct, names)
            log.append(f"{struct}: {arguments.version}: {' '.join(names) or 'every field is required'}\n")
        if arguments.version == "newer" and header.name == "explain.h":
            for struct in ELEMENTS:
                text = text.replace(f"\n}} {struct};", f"\n    uint32_t added[2];\n}} {struct};")
        (arguments.output / "shd" / header.name).write_text(text, encoding="utf-8")
    (arguments.output / "resized.txt").write_text("".join(log), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
