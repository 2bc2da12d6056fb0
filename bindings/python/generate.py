#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes shd/*.pyi, the types for editors and type checkers, from shd.json and the templates in stubs/.

A template is a stub file. {sampler_desc} stands for the fields of a desc as keywords, {sampler_desc-filter} for them
without a field, {enum:filter} for a constant or its name, and {names} for all classes, descs and enums.
"""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parent))
sys.path.append(str(HERE / "shd"))  # the last one: its io.py is not that of Python
import generated
from _words import attribute, camel, members

TEMPLATES, OUTPUT = HERE / "stubs", HERE / "shd"
HEAD = "# SPDX-License-Identifier: MIT\n# Written by generate.py from stubs/{}.in; do not edit.\n"
CLASSES = {"shd_color", "shd_context", "shd_environment", "shd_framebuffer", "shd_light", "shd_material", "shd_mesh",
           "shd_sampler", "shd_shadow", "shd_texture", "shd_tile_cache", "shd_volume"}
NUMBERS = {"float": "float", "double": "float", "size_t": "int", "int": "int",
           **{f"{sign}int{bits}_t": "int" for sign in ("", "u") for bits in (8, 16, 32, 64)}}


# Structs that calls return as dicts.
DICTS = ("shd_bake_stats", "shd_bitmap_info", "shd_environment_info", "shd_framebuffer_info", "shd_mesh_info",
         "shd_render_stats", "shd_scene_info", "shd_shadow_info", "shd_table_info", "shd_texture_info",
         "shd_tile_cache_stats", "shd_tile_file_info")
SPECIAL = {"shd_log": "_Log", "shd_progress": "_Report", "shd_image": "_Image"}


class Stubs:
    def __init__(self, table):
        self.table = table
        self.enums = {e["name"]: e for e in table["enums"]}
        self.bits = {t["name"]: t["bits_of"] for t in table["typedefs"] if "bits_of" in t}
        self.structs = {s["name"]: s for s in table["structs"]}
        self.callbacks = {c["name"] for c in table["callbacks"]}

    def enum_type(self, name):
        """A constant, or one of the names of constants; flags may be joined by |."""
        name = self.bits.get(name, name)
        return f"Union[{camel(name)}, str, int]" if name in self.bits.values() else f"_{camel(name)}Name"

    def type_of(self, field):
        """The Python type that a field takes."""
        text = field["type"]
        base = re.sub(r"const|\*", "", text).split("(")[0].strip()
        several = text.count("*") > 1 or bool(field.get("length"))
        if base == "char":
            return "Sequence[_Path]" if several else "_Path"
        if base in CLASSES:
            return f"Sequence[Optional[{camel(base)}]]" if text.count("*") > 1 else f"Optional[{camel(base)}]"
        if base in self.structs and base not in ("shd_f32_in", "shd_f32_out", "shd_u32_in", "shd_u32_out", "shd_u16_in"):
            also = [SPECIAL[base]] if base in SPECIAL else []
            single = f"Union[{', '.join([camel(base), 'Mapping[str, Any]', *also])}]"
            return f"Union[{camel(base)}, Sequence[{single}]]" if several else single
        if base in self.enums or base in self.bits:
            single = self.enum_type(base)
            return f"Sequence[{single}]" if "array" in field or several else single
        if "array" in field or "*" in text or base not in NUMBERS:
            return "Callable[..., object]" if base in self.callbacks else "Optional[_Numbers]"
        return NUMBERS[base]

    def enum_lines(self, entry):
        kind = "IntFlag" if entry["name"] in self.bits.values() else "IntEnum"
        yield f"\nclass {camel(entry['name'])}(enum.{kind}):"
        yield from (f"    {attribute(short)} = {constant['value']}" for short, constant in members(entry).items())
        if kind == "IntEnum":
            names = ", ".join(f'"{short.lower()}"' for short in members(entry))
            yield f"\n{self.enum_type(entry['name'])} = Union[{camel(entry['name'])}, Literal[{names}]]"

    def fields(self, name, without=()):
        return [f for f in self.structs[name]["fields"] if f["name"] not in ("struct_size", *without)]

    def keywords(self, name, without=()):
        return ", ".join(f"{f['name']}: {self.type_of(f)} = ..." for f in self.fields(name, without))

    def struct_lines(self, entry):
        yield f"\nclass {camel(entry['name'])}(Desc):"
        yield from (f"    {f['name']}: {self.type_of(f)}" for f in self.fields(entry["name"]))
        yield f"    def __init__(self, *, {self.keywords(entry['name'])}) -> None: ..."

    def read_type(self, field):
        """The type of a field of a struct that a call returns."""
        kind = self.bits.get(field["type"], field["type"])
        kind = camel(kind) if kind in self.enums else NUMBERS.get(kind, "Any")
        return f"Tuple[{kind}, ...]" if "array" in field else kind

    def dict_lines(self, name):
        yield f"\nclass _{camel(name)}(TypedDict):"
        yield from (f"    {f['name']}: {self.read_type(f)}" for f in self.fields(name))

    def expand(self, text):
        """A template with its words in brackets."""
        def word(match):
            if match[1].startswith("enum:"):
                return self.enum_type("shd_" + match[1].removeprefix("enum:"))
            name, *without = match[1].split("-")
            if name == "names":
                aliases = {self.enum_type(name) for name in self.enums if name not in self.bits.values()}
                names = {camel(name) for name in (*CLASSES, *self.enums, *self.structs)} - {"Color"}
                return ", ".join(sorted({"Object", *names, *aliases} - set(without)))
            return self.keywords(f"shd_{name}", without)
        return re.sub(r"\{([\w:-]+)\}", word, text)

    def texts(self):
        made = {}
        for path in sorted(TEMPLATES.glob("*.pyi.in")):
            first, *lines = path.read_text(encoding="utf-8").rstrip().split("\n")
            made[path.stem] = HEAD.format(path.stem) + self.expand("\n".join(lines)) + "\n"
        lines = []
        for entry in self.table["enums"]:
            lines += self.enum_lines(entry)
        for entry in self.table["structs"]:
            lines += self.struct_lines(entry)
        for name in DICTS:
            lines += self.dict_lines(name)
        made["__init__.pyi"] += "\n".join([*lines, ""])
        return made


if __name__ == "__main__":
    generated.save_all(OUTPUT, Stubs(generated.description()).texts())
