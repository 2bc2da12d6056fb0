#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes src/Generated, the native layer and the descs of the C# binding, and tests/layout.txt, from shd.json."""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(HERE), str(HERE.parent)]
import generated
from cs_managed import Managed
from cs_native import Native
from cs_types import Types

HEAD = "// SPDX-License-Identifier: MIT\n// Written by generate.py; do not edit."
USING = ["using System;", "using System.Collections.Generic;", "using System.Runtime.InteropServices;", ""]


def source(namespace, lines):
    body = list(lines)
    while body and not body[-1]:
        body.pop()
    return "\n".join([HEAD, *USING, f"namespace {namespace}", "{", *body, "}", ""])


def config(table):
    """Names of the libraries for Mono, which knows no versions."""
    version = {c["name"]: c["value"] for c in table["constants"]}
    major, minor = version["SHD_VERSION_MAJOR"], version["SHD_VERSION_MINOR"]
    suffix = f"{major}.{minor}" if major == 0 else str(major)
    libraries = sorted({f["library"] for f in table["functions"] if f.get("library")})
    rows = [f'  <dllmap dll="{name}" target="lib{name}.so.{suffix}" os="linux"/>' for name in libraries]
    return "\n".join(["<!-- SPDX-License-Identifier: MIT -->", "<!-- Written by generate.py; do not edit. -->",
                      "<configuration>", *rows, "</configuration>", ""])


def files():
    """Name and text of each generated file."""
    table = generated.description()
    types = Types(table)
    native, managed = Native(types), Managed(types)
    plain, pointers = list(native.structs(True)), list(native.structs(False))
    functions = [line for library in native.libraries() for line in native.functions(library)]
    yield "src/Generated/Enums.cs", source("Shd", [*native.enums(), *native.constants()])
    yield "src/Generated/Structs.cs", source("Shd", [*plain, *native.inline_arrays(False)])
    yield "src/Generated/NativeStructs.cs", source("Shd.Native", [*pointers, *native.inline_arrays(True)])
    yield "src/Generated/NativeDelegates.cs", source("Shd.Native", native.delegates())
    yield "src/Generated/NativeFunctions.cs", source("Shd.Native", functions)
    yield "src/Generated/Handles.cs", source("Shd", native.safe_handles())
    yield "src/Generated/Descs.cs", source("Shd", managed.twins())
    yield "src/Generated/Views.cs", source("Shd", managed.views())
    yield "src/Shd.dll.config", config(table)
    yield "tests/layout.txt", "\n".join([*native.layout(), ""])


if __name__ == "__main__":
    generated.save_all(HERE, dict(files()))
