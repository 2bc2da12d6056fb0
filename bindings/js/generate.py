#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the low-level layer of the JavaScript binding from shd.json.

    generate.py                  write lib/api.js, lib/api.d.ts and callbacks.c
    generate.py --asserts FILE   write C code that asserts each size and offset of lib/api.js, for a 32-bit compiler
    generate.py --functions PART print the functions of a part of the module, `core` or `models`

lib/api.js has the layout of the structs in WebAssembly, whose pointers and size_t have four bytes (layout.py),
lib/api.d.ts their types for TypeScript (types.py), and callbacks.c the functions of C that call JavaScript.
"""
import argparse
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(HERE.parent), str(HERE)]
import generated
import layout
import typescript

HEAD = "// SPDX-License-Identifier: MIT\n// {} Written by generate.py; do not edit.\n"


def table(api, name, rows):
    """A constant of JavaScript with one line for each row of a dictionary."""
    body = "".join(f"  {json.dumps(k)}: {json.dumps(v, separators=(',', ':'))},\n" for k, v in rows.items())
    return f"\nexport const {name} = {{\n{body}}};\n"


def javascript(api):
    text = HEAD.format("Layout of the C structs in WebAssembly, constants of the enums, and parameters of functions.")
    text += table(api, "structs", {layout.short(s["name"]): {
        "size": s["size"], "align": s["alignment"], "kind": s["kind"],
        "fields": {f["js"]: f["packed"] for f in s["fields"]}} for s in api.structs.values()})
    text += table(api, "enums", {layout.short(e["name"]): api.enum_values(e) for e in api.enums.values()})
    text += table(api, "callbacks", {layout.short(c["name"]): api.packed_callback(i, c)
                                     for i, c in enumerate(api.callbacks.values())})
    text += table(api, "functions", {f["name"]: api.packed_function(f) for f in api.functions.values()})
    return text


def c_callbacks(api):
    """Functions that JavaScript implements, and their addresses."""
    lines = [HEAD.format("Functions that C calls and JavaScript implements.").rstrip(), "// clang-format off",
             "#include <shd/extension.h>", "#include <shd/scene.h>", "#include <shd/shd.h>", ""]
    for entry in api.callbacks.values():
        name = layout.short(entry["name"]).replace(".", "_")
        parameters = ", ".join(api.c_parameter(p) for p in entry["parameters"])
        lines += [f'__attribute__((import_module("shd"), import_name("{name}")))',
                  f"extern {entry['result']} shd_js_{name}({parameters});"]
    lines += ["", "/* The address of a function by its index in lib/api.js. */",
              '__attribute__((export_name("shd_js_callback"))) void *shd_js_callback(uint32_t index)', "{",
              "    switch (index) {"]
    for index, entry in enumerate(api.callbacks.values()):
        lines.append(f"    case {index}: return (void *)shd_js_{layout.short(entry['name']).replace('.', '_')};")
    return "\n".join([*lines, "    default: return NULL;", "    }", "}", ""])


def asserts(api):
    lines = ["#include <stdalign.h>", "#include <stddef.h>", "#include <shd/scene.h>", "#include <shd/shd.h>", ""]
    for struct in api.structs.values():
        name = struct["name"]
        lines.append(f"_Static_assert(sizeof({name}) == {struct['size']}, \"{name}\");")
        lines.append(f"_Static_assert(alignof({name}) == {struct['alignment']}, \"{name}\");")
        for field in struct["fields"]:
            member = f"{name}, {field['name']}"
            lines.append(f"_Static_assert(offsetof({member}) == {field['offset']}, \"{member}\");")
            lines.append(f"_Static_assert(sizeof((({name} *)0)->{field['name']}) == {field['size']}, \"{member}\");")
    return "\n".join([*lines, ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--asserts", type=pathlib.Path)
    parser.add_argument("--functions", choices=layout.LIBRARIES)
    arguments = parser.parse_args()
    if arguments.functions:
        rows = generated.description()["functions"]
        print("\n".join(f["name"] for f in rows if layout.part_of(f) == arguments.functions))
        return
    api = layout.Api(generated.description())
    if arguments.asserts:
        arguments.asserts.write_text(asserts(api), encoding="utf-8")
        return
    generated.save_all(HERE, {"lib/api.js": javascript(api), "lib/api.d.ts": typescript.declarations(api),
                              "callbacks.c": c_callbacks(api)})


if __name__ == "__main__":
    main()
