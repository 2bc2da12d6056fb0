# SPDX-License-Identifier: MIT
"""Names and comments of Rust for those of C."""
import re

KEYWORDS = {"box", "in", "type", "ref", "move", "use", "where", "match", "loop", "final", "override", "yield", "fn"}


def camel(name):
    return "".join(part.capitalize() for part in name.removeprefix("shd_").split("_"))


def field_name(name):
    return f"r#{name}" if name in KEYWORDS else name


def flag_word(name, typedefs):
    """The enum whose bits a word of flags has, or None."""
    return next((t["bits_of"] for t in typedefs if t["name"] == name and "bits_of" in t), None)


def doc_lines(text, indent=""):
    """Lines of a comment. Indented lines would be code to rustdoc, and brackets would be links."""
    text = re.sub(r"@(?:ref|anchor) (\w+)", r"\1", text)
    for line in text.split("\n") if text else []:
        parts = line.strip().split("`")
        parts[::2] = [re.sub(r"([\[\]<])", r"\\\1", part) for part in parts[::2]]
        yield f"{indent}/// {'`'.join(parts)}".rstrip()
