#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the documents of a Debian package from LICENSE and CHANGELOG.md.

    documents.py FOLDER --version VERSION --maintainer "NAME <ADDRESS>"

copyright is in the machine-readable format 1.0 of Debian. changelog.gz is CHANGELOG.md. changelog.Debian.gz has an
entry with the first sentences of the newest version of CHANGELOG.md. The date is that of CHANGELOG.md, or
SOURCE_DATE_EPOCH.
"""
import argparse
import email.utils
import gzip
import os
import pathlib
import re
import textwrap

ROOT = pathlib.Path(__file__).resolve().parents[3]
CHANGELOG, LICENSE = ROOT / "CHANGELOG.md", ROOT / "LICENSE"


def copyright_text():
    title, owner, *body = LICENSE.read_text(encoding="utf-8").strip().split("\n\n")
    if title != "MIT License":
        raise SystemExit(f"{LICENSE}: the licence is {title!r}, not the MIT licence that copyright names")
    text = "\n .\n".join(textwrap.indent(paragraph, " ") for paragraph in body)
    return ("Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\nUpstream-Name: shd\n\n"
            f"Files: *\nCopyright: {owner.replace('Copyright (c) ', '')}\nLicense: Expat\n{text}\n")


def newest_changes():
    """The sections of the newest version, each with the first sentences of its items."""
    text = CHANGELOG.read_text(encoding="utf-8")
    version = re.split(r"^## \[", text, flags=re.M)[1]
    for section in re.split(r"^### ", version, flags=re.M)[1:]:
        title, _, rest = section.partition("\n")
        items = [" ".join(item.split()) for item in re.findall(r"^- (.*(?:\n(?:  .*)?)*)", rest, re.M)]
        yield title, [re.split(r"(?<=[.!?]) (?=[A-Z`])", item)[0] for item in items]


def debian_changelog(version, maintainer, when):
    lines = [f"shd ({version}) unstable; urgency=medium", ""]
    for title, items in newest_changes():
        if items:
            lines += [f"  [ {title} ]"]
            lines += [line for item in items for line in
                      textwrap.wrap(item, 76, initial_indent="  * ", subsequent_indent="    ")] + [""]
    date = email.utils.formatdate(when).replace("-0000", "+0000")
    return "\n".join([*lines, f" -- {maintainer}  {date}"]) + "\n"


def write_gzip(path, text):
    path.write_bytes(gzip.compress(text.encode("utf-8"), 9, mtime=0))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--version", required=True)
    parser.add_argument("--maintainer", required=True)
    given = parser.parse_args()
    when = int(os.environ.get("SOURCE_DATE_EPOCH") or CHANGELOG.stat().st_mtime)
    (given.folder / "copyright").write_text(copyright_text(), encoding="utf-8")
    write_gzip(given.folder / "changelog.gz", CHANGELOG.read_text(encoding="utf-8"))
    write_gzip(given.folder / "changelog.Debian.gz", debian_changelog(given.version, given.maintainer, when))


if __name__ == "__main__":
    main()
