#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes shd_api.hpp, the owners, structs and functions of shd.hpp, from shd.json.

    generate.py [--check]      write the file, or compare it with shd.json
"""
import pathlib
import re
import sys
import textwrap

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parent))
import generated

OUTPUT = HERE / "shd_api.hpp"
WIDTH = 120
HEAD = """// SPDX-License-Identifier: MIT
/// @file
/// Owners, structs and functions of shd.hpp. Written by generate.py; do not edit.
#ifndef SHD_API_HPP
#define SHD_API_HPP

{includes}

#include "shd.hpp"

// clang-format off
namespace shd {{
"""


def pointer(text):
    """A type of C, with the pointer marks as the C++ sources have them."""
    return re.sub(r" (\*+)$", r"\1", text)


def comment(text, function):
    """The first paragraph of a comment, with the function of C that has the rest."""
    first = " ".join(text.split("\n\n")[0].split())
    return "\n".join(textwrap.wrap(f"{first} See {function}().", WIDTH, initial_indent="/// ",
                                   subsequent_indent="/// "))


def declare(result, name, parameters, tail=""):
    """A declaration, on several lines if it is long."""
    begin = f"inline {result} {name}("
    line = begin + ", ".join(parameters) + f"){tail} {{"
    if len(line) + len("[[nodiscard]] ") <= WIDTH:
        return line
    return begin + "\n    " + ",\n    ".join(parameters) + f"){tail} {{"


class Generator:
    def __init__(self, table):
        self.table = table
        functions = {f["name"]: f for f in table["functions"]}
        self.functions = functions
        self.structs = {s["name"] for s in table["structs"]}
        self.owners = [h for h in table["handles"] if len(functions[h["release"]]["parameters"]) == 1]
        self.optional = {h["name"] for h in table["headers"] if h["library"] != "shd"}
        self.owned = {h["name"]: h["name"].removeprefix("shd_") for h in self.owners}

    def owner(self, handle):
        name = handle["name"]
        return (f"/// {' '.join(handle['doc'].split())}\n"
                f"using {self.owned[name]} = owner<{name}, {handle['retain']}, {handle['release']}>;")

    def defaulted(self, struct):
        """A struct that starts with its defaults; None for structs without."""
        name = struct["name"]
        if f"{name}_default" not in self.functions:
            return None
        own = name.removeprefix("shd_")
        return "\n".join([f"struct {own} : {name} {{", f"  {own}() noexcept : {name}({name}_default()) {{}}",
                          f"  {own}(const {name}& values) noexcept : {name}(values) {{}}", "};"])

    def group(self, entries, make):
        """The text of each entry. Entries of a component exist only where its header is installed."""
        current = None
        for entry in entries:
            text = make(entry)
            if text is None:
                continue
            header = entry["header"] if entry["header"] in self.optional else None
            if header != current:
                yield from ["#endif"] * bool(current)
                yield from [f"#if __has_include(<shd/{header}.h>)"] * bool(header)
                current = header
            yield text
        yield from ["#endif"] * bool(current)

    def output(self, function):
        """The parameter that the C++ function returns, and its owner if it has one: an object, or a last struct."""
        parameters = function.get("parameters", [{"name": "", "type": ""}])
        last = next((p for p in parameters if p["name"].startswith("out_") and p["type"].endswith("**") and
                     p["type"].rstrip("* ") in self.owned), parameters[-1])
        target = last["type"].rstrip("* ")
        if not last["name"].startswith("out_"):
            return None, None
        if last["type"].endswith("**") and target in self.owned:
            return last, self.owned[target]
        return (last, None) if target in self.structs else (None, None)

    def initial(self, target):
        default = self.functions.get(f"{target}_default")
        return f"{target}_default()" if default and not default.get("parameters") else "{}"

    def arguments(self, parameters):
        """Declarations and names of parameters. A name that the namespace has gets an underscore."""
        taken = {*self.owned.values(), "in", "out"}
        names = [p["name"] + "_" * (p["name"] in taken) for p in parameters]
        return [f"{pointer(p['type'])} {n}" for p, n in zip(parameters, names)], names

    def is_wrapped(self, function):
        """Functions that can fail, except those for extensions, which have handles of their own types."""
        return function.get("nodiscard") and function["result"] == "shd_result" and function["header"] != "extension"

    def creator(self, function):
        """The form of a function that makes an object which does not throw; None for other functions."""
        last, made = self.output(function)
        if not made:
            return None
        declared, names = self.arguments(function["parameters"])
        at = function["parameters"].index(last)
        declared[at], names[at] = f"shd::{made}& {last['name']}", "&handle"
        handle = last["type"].removesuffix("**").strip()
        head = "[[nodiscard]] " + declare("shd_result", function["name"].removeprefix("shd_"),
                                             declared, " noexcept")
        return "\n".join([comment(function["doc"], function["name"]), head, f"  {handle}* handle = nullptr;",
                          f"  const shd_result result = {function['name']}({', '.join(names)});",
                          f"  {last['name']}.reset(handle);", "  return result;", "}", ""])

    def thrower(self, function):
        """The form of a function that throws."""
        name = function["name"].removeprefix("shd_")
        last, made = self.output(function)
        declared, names = self.arguments(function.get("parameters", []))
        if last:
            at = function["parameters"].index(last)
            declared.pop(at)
            names[at] = "made" if made else "&made"
        lines = [comment(function["doc"], function["name"])]
        if made:
            lines += [declare(f"shd::{made}", name, declared), f"  shd::{made} made;",
                      f"  check({name}({', '.join(names)}));", "  return made;"]
        elif last:
            target = last["type"].rstrip("* ")
            lines += [declare(target, name, declared), f"  {target} made = {self.initial(target)};",
                      f"  check({function['name']}({', '.join(names)}));", "  return made;"]
        else:
            lines += [declare("void", name, declared), f"  check({function['name']}({', '.join(names)}));"]
        return "\n".join([*lines, "}", ""])

    def text(self):
        headers = [{"header": h["name"]} for h in self.table["headers"] if h["name"] != "shd"]
        includes = "\n".join(self.group(headers, lambda h: f"#include <shd/{h['header']}.h>"))
        lines = [HEAD.format(includes=includes), *self.group(self.owners, self.owner), "",
                 "// Structs of C that start with their defaults.",
                 *self.group(self.table["structs"], self.defaulted), ""]
        functions = [f for f in self.table["functions"] if self.is_wrapped(f)]
        lines += self.group(functions, self.creator)
        lines += ["", "#ifdef __cpp_exceptions", *self.group(functions, self.thrower), "#endif", ""]
        return "\n".join([*lines, "}  // namespace shd", "// clang-format on", "#endif  // SHD_API_HPP", ""])


if __name__ == "__main__":
    sys.exit(generated.keep(OUTPUT, Generator(generated.description()).text(), "--check" in sys.argv[1:]))
