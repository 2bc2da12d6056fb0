# SPDX-License-Identifier: MIT
"""Names, types and comments of C# for those of shd.json."""
import re

SCALARS = {"float": "float", "double": "double", "int32_t": "int", "uint32_t": "uint", "uint64_t": "ulong",
           "uint16_t": "ushort", "uint8_t": "byte", "size_t": "UIntPtr", "char": "byte", "void": "void"}
KEYWORDS = {"in", "out", "object", "base", "params", "ref", "lock", "event", "fixed"}
# Structs of a callback and its user_data, and columns: the handwritten layer has classes for them.
HANDWRITTEN = {"shd_f32_in", "shd_f32_out", "shd_u32_in", "shd_u32_out", "shd_u16_in", "shd_allocator", "shd_executor",
               "shd_log", "shd_display", "shd_tracer", "shd_present", "shd_progress", "shd_material_program",
               "shd_color_view", "shd_plane_view", "shd_present_tile", "shd_explanation", "shd_tile", "shd_tile_source"}
# Structs that callbacks get: their columns are spans.
VIEWS = ["shd_fragments", "shd_radiance", "shd_vertices", "shd_vertex_outputs", "shd_rays"]
COLUMNS = {"shd_f32_in": "float", "shd_f32_out": "float", "shd_u32_in": "uint", "shd_u32_out": "uint",
           "shd_u16_in": "ushort"}
# Structs for arrays inside structs that have a name of their own.
INLINE = {("float", 9): "Matrix3", ("float", 16): "Matrix4"}


def camel(name):
    """Words of a C name, each with a capital."""
    return "".join(part[0].upper() + part[1:].lower() for part in re.split(r"[_.]", name.removeprefix("shd_")) if part)


def lower(name):
    """A parameter's name."""
    text = camel(name)
    text = text[0].lower() + text[1:]
    return f"@{text}" if text in KEYWORDS else text


class Types:
    """The entries of shd.json by name, and their C# names."""

    def __init__(self, table):
        self.table = table
        self.structs = {s["name"]: s for s in table["structs"]}
        self.handles = {h["name"]: h for h in table["handles"]}
        self.callbacks = {c["name"]: c for c in table["callbacks"]}
        self.functions = {f["name"]: f for f in table["functions"]}
        self.flags = {t["bits_of"]: t["name"] for t in table["typedefs"] if "bits_of" in t}
        self.enums = {e["name"]: camel(self.flags.get(e["name"], e["name"])) for e in table["enums"]}
        self.enums.update({flags: camel(flags) for flags in self.flags.values()})
        self.inline = {}  # names of structs for arrays: element type, dimensions
        self.plain = {s for s in self.structs if self._is_plain(s)}
        self.words = self._words()

    def _is_plain(self, name):
        """A struct of numbers and enums alone: a value of C#."""
        for field in self.structs[name]["fields"]:
            text = field["type"]
            if "*" in text or text in self.callbacks or (text in self.structs and not self._is_plain(text)):
                return False
        return name not in HANDWRITTEN

    def twins(self):
        """Structs with pointers for which the generator writes a class with arrays and objects."""
        return [s for s in self.structs if s not in self.plain and s not in HANDWRITTEN and s not in VIEWS]

    def constant(self, entry, constant):
        """Name of an enum's constant."""
        noun = re.sub(r"_(flag|target)$", "", entry["name"]).upper()
        name = constant["name"].removeprefix(f"{noun}_").removeprefix("SHD_")
        if name[0].isdigit():  # SHD_TEXTURE_KIND_2D is TextureKind.Texture2D
            return camel(noun.removeprefix("SHD_").split("_")[0]) + name
        return camel(name)

    def _words(self):
        """C names that comments mention, with the C# names."""
        words = {}
        for entry in self.table["enums"]:
            enum = self.enums[entry["name"]]
            words.update({c["name"]: f"{enum}.{self.constant(entry, c)}" for c in entry["constants"]})
            words[entry["name"]] = enum
        for name in [*self.structs, *self.flags.values()]:
            words[name] = camel(name)
        words.update({c["name"]: f"Constants.{camel(c['name'].removeprefix('SHD_'))}" for c in self.table["constants"]})
        return words

    def comment(self, doc, indent=""):
        """An XML comment, with C# names for those of C."""
        if not doc:
            return []
        text = re.sub(r"\b(?:shd|SHD)_\w+(?!\w|\()", lambda m: self.words.get(m[0], m[0]), doc)
        text = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").strip()
        lines = text.split("\n")
        if len(lines) == 1:
            return [f"{indent}/// <summary>{lines[0]}</summary>"]
        return [f"{indent}/// <summary>", *(f"{indent}/// {line}".rstrip() for line in lines),
                f"{indent}/// </summary>"]

    def base(self, text):
        """A type without const and pointers."""
        return re.sub(r"\bconst\b|\*|\(\)\[4\]|\(\*\)\[4\]", "", text).replace("struct ", "").strip()

    def type_of(self, text):
        """The C# type of a field or parameter of the native layer."""
        base, stars = self.base(text), text.count("*")
        if "(*)" in text:
            stars = 2  # pointers to arrays of pointers
        if base in self.handles:
            return "IntPtr" + "*" * (stars - 1)
        if base in self.callbacks:
            return "IntPtr"
        if base in self.enums:
            return self.enums[base] + "*" * stars
        return SCALARS.get(base, camel(base)) + "*" * stars

    def array_type(self, field):
        """The struct for an array inside a struct."""
        element, dims = self.type_of(field["type"]), field["array"]
        total = 1
        for n in dims:
            total *= n
        name = INLINE.get((element, total))
        if not name:
            size = "x".join(map(str, dims))
            head = "Pointer" if "*" in element else ""
            noun = element.rstrip("*")
            name = {"uint": "UInt", "byte": "Bytes"}.get(noun, camel(noun) if noun.islower() else noun)
            name = f"{name}{head}{size}"
        self.inline.setdefault(name, (element, dims))
        return name

    def field_type(self, field):
        return self.array_type(field) if "array" in field else self.type_of(field["type"])
