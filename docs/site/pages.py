# SPDX-License-Identifier: MIT
"""The pages of docs/ as MkDocs takes them.

The pages are written for GitHub. In the copies, links into the tree lead to the pages of the site, and names of the
interface lead to the reference of the headers.
"""
import re

# Pages of other folders, by their paths from docs/.
OTHER = {"../examples/course/README.md": "course-programs.md"}
PICTURE = re.compile(r"\]\((?:\.\./)+(examples/[\w/.-]+\.png)\)")
# Left as they are: links, code, formulas, tags of HTML. Code that is one name of the interface is a link, too.
SKIPPED = r"!?\[[^\]]*\]\([^)]*\)|`[^`]*`|\$[^$]+\$|<[^>]*>"
NAME = r"(?<![\w/.-])(?:shd/\w+\.h|(?:shd|SHD)_\w*[a-zA-Z0-9](?:\(\))?)(?![\w-]|\.\w)"
TOKEN = re.compile(f"({SKIPPED})|({NAME})")
FENCE = re.compile(r"^(```|\$\$)")


def slug(heading):
    """The name that GitHub gives to a heading."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def lines_outside_code(text):
    """Pairs of a line and whether it is prose: no code, no formula of its own, no heading."""
    is_block = False
    before = ""
    is_indented = False
    for line in text.splitlines():
        if FENCE.match(line):
            is_block = not is_block
            yield line, False
        else:
            is_indented = line.startswith("    ") and (is_indented or not before.strip())
            yield line, not (is_block or is_indented or line.startswith("#"))
        before = line


def link_names(line, places):
    """The line, with links from names of the interface to their places in the reference."""
    def replace(match):
        skipped, name = match.groups()
        if not name and not (skipped and skipped[0] == "`"):
            return match[0]
        place = places.get((name or skipped[1:-1]).removesuffix("()"))
        return f"[{match[0]}]({place})" if place else match[0]
    return TOKEN.sub(replace, line)


def convert(text, places, root="../"):
    """A page of docs/, or of a folder from which docs/ is `root` + "docs/"."""
    for old, new in OTHER.items():
        text = text.replace(f"]({old})", f"]({new})")
    text = text.replace(f"]({root}docs/", "](")
    text = PICTURE.sub(r"](\1)", text)
    lines = (link_names(line, places) if is_prose else line for line, is_prose in lines_outside_code(text))
    return "\n".join(lines) + "\n"
