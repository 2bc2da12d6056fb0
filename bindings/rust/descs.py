# SPDX-License-Identifier: MIT
"""The descs and enums of the safe crate."""
import re

from names import camel, doc_lines, field_name, flag_word

HEAD = """// SPDX-License-Identifier: MIT
// Descs and enums of the safe crate. Written by generate.py; do not edit.
use crate::sys;
"""
# Struct of C -> fields that the crate passes in another form. Pointers are always left out, and so are fields that
# describe what a pointer points at: memory safety depends on them.
DESCS = {
    "shd_context_desc": set(),
    "shd_texture_desc": {"flags", "level_count"},
    "shd_texture_info": set(),
    "shd_sampler_desc": set(),
    "shd_framebuffer_desc": set(),
    "shd_framebuffer_info": set(),
    "shd_light_desc": set(),
    "shd_slot": {"target", "source", "attribute"},
    "shd_material_desc": {"slot_count", "varying_count"},
    "shd_mesh_info": set(),
    "shd_shape_desc": set(),
    "shd_solid_desc": set(),
    "shd_camera": set(),
    "shd_view": set(),
    "shd_region": set(),
    "shd_draw": {"instance_count"},
    "shd_render_desc": {"draw_count", "light_count", "volume_count"},
    "shd_render_stats": set(),
    "shd_environment_desc": set(),
    "shd_environment_info": set(),
    "shd_shadow_desc": set(),
    "shd_shadow_render_desc": {"draw_count"},
    "shd_load_desc": set(),
    "shd_raw_desc": {"flags"},
    "shd_vdb_desc": set(),
    "shd_vdb_info": {"grid"},
    "shd_texture_file_info": set(),
    "shd_ktx2_desc": set(),
    "shd_scene_desc": set(),
    "shd_scene_info": set(),
    "shd_scene_instance": set(),
    "shd_save_desc": set(),
    "shd_color_desc": set(),
    "shd_tile_cache_desc": set(),
    "shd_tile_cache_stats": set(),
    "shd_tile_region": set(),
    "shd_tile_file_desc": set(),
    "shd_tile_file_info": set(),
}
RENAMED = {"shd_box": "FilterBox", "shd_draw": "DrawDesc", "shd_slot": "SlotDesc", "shd_result": "ResultCode"}


def prefix_of(enum):
    if enum == "shd_result":
        return "SHD_"
    return "SHD_" + re.sub(r"_(flag|target)$", "", enum.removeprefix("shd_")).upper() + "_"


def value_name(constant, prefix):
    """A name begins with a letter: 2D is D2."""
    return re.sub(r"^(\d)D$", r"D\1", constant.removeprefix(prefix))


def enum_name(enum):
    return RENAMED.get(enum, camel(enum))


class Descs:
    """The text of descs.rs."""

    def __init__(self, table, type_of):
        self.table = table
        self.type_of = type_of
        self.structs = {s["name"]: s for s in table["structs"]}
        self.enums = {e["name"] for e in table["enums"]}

    def is_plain(self, field):
        text = field["type"]
        return "*" not in text and "." not in text and (text not in self.structs or text in DESCS)

    def fields(self, name):
        left_out = DESCS[name] | {"struct_size"}
        return [f for f in self.structs[name]["fields"] if f["name"] not in left_out and self.is_plain(f)
                and not f["type"].endswith("_fn")]

    def rust_type(self, field):
        """The type of a field, its conversion to C, and from C."""
        name, text = f"self.{field_name(field['name'])}", field["type"]
        back = f"raw.{field_name(field['name'])}"
        if bits := flag_word(text, self.table["typedefs"]):
            return enum_name(bits), f"{name}.0", f"{enum_name(bits)}({back})"
        if text in self.enums:
            whole = self.type_of(text, field.get("array", ()))
            return whole.replace(text, enum_name(text)), name, back
        if text in DESCS:
            return RENAMED.get(text, camel(text)), f"{name}.to_raw()", f"{camel(text)}::from_raw(&{back})"
        return self.type_of(text, field.get("array", ())), name, back

    def struct(self, name):
        entry, rust = self.structs[name], RENAMED.get(name, camel(name))
        fields = [(f, *self.rust_type(f)) for f in self.fields(name)]
        yield ""
        yield from doc_lines(entry.get("doc", ""))
        yield "#[derive(Clone, Copy, Debug, PartialEq)]"
        yield f"pub struct {rust} {{"
        for field, kind, _, _ in fields:
            yield from doc_lines(field.get("doc", ""), "    ")
            yield f"    pub {field_name(field['name'])}: {kind},"
        yield "}"
        yield f"impl {rust} {{"
        yield "    #[allow(dead_code)]"
        yield f"    pub(crate) fn to_raw(self) -> sys::{name} {{"
        yield f"        let mut raw = sys::{name}::default();"
        yield from (f"        raw.{field_name(f['name'])} = {to};" for f, _, to, _ in fields)
        yield "        raw"
        yield "    }"
        yield "    #[allow(dead_code)]"
        yield f"    pub(crate) fn from_raw(raw: &sys::{name}) -> Self {{"
        yield "        Self {"
        yield from (f"            {field_name(f['name'])}: {back}," for f, _, _, back in fields)
        yield "        }"
        yield "    }"
        yield "}"
        if "desc_kind" not in entry:
            return
        yield f"impl Default for {rust} {{"
        yield f"    /// The defaults of `{name}`."
        yield "    fn default() -> Self {"
        yield f"        Self::from_raw(&sys::{name}::default())"
        yield "    }"
        yield "}"

    def text(self):
        lines = [HEAD]
        for entry in sorted(self.table["enums"], key=lambda e: e["name"]):
            if entry["name"] != "shd_desc_kind":
                lines.append("#[doc(inline)]")
                lines.append(f"pub use sys::{entry['name']} as {enum_name(entry['name'])};")
        for name in DESCS:
            lines += self.struct(name)
        return "\n".join([*lines, ""])
