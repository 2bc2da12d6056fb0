#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes shd.json, the description of the C API from which the bindings are generated.

    describe.py [--check]                  write bindings/shd.json, or compare it with the headers
    describe.py --asserts FILE             write C code that asserts each size and offset of shd.json

Types come from clang's syntax tree, texts from the headers, and libraries from tests/abi/symbols_<library>.txt. Sizes
and offsets are those of 64-bit machines. docs/bindings.md describes the keys. Without clang, --check is skipped.
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
sys.path.append(str(ROOT / "tests/abi"))
import components
import generated
import words

SKIPPED = 77
OUTPUT = HERE / "shd.json"
HEADERS_OF_C = {"worker"}  # for libraries in C that run code in the worker
SIZES = {"float": 4, "double": 8, "size_t": 8, "int32_t": 4, "uint8_t": 1, "uint16_t": 2, "uint32_t": 4, "uint64_t": 8,
         "int": 4, "char": 1, "int64_t": 8}
ARRAY = re.compile(r"(.*?)((?:\[\d+\])+)$")
CALLBACK = re.compile(r"(.*?)\s*\(\*(?:const)?\)\((.*)\)$")
CONSTANT = re.compile(r"((?:/\*\*(?:(?!\*/).)*\*/\n)?)#define (SHD_\w+) (\d+|0x[0-9a-fA-F]+)u?$", re.M | re.S)


def syntax_tree(clang, include, headers):
    """Declarations of the headers in order, each with the header and the offset of its name."""
    with tempfile.TemporaryDirectory() as folder:
        unit = pathlib.Path(folder) / "unit.c"
        unit.write_text("".join(f"#include <shd/{h}.h>\n" for h in headers), encoding="utf-8")
        run = subprocess.run([clang, "-std=c99", "-w", "-fsyntax-only", "-Xclang", "-ast-dump=json", "-I", include,
                              unit], check=True, stdout=subprocess.PIPE, text=True)
    place = {"file": ""}
    for node in json.loads(run.stdout)["inner"]:
        locate(node, place)
        path = pathlib.Path(node["file"])
        if path.parent.name == "shd" and path.stem in headers:
            yield path.stem, node


def locate(node, place):
    """Gives a node and its members the file and offset of their names. Clang names a file only where it changes."""
    for key, value in list(node.items()):
        if key in ("loc", "range"):
            for point in [value] if key == "loc" else [value.get("begin", {}), value.get("end", {})]:
                for spot in (point.get("spellingLoc"), point.get("expansionLoc"), point):
                    if spot and "file" in spot:
                        place["file"] = spot["file"]
            if key == "loc":
                node["file"] = place["file"]
                node["offset"] = value.get("expansionLoc", value).get("offset", 0)
        elif key == "inner":
            for member in value:
                locate(member, place)


def spelling(node):
    return re.sub(r"\b(?:struct|enum) (?=shd_)", "", node["type"]["qualType"])


def split_type(text):
    """The type of an element, and the lengths of an array."""
    match = ARRAY.match(text)
    if not match or "(*" in text:
        return {"type": text}
    return {"type": match.group(1).strip(), "array": [int(n) for n in re.findall(r"\d+", match.group(2))]}


def callback(name, node, text, doc):
    """A function-pointer type; the names of its parameters are only in the text."""
    result, parameters = CALLBACK.match(spelling(node)).groups()
    declared = re.match(r"[^;]*?\(\s*\*?(?:const )?\w+\)\s*\(([^;]*?)\)\s*[;,)]", text, re.S)
    if declared is None:
        declared = re.match(r"\w+\)\s*\(([^;]*?)\)\s*[;,)]", text, re.S)
    names = [re.search(r"(\w+)(?:\[\d*\])*\s*$", p).group(1) for p in declared.group(1).split(",")]
    types = [t.strip() for t in parameters.split(",")]
    return {"name": name, "result": result, "doc": doc,
            "parameters": [{"name": n, "type": t} for n, t in zip(names, types)]}


class Description:
    """Collects what the declarations of the headers say."""

    def __init__(self, include, headers, libraries):
        self.texts = {h: (include / "shd" / f"{h}.h").read_text(encoding="utf-8") for h in headers}
        self.libraries = libraries
        self.structs, self.enums, self.typedefs, self.functions = {}, {}, {}, {}
        self.callbacks, self.handles = {}, {}

    def doc(self, header, node, end=";"):
        return words.comment_of(self.texts[header], node["offset"], end)

    def add(self, header, node):
        kind, name = node["kind"], node.get("name", "")
        if kind == "RecordDecl" and node.get("completeDefinition"):
            self.add_struct(header, node)
        elif kind == "EnumDecl":
            self.add_enum(header, node)
        elif kind == "TypedefDecl" and name not in self.structs and name not in self.enums:
            self.add_typedef(header, node)
        elif kind == "FunctionDecl":
            self.add_function(header, node)

    def add_struct(self, header, node):
        name, fields = node["name"], []
        doc = words.comment_of(self.texts[header], node["offset"], None)
        for member in node["inner"]:
            if member["kind"] != "FieldDecl":
                continue
            text = self.doc(header, member)
            field = {"name": member["name"], **split_type(spelling(member)), "doc": text}
            if CALLBACK.match(field["type"]):
                field["type"] = f"{name}.{field['name']}"
                body = self.texts[header][member["offset"]:]
                self.callbacks[field["type"]] = {**callback(field["type"], member, body, text), "header": header}
            fields.append(field)
        words.mark_fields(fields, doc)
        self.structs[name] = {"name": name, "header": header, "doc": doc, "fields": fields}

    def add_enum(self, header, node):
        constants, value = [], -1
        for member in node["inner"]:
            if member["kind"] != "EnumConstantDecl":
                continue
            explicit = [i for i in member.get("inner", []) if "value" in i]
            value = int(explicit[0]["value"]) if explicit else value + 1
            constants.append({"name": member["name"], "value": value, "doc": self.doc(header, member, ",\n")})
        name = node["name"]
        doc = words.comment_of(self.texts[header], node["offset"], None)
        self.enums[name] = {"name": name, "header": header, "doc": doc, "constants": constants}

    def add_typedef(self, header, node):
        name, text, doc = node["name"], spelling(node), self.doc(header, node)
        if text == name:
            self.handles.setdefault(name, {"name": name, "header": header, "doc": doc})
        elif CALLBACK.match(text):
            body = self.texts[header][node["offset"]:]
            self.callbacks[name] = {**callback(name, node, body, doc), "header": header}
        else:
            bits = re.match(r"(\w+) bits", doc)
            entry = {"name": name, "header": header, "type": text, "doc": doc}
            self.typedefs[name] = {**entry, "bits_of": bits.group(1)} if bits else entry

    def add_function(self, header, node):
        name = node["name"]
        members = node.get("inner", [])
        tags = words.split_tags(self.doc(header, node))
        parameters = []
        for member in members:
            if member["kind"] == "ParmVarDecl":
                parameter = {"name": member["name"], "type": spelling(member),
                             "doc": tags["parameters"].get(member["name"], "")}
                if "(*" in parameter["type"]:
                    parameter["type"] = f"{name}.{member['name']}"
                    body = self.texts[header][member["offset"]:]
                    found = callback(parameter["type"], member, body, parameter["doc"])
                    self.callbacks[parameter["type"]] = {**found, "header": header}
                words.mark_parameter(parameter, tags["doc"])
                parameters.append(parameter)
        entry = {"name": name, "header": header}
        if node.get("inline"):
            entry["inline"] = True
        else:
            entry["library"] = self.libraries[name]
        entry["result"] = re.match(r"(.*?)\s*\(", spelling(node)).group(1)
        if any(m["kind"] == "WarnUnusedResultAttr" for m in members):
            entry["nodiscard"] = True
        self.functions[name] = {**entry, **{k: tags[k] for k in ("since", "doc", "returns") if tags[k]},
                                "parameters": parameters}

    def size_and_alignment(self, text):
        """Of a type on 64-bit machines."""
        text = text.removeprefix("const ")
        if "*" in text or text in self.callbacks:
            return 8, 8
        if text in self.typedefs:
            return self.size_and_alignment(self.typedefs[text]["type"])
        if text in self.structs:
            struct = self.structs[text]
            return struct["size"], struct["alignment"]
        size = 4 if text in self.enums else SIZES[text]
        return size, size

    def lay_out(self):
        for struct in self.structs.values():
            end = alignment = 0
            for field in struct["fields"]:
                size, align = self.size_and_alignment(field["type"])
                for length in field.get("array", []):
                    size *= length
                field["offset"] = (end + align - 1) // align * align
                field["size"] = size
                end, alignment = field["offset"] + size, max(align, alignment)
            struct["size"] = (end + alignment - 1) // alignment * alignment
            struct["alignment"] = alignment

    def finish(self):
        self.lay_out()
        kinds = {c["name"]: c["value"] for c in self.enums["shd_desc_kind"]["constants"]}
        for name, struct in self.structs.items():
            kind = "SHD_DESC_KIND_" + name.removeprefix("shd_").upper()
            if kind in kinds:
                struct["desc_kind"] = kind
        for name, handle in self.handles.items():
            for verb in ("retain", "release"):
                if f"{name}_{verb}" in self.functions:
                    handle[verb] = f"{name}_{verb}"
        for entry in self.callbacks.values():
            words.mark_callback(entry, self.structs, self.functions, self.texts[entry["header"]])


def constants(texts):
    rows = []
    for header, text in texts.items():
        for comment, name, value in CONSTANT.findall(text):
            doc = words.plain(comment.rsplit("/**", 1)[1]) if "/**" in comment else ""
            rows.append({"name": name, "header": header, "value": int(value, 0), "doc": doc})
    return rows


def libraries():
    found = {}
    for path in sorted((ROOT / "tests/abi").glob("symbols_*.txt")):
        found.update(dict.fromkeys(path.read_text(encoding="utf-8").split(), path.stem.removeprefix("symbols_")))
    return found


def describe(clang):
    include = ROOT / "include"
    headers = sorted(p.stem for p in (include / "shd").glob("*.h") if p.stem not in HEADERS_OF_C)
    description = Description(include, headers, libraries())
    for header, node in syntax_tree(clang, include, headers):
        description.add(header, node)
    for name in [*description.structs, *description.enums]:  # a declaration may come before the definition
        description.handles.pop(name, None)
    description.finish()
    by_place = {h: i for i, h in enumerate(headers)}
    owner = {h: library for library in components.LIBRARIES for h in components.headers_of(include, library)}
    table = {"headers": [{"name": h, "library": owner[h], "doc": words.file_doc(t)}
                         for h, t in description.texts.items()],
             "constants": constants(description.texts)}
    for key in ("enums", "typedefs", "handles", "callbacks", "structs", "functions"):
        table[key] = sorted(getattr(description, key).values(), key=lambda e: by_place[e["header"]])
    return table


def line(value):
    return json.dumps(value, ensure_ascii=False)


def write(table):
    """JSON with a line for each entry, and for each of its fields, constants and parameters."""
    sections = []
    for key, entries in table.items():
        rows = []
        for entry in entries:
            nested = next((k for k in ("fields", "constants", "parameters") if entry.get(k)), None)
            flat = line({k: v for k, v in entry.items() if k != nested and v != ""})
            if nested:
                members = ",\n".join("   " + line({k: v for k, v in m.items() if v != ""}) for m in entry[nested])
                flat = f"{flat[:-1]}, \"{nested}\": [\n{members}]}}"
            rows.append("  " + flat)
        sections.append(f" \"{key}\": [\n" + ",\n".join(rows) + "]")
    return "{\n" + ",\n".join(sections) + "\n}\n"


def asserts(table):
    """C11 code that compiles only if sizes, offsets and values are those of the compiler."""
    lines = ["/* Written by describe.py. */", "#include <stddef.h>"]
    lines += [f"#include <shd/{h['name']}.h>" for h in table["headers"]]
    for struct in table["structs"]:
        name = struct["name"]
        lines.append(f"_Static_assert(sizeof({name}) == {struct['size']}, \"{name}\");")
        lines.append(f"_Static_assert(_Alignof({name}) == {struct['alignment']}, \"{name}\");")
        for field in struct["fields"]:
            member = f"{name}, {field['name']}"
            lines.append(f"_Static_assert(offsetof({member}) == {field['offset']}, \"{member}\");")
            lines.append(f"_Static_assert(sizeof((({name} *)0)->{field['name']}) == {field['size']}, \"{member}\");")
    for enum in table["enums"]:
        lines += [f"_Static_assert({c['name']} == {c['value']}, \"{c['name']}\");" for c in enum["constants"]]
    lines += [f"_Static_assert({c['name']} == {c['value']}, \"{c['name']}\");" for c in table["constants"]]
    return "\n".join([*lines, ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--asserts", type=pathlib.Path)
    parser.add_argument("--clang", default="clang")
    arguments = parser.parse_args()
    if arguments.asserts:
        arguments.asserts.write_text(asserts(generated.description()), encoding="utf-8")
        return 0
    if not shutil.which(arguments.clang):
        print(f"skipped: {arguments.clang} is not installed (Debian: clang)")
        return SKIPPED if arguments.check else 1
    return generated.keep(OUTPUT, write(describe(arguments.clang)), arguments.check)


if __name__ == "__main__":
    sys.exit(main())
