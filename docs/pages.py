#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Filter of Doxygen for Markdown.

- Links to headings, as GitHub resolves them, become links to labels: Doxygen 1.9.4 has neither a label for each heading
  nor links of the form page.md#heading.
- The first link of index.md to a page, and of filters.md to a page of a filter, makes the page a part of it: the tree of
  pages has the order of these lists.
- Pictures lose their folder, because Doxygen copies them beside the pages and finds them by name.
"""
import pathlib
import re
import sys

HEADING = re.compile(r"^(##+ )(.*\S)\s*$")
PARTS = {"index": r"(?!filter-)[\w-]+", "filters": r"filter-[\w-]+"}
PICTURE = re.compile(r"(!\[[^\]]*\]\()[\w./-]*/([\w-]+\.(?:png|svg)\))")
LINK = re.compile(r"\]\((?:([\w-]+)\.md)?#([\w-]+)\)")


def slug(heading):
    """The name that GitHub gives to a heading."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def label(page, name):
    return f"{page}-{name}".replace("_", "-")


class Parts:
    """Replaces the first link to each part of a page."""

    def __init__(self, page):
        self.link = re.compile(rf"\[([^\]]+)\]\(({PARTS[page]})\.md\)") if page in PARTS else None
        self.seen = set()

    def replace(self, link):
        if link[2] in self.seen:
            return link[0]
        self.seen.add(link[2])
        return f'@subpage md_docs_{link[2].replace("-", "_")} "{link[1]}"'

    def convert(self, line):
        return self.link.sub(self.replace, line) if self.link else line


def convert(page, text):
    is_code = False
    parts = Parts(page)
    for line in text.splitlines():
        if line.startswith("```"):
            is_code = not is_code
        if not is_code:
            heading = HEADING.match(line)
            if heading:
                line = f"{heading[1]}{heading[2]} {{#{label(page, slug(heading[2]))}}}"
            line = PICTURE.sub(r"\1\2", parts.convert(line))
            line = LINK.sub(lambda link: f"](#{label(link[1] or page, link[2])})", line)
        yield line


if __name__ == "__main__":
    source = pathlib.Path(sys.argv[1])
    print("\n".join(convert(source.stem, source.read_text(encoding="utf-8"))))
