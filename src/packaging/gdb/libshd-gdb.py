# SPDX-License-Identifier: MIT
"""Printers of shd's handles for gdb, which loads this file together with libshd.

    (gdb) print texture
    $1 = (shd_texture *) 0x5555557a8f40: 2D, 512 x 512, SHD_FORMAT_RGBA8, 10 levels, 1 layer; 2 references

A handle that was released, or that is of another type, is named as such. The printers read memory and call nothing, so
they work in core files and beside stopped threads. They need the debug information of libshd (libshd0.1-dbgsym).
"""
import re

import gdb
import gdb.printing


def number_of(atomic):
    """The value of a std::atomic, of libstdc++ or libc++."""
    fields = [field.name for field in atomic.type.strip_typedefs().fields()]
    if "_M_i" in fields:
        return int(atomic["_M_i"])
    return number_of(atomic[atomic.type.fields()[0]]) if fields else int(atomic)


def count(number, word):
    return f"{number} {word}{'' if number == 1 else 's'}"


def texture(body):
    width, height, depth = int(body["width"]), int(body["height"]), int(body["depth"])
    projection = str(body["projection"])
    kind = "3D" if depth else "2D" if projection == "SHD_PROJECTION_NONE" else projection
    size = f"{width} x {height}" + (f" x {depth}" if depth else "")
    levels, layers = count(int(body["level_count"]), "level"), count(int(body["layers"]), "layer")
    return f"{kind}, {size}, {body['given_format']}, {levels}, {layers}"


def sampler(body):
    return f"{body['filter']}, wrap {body['wrap_u']}, {body['wrap_v']}, {body['wrap_w']}"


def mesh(body):
    return f"{count(int(body['vertex_count']), 'vertex').replace('vertexs', 'vertices')}, " + \
           count(int(body["triangle_count"]), "triangle")


def framebuffer(body):
    samples = count(int(body["samples"]), "sample")
    return f"{int(body['width'])} x {int(body['height'])}, {body['color_format']}, {samples} a pixel"


def light(body):
    kind, intensity = body["light"]["kind"], body["light"]["intensity"]
    return f"{kind}, intensity {', '.join(f'{float(intensity[c]):g}' for c in range(3))}"


def shadow(body):
    return f"{body['options']['filter']}, {'rendered' if body['is_rendered'] else 'not rendered'}"


def material(body):
    return str(body["model"].cast(gdb.lookup_type("shd_model")))


def environment(body):
    return f"image of {body['projection']}"


def volume(body):
    return " x ".join(str(int(body["blocks"][axis])) for axis in range(3)) + " blocks"


# Name of the handle: name in shd::core::ObjectType, type of the body, text.
HANDLES = {
    "shd_texture": ("kTexture", "shd::texture::Texture", texture),
    "shd_sampler": ("kSampler", "shd::texture::Sampler", sampler),
    "shd_mesh": ("kMesh", "shd::geometry::Mesh", mesh),
    "shd_material": ("kMaterial", "shd::material::Material", material),
    "shd_light": ("kLight", "shd::light::LightBody", light),
    "shd_framebuffer": ("kFramebuffer", "shd::film::Framebuffer", framebuffer),
    "shd_shadow": ("kShadow", "shd::light::Shadow", shadow),
    "shd_environment": ("kEnvironment", "shd::environment::Environment", environment),
    "shd_volume": ("kVolume", "shd::volume::Volume", volume),
}


def describe(name, address):
    """The text of a handle. Throws gdb.error where memory or debug information is missing."""
    wanted, body_type, text = HANDLES[name]
    head = gdb.Value(address).cast(gdb.lookup_type("shd::core::Object").pointer()).dereference()
    types = {field.enumval: field.name.split("::")[-1] for field in gdb.lookup_type("shd::core::ObjectType").fields()}
    found = types.get(number_of(head["type"]))
    if found == "kNone":
        return "released"
    if found != wanted:
        return f"not a {name}" + (f", but a {found[1:].lower()}" if found else "")
    body = head["body"].cast(gdb.lookup_type(body_type).pointer()).dereference()
    return f"{text(body)}; {count(number_of(head['references']), 'reference')}"


class HandlePrinter:
    def __init__(self, value, name):
        self.value, self.name = value, name

    def to_string(self):
        address = int(self.value)
        plain = f"({self.name} *) {address:#x}"
        if address == 0:
            return plain
        try:
            return f"{plain}: {describe(self.name, address)}"
        except gdb.error:
            return plain


class Printers(gdb.printing.PrettyPrinter):
    def __init__(self):
        super().__init__("shd")

    def __call__(self, value):
        kind = value.type.strip_typedefs()
        if kind.code != gdb.TYPE_CODE_PTR:
            return None
        name = re.sub(r"^(const |struct )*", "", str(kind.target().unqualified()))
        return HandlePrinter(value, name) if name in HANDLES else None


gdb.printing.register_pretty_printer(gdb.current_objfile(), Printers(), replace=True)
