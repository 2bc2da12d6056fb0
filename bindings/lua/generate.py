#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes shd/cdef.lua, the declarations for LuaJIT's ffi, and shd/tables.lua, from shd.json."""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parent))
import generated

HEAD = "-- SPDX-License-Identifier: MIT\n-- {}. Written by generate.py; do not edit.\n"
NUMBERS = {"float", "double", "size_t", "int", "int32_t", "uint8_t", "uint16_t", "uint32_t", "uint64_t"}


def base_of(text):
    return re.sub(r"\bconst\b|\*", "", text).split("(")[0].strip()


def declare(text, name, array=()):
    """The declaration of a field or parameter in C."""
    if "(*)" in text:
        return text.replace("(*)", f"(*{name})")
    return f"{text}{'' if text.endswith('*') else ' '}{name}" + "".join(f"[{n}]" for n in array)


class Api:
    """Classes of fields and parameters: how a value of Lua becomes a value of C."""

    def __init__(self, table):
        self.table = table
        self.structs = {s["name"]: s for s in table["structs"]}
        self.enums = {e["name"] for e in table["enums"]}
        self.handles = {h["name"] for h in table["handles"]}
        self.callbacks = {c["name"]: c for c in table["callbacks"]}
        self.aliases = {t["name"]: t for t in table["typedefs"]}

    def callback_type(self, name):
        """shd_present.tile has no name in C."""
        return name.replace(".", "_") + "_fn" if "." in name else name

    def ctype(self, text):
        return self.callback_type(text) if text in self.callbacks else text

    def kind(self, field):
        """(class, base) of a field or parameter."""
        text = field["type"]
        base, stars = base_of(text), text.count("*")
        if text in self.callbacks:
            return "callback", text
        if base == "char":
            return {0: "chars", 1: "string", 2: "strings"}[stars], base
        if stars == 0:
            return self.value_kind(field, base)
        if "(*)" in text or (stars > 1 and base in NUMBERS):
            return "opaque", base
        if base in self.handles:
            out = text.endswith("**") and "const" not in text
            return ("out_handle" if out else "handle" if stars == 1 else "handles"), base
        if re.fullmatch(r"shd_\w\d\d_(in|out)", base):
            return "columns", base
        return ("structs" if base in self.structs else "enumlist" if base in self.enums else "data"), base

    def value_kind(self, field, base):
        array = "array" in field
        if re.fullmatch(r"shd_\w\d\d_(in|out)", base):
            return "column", base
        if base in self.structs:
            return "struct", base
        if base in self.enums or base in self.aliases:
            return ("enums" if array else "enum"), self.aliases.get(base, {}).get("bits_of", base)
        return ("numbers" if array else "number"), base

    def order(self):
        """Structs, each behind those that it contains."""
        done = {}

        def visit(struct):
            for field in struct["fields"]:
                if field["type"] in self.structs:
                    visit(self.structs[field["type"]])
            done.setdefault(struct["name"], struct)

        for struct in self.table["structs"]:
            visit(struct)
        return done.values()


class Declarations:
    """The text for ffi.cdef."""

    def __init__(self, api):
        self.api = api

    def parameters(self, entry):
        return ", ".join(declare(self.api.ctype(p["type"]), p["name"]) for p in entry["parameters"]) or "void"

    def lines(self):
        api = self.api
        yield from (f"typedef struct {h} {h};" for h in sorted(api.handles))
        for entry in api.table["enums"]:
            members = [f"  {c['name']} = {c['value']}" for c in entry["constants"]]
            yield f"typedef enum {entry['name']} {{"
            yield ",\n".join(members)
            yield f"}} {entry['name']};"
        yield from (f"typedef {t['type']} {t['name']};" for t in api.table["typedefs"])
        yield from (f"typedef struct {s} {s};" for s in api.structs)
        for entry in api.table["callbacks"]:
            yield declare(f"typedef {entry['result']}", f"(*{api.callback_type(entry['name'])})") + \
                f"({self.parameters(entry)});"
        for entry in api.order():
            yield f"struct {entry['name']} {{"
            for field in entry["fields"]:
                yield f"  {declare(api.ctype(field['type']), field['name'], field.get('array', ()))};"
            yield "};"
        for entry in api.table["functions"]:
            if "library" in entry:
                yield declare(entry["result"], entry["name"]) + f"({self.parameters(entry)});"

    def text(self):
        head = HEAD.format("Declarations of libshd and its components")
        return head + "\n".join(["return [[", *self.lines(), "]]", ""])


def quoted(value):
    return f'"{value}"'


class Tables:
    """The parts of shd.json that the modules use at run time."""

    def __init__(self, api):
        self.api = api

    def entry(self, field):
        kind, base = self.api.kind(field)
        parts = [quoted(field["name"]), quoted(kind), quoted(base)]
        for key in ("array", "length"):
            if field.get(key):
                values = ", ".join(quoted(v) if isinstance(v, str) else str(v) for v in field[key])
                parts.append(f"{key} = {{{values}}}")
        if field["type"].startswith("const"):
            parts.append("const = true")
        if kind == "handle" and field.get("nullable"):
            parts.append("nullable = true")
        return f"{{{', '.join(parts)}}}"

    def with_length(self, field, names):
        """The length of `draws` is `draw_count` if its comment does not say it."""
        counter = f"{field['name'].removesuffix('s')}_count"
        if "*" in field["type"] and "length" not in field and counter in names:
            return {**field, "length": [counter]}
        return field

    def names(self, entry):
        """Short names of an enum: SHD_FILTER_EWA is ewa."""
        prefix = "SHD_" + re.sub(r"_(flag|target)$", "", entry["name"].removeprefix("shd_")).upper() + "_"
        for constant in entry["constants"]:
            if not constant["name"].endswith("_MAX_ENUM"):
                yield constant["name"].removeprefix(prefix).removeprefix("SHD_").lower(), constant["value"]

    def enum_lines(self):
        flags = {t["bits_of"] for t in self.api.table["typedefs"] if "bits_of" in t}
        for entry in self.api.table["enums"]:
            members = ", ".join(f"{{{quoted(n)}, {v}}}" for n, v in self.names(entry))
            yield f"  {entry['name']} = {{flags = {str(entry['name'] in flags).lower()},\n    {members}}},"

    def struct_lines(self):
        kinds = {c["name"]: c["value"] for e in self.api.table["enums"] if e["name"] == "shd_desc_kind"
                 for c in e["constants"]}
        for entry in self.api.table["structs"]:
            yield f"  {entry['name']} = {{size = {entry['size']}, desc_kind = {kinds.get(entry.get('desc_kind'), 0)},"
            names = {f["name"] for f in entry["fields"]}
            yield from (f"    {self.entry(self.with_length(f, names))}," for f in entry["fields"]
                        if f["name"] != "struct_size")
            yield "  },"

    def function_lines(self):
        for entry in self.api.table["functions"]:
            if "library" in entry:
                parameters = "".join(f"\n    {self.entry(p)}," for p in entry["parameters"])
                kind, base = self.api.kind({"type": entry["result"], "name": ""})
                yield (f"  {entry['name']} = {{library = {quoted(entry['library'])}, "
                       f"result = {{{quoted(kind)}, {quoted(base)}}},{parameters}\n  }},")

    def text(self):
        api = self.api
        lines = ["local tables = {}", "tables.constants = {"]
        lines += [f"  {c['name'].removeprefix('SHD_')} = {c['value']}," for c in api.table["constants"]]
        lines += ["}", "tables.enums = {", *self.enum_lines(), "}", "tables.structs = {", *self.struct_lines(), "}"]
        lines += ["tables.handles = {"]
        lines += [f"  {h['name']} = {{retain = {quoted(h['retain'])}, release = {quoted(h['release'])}}},"
                  for h in api.table["handles"] if "release" in h and h["name"] != "shd_object"]
        lines += ["}", "tables.callbacks = {"]
        lines += [f"  [{quoted(c['name'])}] = {{type = {quoted(api.callback_type(c['name']))}, "
                  f"result = {quoted(c['result'])}, parameters = {len(c['parameters'])}}},"
                  for c in api.table["callbacks"]]
        lines += ["}", "tables.functions = {", *self.function_lines(), "}", "return tables", ""]
        return HEAD.format("Enums, structs and functions of the API") + "\n".join(lines)


if __name__ == "__main__":
    described = Api(generated.description())
    generated.save_all(HERE / "shd", {"cdef.lua": Declarations(described).text(), "tables.lua": Tables(described).text()})
