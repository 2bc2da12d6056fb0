#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the generated sources of the crates shd-sys and shd from shd.json.

shd-sys/src/api.rs has the whole C API, shd-sys/tests/layout.rs its offsets, and shd/src/descs.rs the descs and enums of
the safe crate.
"""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parent))
import descs
import generated
from names import doc_lines, field_name

SCALARS = {"float": "f32", "double": "f64", "size_t": "usize", "char": "c_char", "void": "c_void", "int": "c_int",
           "int32_t": "i32", "int64_t": "i64", "uint8_t": "u8", "uint16_t": "u16", "uint32_t": "u32", "uint64_t": "u64"}
HEAD = """// SPDX-License-Identifier: MIT
// The C API. Written by generate.py; do not edit.
#![allow(clippy::too_many_arguments)]
use core::ffi::c_void;
use std::os::raw::c_char;

use crate::Opaque;
"""
LAYOUT_HEAD = """// SPDX-License-Identifier: MIT
//! Sizes and offsets of the structs are those of the C headers on 64-bit machines. Written by generate.py; do not edit.
#![cfg(target_pointer_width = "64")]
use std::mem::MaybeUninit;
use std::ptr::addr_of;

use shd_sys::*;

macro_rules! offset {
    ($type:ty, $field:tt, $offset:expr) => {
        let place = MaybeUninit::<$type>::uninit();
        let base = place.as_ptr();
        // The field is never read; only its address is taken.
        let field = unsafe { addr_of!((*base).$field) } as usize;
        assert_eq!(field - base as usize, $offset, "{}.{}", stringify!($type), stringify!($field));
    };
}
"""


class Sys:
    """The text of shd-sys."""

    def __init__(self, table):
        self.table = table
        self.flag_enums = {t["bits_of"] for t in table["typedefs"] if "bits_of" in t}

    def callback(self, name):
        """A callback without a name of its own is named after its field."""
        return name if name.endswith("_fn") else name.replace(".", "_") + "_fn"

    def type_of(self, text, lengths=()):
        if lengths:
            return f"[{self.type_of(text, lengths[1:])}; {lengths[0]}]"
        if match := re.match(r"(.*?) ?\*const \(\*\)\[(\d+)\]$", text):
            return f"*const [*mut {self.type_of(match[1])}; {match[2]}]"
        base, stars = re.match(r"((?:const )?[\w.]+) ?(.*)$", text).groups()
        is_const, base = base.startswith("const "), base.removeprefix("const ")
        result = self.callback(base) if "." in base else SCALARS.get(base, base)
        for star in re.findall(r"\*(?:const)?", stars):
            result = f"*{'const' if is_const else 'mut'} {result}"
            is_const = star.endswith("const")
        return result

    def parameters(self, entry):
        return ", ".join(f"{field_name(p['name'])}: {self.type_of(p['type'])}" for p in entry.get("parameters", []))

    def signature(self, entry):
        result = "" if entry["result"] == "void" else f" -> {self.type_of(entry['result'])}"
        return f"({self.parameters(entry)}){result}"

    def constants(self):
        for entry in self.table["constants"]:
            kind = "usize" if entry["name"] == "SHD_TEXTURE_PADDING" else "u32"
            yield from doc_lines(entry.get("doc", ""))
            yield f"pub const {entry['name']}: {kind} = {entry['value']};"

    def enum(self, entry):
        name = entry["name"]
        yield ""
        yield from doc_lines(entry.get("doc", ""))
        yield "#[repr(transparent)]"
        yield "#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]"
        yield f"pub struct {name}(pub u32);"
        values = [c for c in entry["constants"] if not c["name"].endswith("_MAX_ENUM")]
        prefix = descs.prefix_of(name)
        short = [(descs.value_name(c["name"], prefix), c) for c in values]
        yield f"impl {name} {{"
        for word, constant in short:
            yield from doc_lines(constant.get("doc", ""), "    ")
            yield f"    pub const {word}: Self = Self({constant['value']});"
        yield "}"
        yield from (f"pub const {c['name']}: {name} = {name}::{word};" for word, c in short)
        if name in self.flag_enums:
            yield f"flags!({name});"
        else:
            arms = ", ".join(word for word, _ in short)
            yield f"names!({name}: {arms});"

    def callbacks(self):
        for entry in self.table["callbacks"]:
            yield ""
            yield from doc_lines(entry.get("doc", "") or f"Type of `{entry['name']}`.")
            yield f"pub type {self.callback(entry['name'])} = Option<unsafe extern \"C\" fn{self.signature(entry)}>;"

    def struct(self, entry):
        name = entry["name"]
        yield ""
        yield from doc_lines(entry.get("doc", ""))
        yield "#[repr(C)]"
        yield "#[derive(Clone, Copy, Debug)]"
        yield f"pub struct {name} {{"
        for field in entry["fields"]:
            yield from doc_lines(field.get("doc", ""), "    ")
            yield f"    pub {field_name(field['name'])}: {self.type_of(field['type'], field.get('array', ()))},"
        yield "}"
        yield "#[cfg(target_pointer_width = \"64\")]"
        yield f"const _: () = assert!(core::mem::size_of::<{name}>() == {entry['size']});"
        yield "#[cfg(target_pointer_width = \"64\")]"
        yield f"const _: () = assert!(core::mem::align_of::<{name}>() == {entry['alignment']});"
        if kind := entry.get("desc_kind"):
            yield f"init!({name}, {kind});"
        else:
            yield f"init!({name});"

    def functions(self, library):
        feature = library.removeprefix("shd_")
        if feature != library:
            yield f"#[cfg(feature = \"{feature}\")]"
        yield "extern \"C\" {"
        for entry in self.table["functions"]:
            if entry.get("library") != library:
                continue
            yield from doc_lines("\n\n".join(filter(None, [entry.get("doc", ""), entry.get("returns", "")])), "    ")
            parameters = [f"- `{p['name']}`: {p['doc']}" for p in entry.get("parameters", []) if p.get("doc")]
            if parameters:
                yield "    ///"
                yield from doc_lines("\n".join(parameters), "    ")
            yield f"    pub fn {entry['name']}{self.signature(entry)};"
        yield "}"

    def api(self):
        lines = [HEAD, *self.constants()]
        for entry in self.table["enums"]:
            lines += self.enum(entry)
        for entry in self.table["typedefs"]:
            lines += ["", *doc_lines(f"Word of {entry['doc']}." if "bits_of" in entry else entry["doc"])]
            lines.append(f"pub type {entry['name']} = {self.type_of(entry['type'])};")
        for entry in self.table["handles"]:
            lines += ["", *doc_lines(entry.get("doc", "")), "#[repr(C)]", f"pub struct {entry['name']} {{",
                      "    _data: [u8; 0],", "    _marker: Opaque,", "}"]
        lines += self.callbacks()
        for entry in self.table["structs"]:
            lines += self.struct(entry)
        for library in sorted({f["library"] for f in self.table["functions"] if "library" in f}):
            lines += ["", *self.functions(library)]
        return "\n".join([*lines, ""])

    def layout(self):
        lines = [LAYOUT_HEAD]
        for entry in self.table["structs"]:
            lines += ["#[test]", f"fn {entry['name']}_offsets() {{"]
            lines += [f"    offset!({entry['name']}, {field_name(f['name'])}, {f['offset']});" for f in entry["fields"]]
            lines += ["}", ""]
        return "\n".join(lines)


def main():
    table = generated.description()
    sys_crate = Sys(table)
    generated.save_all(HERE, {
        "shd-sys/src/api.rs": sys_crate.api(), "shd-sys/tests/layout.rs": sys_crate.layout(),
        "shd/src/descs.rs": descs.Descs(table, sys_crate.type_of).text()})


if __name__ == "__main__":
    main()
