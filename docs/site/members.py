#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Doxygen's input filter for the public headers: prints a header with one documented member per declaration.

`float *x, *y; /**< position */` becomes two declarations with that comment, on the same line so that line numbers stay.
The second member of a pair, such as `du` and `dv` under one comment, refers to the first. Pages in headers become
paragraphs of the file: docs/ has the pages. The comment of the header ends with links to the pages of the manual that
name it, if the JSON file SHD_DOCS_MANUAL lists them.
"""
import json
import os
import re
import sys

SEVERAL = re.compile(r"^(\s+)((?:const )?\w+ )(\**\w+(?:\[\w+\])?(?:, \**\w+(?:\[\w+\])?)+);(\s*/\*\*<.*)?$")
SINGLE = re.compile(r"^\s+((?:const )?\w+ \**)(\w+)((?:\[\w+\])*);$")
PAGE = re.compile(r"@page \w+")
VERSION = re.compile(r"^#define SHD_VERSION_\w+ \d+$")
PAIRS = [("min", "max"), ("near", "far"), ("du", "dv")]


def spread(line, comment_above):
    match = SEVERAL.match(line)
    if not match:
        return line
    indent, kind, names, comment = match.groups()
    names = names.split(", ")
    if comment and comment.rstrip().endswith("*/"):
        return indent + " ".join(f"{kind}{name};{comment.rstrip()}" for name in names)
    if not comment and comment_above:
        first = re.search(r"\w+", names[0]).group(0)
        return indent + f"{kind}{names[0]}; " + " ".join(f"{kind}{name}; /**< see {first} */" for name in names[1:])
    return line


def partner(line, before):
    """The comment of a member whose partner, in the line before, has one above it."""
    this, other = SINGLE.match(line), SINGLE.match(before)
    if this and other and this.group(1) == other.group(1) and this.group(3) == other.group(3):
        if any(other.group(2).replace(a, b) == this.group(2) for a, b in PAIRS):
            return f"{line} /**< see {other.group(2)} */"
    return line


def manual_links(header):
    """The last line of a header's comment."""
    manual = os.environ.get("SHD_DOCS_MANUAL")
    if not manual:
        return None
    with open(manual, encoding="utf-8") as file:
        pages = json.load(file).get(header, [["all pages", "../index.html"]])
    links = ", ".join(f'<a href="{address}">{title}</a>' for title, address in pages)
    return f" * @par In the manual\n * {links}"


def main():
    before = ""
    links = manual_links(os.path.basename(sys.argv[1]))
    for line in open(sys.argv[1], encoding="utf-8").read().split("\n"):
        if links and line == " */":
            print(links)
            links = None
        line = PAGE.sub("@par", line)
        line = VERSION.sub(r"\g<0> /**< of these headers */", line)
        print(partner(spread(line, before.rstrip().endswith("*/")), before))
        before = line


main()
