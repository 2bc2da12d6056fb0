# SPDX-License-Identifier: MIT
"""TypeScript declarations of descs, enums and functions, with the comments of the headers."""
import re
import textwrap

import layout

HEAD = """// SPDX-License-Identifier: MIT
// Types of descs, enums and functions. Written by generate.py; do not edit.
import type { Environment, Framebuffer, Light, Material, Mesh, Sampler, Shadow, Texture, Volume, Context, Column,
              OutColumn, Columns, OutColumns, Numbers, Pixels, Fragments, Radiance, Vertices, VertexOutputs, Rays,
              PresentTile, Tile, TileCache, Find, Flags } from "./index.js";
"""
# Structs that the library writes: every field is there.
WRITTEN = re.compile(r"_(info|stats)$|^shd_(view|plane_view|tap|blend_step|scene_instance)$")
SKIPPED = re.compile(r"^shd_([fu]\d+_(in|out)|fragments|radiance|vertices|vertex_outputs|rays|present_tile|tile)$")
# Required in C, but not always.
OPTIONAL = {("shd_texture_desc", "texels")}  # textures in tiles have none
FUNCTIONS = {"fragment_fn": "(fragments: Fragments, out: Radiance) => void",
             "vertex_fn": "(vertices: Vertices, out: VertexOutputs) => void",
             "slot_fn": "(fragments: Fragments, out: (Float32Array | null)[]) => void",
             "trace_fn": "(rays: Rays, blocked: Uint32Array) => void",
             "scene_desc.find": "Find",
             "load_tiles_fn": "(tiles: Tile[]) => void",
             "tile_source.release": "() => void",
             "log.write": "(level: LogLevel, message: string) => void",
             "progress.report": "(fraction: number) => boolean | void",
             "present.tile": "(tile: PresentTile) => void"}


def pascal(name):
    return "".join(part.capitalize() for part in layout.short(name).split("_"))


def comment(text, indent=""):
    if not text:
        return []
    text = text.replace("*/", "* /")
    lines = [l for part in text.split("\n") for l in (textwrap.wrap(part, 112 - len(indent)) or [""])]
    if len(lines) == 1:
        return [f"{indent}/** {lines[0]} */"]
    return [f"{indent}/**", *(f"{indent} * {l}".rstrip() for l in lines), f"{indent} */"]


class Types:
    def __init__(self, api):
        self.api = api

    def field(self, field):
        """The TypeScript type of a field of a desc."""
        kind, _, rest = self.api.packed(field["type"]).partition(":")
        is_array = "array" in field
        if kind == "column":
            way = "Out" if rest.endswith("out") else ""
            return f"{way}Columns" if is_array else f"{way}Column"
        if kind in ("enum", "flags"):
            name = pascal(self.enum_name(rest))
            name = name if kind == "enum" else f"Flags<{name}>"
            return f"({name} | number)[]" if is_array else f"{name} | number"
        if kind == "struct":
            # a function is enough for a struct with one function
            alone = {"log": "log.write", "progress": "progress.report", "present": "present.tile", "tracer": "trace_fn"}
            return f"{pascal(rest)} | ({FUNCTIONS[alone[rest]]})" if rest in alone else pascal(rest)
        if kind == "list":
            # an image may be Pixels; several descs are an array
            one = f"Partial<{pascal(rest)}>" if rest.endswith("_info") else pascal(rest)
            if re.match(r"[fu]\d+_(in|out)$", rest):
                return "OutColumn[]" if rest.endswith("out") else "Column[]"
            return f"{one} | {one}[]" if field.get("rows") or field["name"].endswith("s") else one
        if kind == "handle":
            return f"{pascal(rest)} | null"
        if kind == "handles":
            return f"({pascal(rest)} | null)[]"
        if kind == "function":
            return FUNCTIONS.get(rest, "number")
        if kind == "data":
            return "Pixels" if rest == "u8" else "Numbers"
        if kind == "numbers":
            return f"({pascal(rest)} | number)[]"
        if kind in ("text",):
            return "string"
        return "Numbers" if is_array else "number"

    def enum_name(self, rest):
        return next(n for n in self.api.enums if layout.short(n) == rest)

    def struct_lines(self, struct):
        written = bool(WRITTEN.search(struct["name"]))
        yield from [""] + comment(struct.get("doc", ""))
        yield f"export interface {pascal(struct['name'])} {{"
        for field in struct["fields"]:
            if field["name"] in ("struct_size", "user_data"):
                continue
            yield from comment(field.get("doc", ""), "  ")
            is_number = field["type"] in ("uint32_t", "size_t")
            is_required = field.get("required") and not is_number and (struct["name"], field["name"]) not in OPTIONAL
            optional = "" if written or is_required else "?"
            yield f"  {field['js']}{optional}: {self.field(field)};"
        yield "}"

    def enum_lines(self, entry):
        names = [n for n in self.api.enum_values(entry)]
        docs = {self.api.member(entry, c): c.get("doc", "") for c in entry["constants"]}
        text = entry.get("doc", "") + "".join(f"\n- `{n}`: {docs[n]}" for n in names if docs.get(n))
        yield from [""] + comment(text.strip())
        yield f"export type {pascal(entry['name'])} ="
        yield from (f"  | \"{n}\"" for n in names)
        yield "  ;"

    def function_lines(self, entry):
        parts = [entry.get("doc", "")]
        parts += [f"@param {layout.camel(p['name'])} {p['doc']}" for p in entry["parameters"] if p.get("doc")]
        parts += [f"@returns {entry['returns']}"] if entry.get("returns") else []
        yield from comment("\n".join(filter(None, parts)), "  ")
        arguments = ", ".join(f"{self.parameter(p['name'])}: number" for p in entry["parameters"])
        yield f"  {entry['name']}({arguments}): {'void' if entry['result'] == 'void' else 'number'};"

    def parameter(self, name):
        return layout.camel(name)


def declarations(api):
    types, lines = Types(api), [HEAD.rstrip()]
    for entry in api.enums.values():
        lines += types.enum_lines(entry)
    for struct in api.structs.values():
        if not SKIPPED.match(struct["name"]):
            lines += types.struct_lines(struct)
    lines += ["", "/** The functions of C. Pointers are addresses in the memory of WebAssembly. */",
              "export interface Raw {",
              "  malloc(size: number): number;", "  free(address: number): void;"]
    for entry in api.functions.values():
        lines += types.function_lines(entry)
    return "\n".join([*lines, "}", ""])
