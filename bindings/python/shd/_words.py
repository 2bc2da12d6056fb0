# SPDX-License-Identifier: MIT
"""Texts of the C headers in the words of Python: "trilinear" for SHD_FILTER_TRILINEAR, SamplerDesc for shd_sampler_desc,
Texture() for shd_texture_create() and None for NULL. generate.py has the same names from here."""
import re

WORD = re.compile(r"\bSHD_[A-Z0-9_]+\b|(?<!\w)_[A-Z][A-Z0-9_]*\b|\bshd_\w+\b(?:\(\))?|\bNULL\b")


def camel(name):
    """shd_render_desc -> RenderDesc."""
    return "".join(part.capitalize() for part in name.removeprefix("shd_").split("_"))


def short_name(enum_name, constant_name):
    """SHD_FILTER_EWA of shd_filter -> EWA."""
    prefix = "SHD_" + re.sub(r"_(flag|target)$", "", enum_name.removeprefix("shd_")).upper() + "_"
    return constant_name.removeprefix(prefix).removeprefix("SHD_")


def members(entry):
    """The constants of an enum by their short names, in the order of the header."""
    return {short_name(entry["name"], constant["name"]): constant for constant in entry["constants"]
            if not constant["name"].endswith("_MAX_ENUM")}


def attribute(short):
    """The name of an enum's attribute: 2D -> N2D."""
    return short if short[0].isalpha() else f"N{short}"


class Words:
    """The names of a description: tables of enums, and names of types by their names in C."""

    def __init__(self, enums, types):
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
