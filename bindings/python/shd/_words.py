# SPDX-License-Identifier: MIT
"""Texts of the C headers in the words of Python: "trilinear" for SHD_FILTER_TRILINEAR, SamplerDesc for shd_sampler_desc,
Texture() for shd_texture_create() and None for NULL."""
import re

WORD = re.compile(r"\bSHD_[A-Z0-9_]+\b|(?<!\w)_[A-Z][A-Z0-9_]*\b|\bshd_\w+\b(?:\(\))?|\bNULL\b")


class Words:
    """The names of a description: tables of enums, and names of types by their names in C."""

    def __init__(self, enums, types, short_name):
        self._constants, self._types = {}, types
        for entry in enums.values():
            for member in entry["constants"]:
                name = short_name(entry["name"], member["name"])
                known = f"Result.{name}" if entry["name"] == "shd_result" else f'"{name.lower()}"'
                self._constants[member["name"]] = known

    def python(self, text):
        """A text with the names of Python. "_RGBA8" behind SHD_FORMAT_RGBA32F is SHD_FORMAT_RGBA8."""
        prefix = ""

        def word(match):
            nonlocal prefix
            name = match[0]
            if name == "NULL":
                return "None"
            if name.startswith("SHD_"):
                prefix = name.rsplit("_", 1)[0] if name in self._constants else prefix
                return self._constants.get(name, name)
            if name.startswith("_"):
                return self._constants.get(prefix + name, name)
            made = name.removesuffix("()").removesuffix("_create")
            if name.endswith("()") and not name.endswith("_create()"):
                return name
            return self._types.get(made, made) + ("()" if name.endswith("()") else "") if made in self._types else name

        return WORD.sub(word, text)
