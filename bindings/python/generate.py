#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes shd/__init__.pyi, the types of descs and enums for editors and type checkers, from shd.json."""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parent))
import generated

OUTPUT = HERE / "shd/__init__.pyi"
HEAD = '''# SPDX-License-Identifier: MIT
# Types of the module's descs and enums. Written by generate.py; do not edit.
import enum
from typing import Any, Callable, Mapping, Sequence, Union

import numpy as np

from ._api import Error as Error, InvalidArgument as InvalidArgument, OutOfMemory as OutOfMemory
from . import color as color, embree as embree, io as io, pyrender as pyrender, renderer as renderer, scene as scene
from ._bake import (bake as bake, bake_occlusion as bake_occlusion, occlusion as occlusion,
                    vertex_occlusion as vertex_occlusion)
from ._desc import Desc as Desc
from ._environment import Environment as Environment
from ._frame import Framebuffer as Framebuffer, render as render
from ._png import save_png as save_png
from ._objects import (Context as Context, Light as Light, Material as Material, Mesh as Mesh, Object as Object,
                       Sampler as Sampler, slot as slot)
from ._projection import convert_projection as convert_projection, project as project, unproject as unproject
from ._shadow import Shadow as Shadow
from ._solid import evaluate_solid as evaluate_solid
from ._texture import Lookup as Lookup, Texture as Texture
from ._tiles import TileCache as TileCache
from ._volume import Volume as Volume
from .color import Color as Color
from .renderer import Renderer as Renderer
from .scene import Scene as Scene

_Array = Union[np.ndarray, Sequence[Any]]

__version__: str

def version() -> tuple[int, int, int]: ...
'''
CLASSES = {"shd_color", "shd_context", "shd_environment", "shd_framebuffer", "shd_light", "shd_material", "shd_mesh",
           "shd_sampler", "shd_shadow", "shd_texture", "shd_tile_cache", "shd_volume"}


def camel(name):
    return "".join(part.capitalize() for part in name.removeprefix("shd_").split("_"))


class Stubs:
    def __init__(self, table):
        self.table = table
        self.enums = {e["name"]: e for e in table["enums"]}
        self.bits = {t["name"]: t["bits_of"] for t in table["typedefs"] if "bits_of" in t}
        self.structs = {s["name"] for s in table["structs"]}
        self.callbacks = {c["name"] for c in table["callbacks"]}

    def type_of(self, field):
        """The Python type that a field takes."""
        text = field["type"]
        base = re.sub(r"const|\*", "", text).split("(")[0].strip()
        if text == "const char *":
            return "str"
        if base in CLASSES:
            return f"Sequence[Union[{camel(base)}, None]]" if text.count("*") > 1 else camel(base)
        if "array" in field or ("*" in text and base not in self.structs) or re.match(r"shd_\w+_(in|out)$", base):
            return "_Array"
        if base in self.structs:
            single = f"Union[{camel(base)}, Mapping[str, Any]]"
            return f"Union[{camel(base)}, Sequence[{single}]]" if field.get("length") else single
        if base in self.callbacks:
            return "Callable[..., object]"
        if base in self.enums or base in self.bits:
            return "Union[int, str]"
        return "float" if base in ("float", "double") else "int"

    def enum_lines(self, entry):
        kind = "IntFlag" if entry["name"] in self.bits.values() else "IntEnum"
        prefix = "SHD_" + re.sub(r"_(flag|target)$", "", entry["name"].removeprefix("shd_")).upper() + "_"
        yield f"\nclass {camel(entry['name'])}(enum.{kind}):"
        for constant in entry["constants"]:
            name = constant["name"].removeprefix(prefix).removeprefix("SHD_")
            if not constant["name"].endswith("_MAX_ENUM"):
                yield f"    {name if name[0].isalpha() else f'N{name}'} = {constant['value']}"

    def struct_lines(self, entry):
        fields = [f for f in entry["fields"] if f["name"] != "struct_size"]
        yield f"\nclass {camel(entry['name'])}(Desc):"
        yield from (f"    {f['name']}: {self.type_of(f)}" for f in fields)
        yield "    def __init__(self, *,"
        yield from (f"                 {f['name']}: {self.type_of(f)} = ...," for f in fields)
        yield "                 ) -> None: ..."

    def text(self):
        lines = [HEAD.rstrip()]
        for entry in self.table["enums"]:
            lines += self.enum_lines(entry)
        for entry in self.table["structs"]:
            lines += self.struct_lines(entry)
        return "\n".join([*lines, ""])


if __name__ == "__main__":
    generated.save(OUTPUT, Stubs(generated.description()).text())
