# SPDX-License-Identifier: MIT
"""Materials of the renderer: colours, textures, and the material objects of trimesh."""
import numpy as np

from . import _api
from ._array import pixels_of
from ._convert import enum_value
from ._desc import desc_type
from ._objects import Material, Sampler, slot
from ._srgb import decode
from ._texture import Texture
from ._trimesh import is_simple, material_values

ANISOTROPIC = {"filter": "anisotropic", "max_anisotropy": 8, "wrap_u": "repeat", "wrap_v": "repeat"}
CODED = 4           # first column of colours of vertices as linear light of codes
SHOWN = (0, 4, 16)  # slots of unlit colours: diffuse, opacity and tint
PHONG = (1, 2, 3)  # slots for ambient and specular light, which metallic-roughness does not have


def linear_color(color, name="color"):
    """r, g, b, a as linear floats. Integers are sRGB codes 0..255, floats are linear; alpha is 1 by default."""
    array = np.asarray(color)
    if array.dtype.kind not in "fiu" or array.ndim < 1 or array.shape[-1] not in (3, 4):
        raise ValueError(f"{name}: r, g, b or r, g, b, a, not {array.dtype} of shape {array.shape}")
    made = np.ones((*array.shape[:-1], 4))
    if array.dtype.kind in "iu":
        array = array / 255
        made[..., :3] = decode(array[..., :3])
    else:
        made[..., :3] = array[..., :3]
    made[..., 3:] = array[..., 3:] if array.shape[-1] == 4 else 1
    return made


def colored(pixels):
    """Pixels with r, g and b: grey ones have equal channels."""
    if pixels.ndim == 2:
        pixels = pixels[..., np.newaxis]
    if pixels.ndim == 3 and pixels.shape[2] in (1, 2):
        pixels = pixels[..., (0, 0, 0, 1)[:pixels.shape[2] + 2]]
    return np.ascontiguousarray(pixels)


def make_texture(context, image, srgb, name="texture"):
    """A texture with mip levels, and whether a part of it is translucent."""
    if isinstance(image, Texture):
        return image, False
    image = getattr(image, "source", image) if hasattr(image, "source_channels") else image
    pixels = colored(pixels_of(image, name)) if srgb else pixels_of(image, name)
    integer = pixels.ndim == 3 and pixels.dtype in (np.uint8, np.uint16)
    translucent = integer and pixels.shape[2] == 4 and pixels[..., 3].min() < np.iinfo(pixels.dtype).max
    if srgb and pixels.dtype == np.uint16:  # no format has sRGB codes of 16 bits
        light = pixels / np.float64(65535)
        light[..., :3] = decode(light[..., :3])
        pixels = light.astype(np.float32)
    return Texture(context, pixels, srgb=srgb and pixels.dtype == np.uint8, tables="mipmap"), translucent


def make_sampler(context, image):
    """The sampler of a texture of shd.pyrender, or the one of all other images."""
    own = image.sampler.options() if hasattr(image, "source_channels") else ANISOTROPIC
    return Sampler(context, **own)


class Look:
    """A material, and a variant of it that shows its colours without light.

    With `shows_codes` the variant shows linear numbers as if they were sRGB codes, as pyrender does: 0.5 is 128. For
    colours of vertices, the columns CODED of the mesh have the linear light of these codes if `has_codes` is true.
    """

    def __init__(self, context, desc):
        self.lit, self._context, self.desc, self._flat = Material(context, desc), context, desc, None
        self.shows_codes = self.has_codes = False

    @property
    def flat(self):
        if self._flat is None:
            kept = {name: getattr(self.desc, name) for name in ("diffuse", "opacity", "blend", "alpha_cutoff")}
            slots = [s for s in self.desc._values.get("slots", ())
                     if int(enum_value("shd_slot_target", s.target, "target")) in SHOWN]
            if self.shows_codes:
                kept["diffuse"] = decode(kept["diffuse"])
            if self.has_codes:
                slots = [s.replace(attribute=CODED) for s in slots]
            self._flat = Material(self._context, model="unlit", slots=slots, **kept)
        return self._flat


class Fixed:
    """A material of the caller, which has no other variant."""

    def __init__(self, material):
        self.lit = self.flat = material


def make_look(context, color=None, texture=None, vertex_colors=False, blend=None, maps=(), **values):
    """A material of metallic-roughness from one colour, a texture or colours of vertices, and from maps.

    `maps` has tuples of the target of a slot, an image, whether its codes are those of sRGB, and a channel.
    """
    rgba = np.ones(4) if color is None else linear_color(color)
    slots, is_translucent = [], rgba[3] < 1
    if vertex_colors:
        slots.append(slot("diffuse", attribute=0))
    elif texture is not None:
        made, has_alpha = make_texture(context, texture, True)
        slots.append(slot("diffuse", made, make_sampler(context, texture)))
        is_translucent |= has_alpha
    slots += [slot(target, make_texture(context, image, srgb, target)[0], make_sampler(context, image), channel=channel)
              for target, image, srgb, channel in maps]
    return Look(context, desc_type("shd_material_desc")(**{
        "model": "metallic_roughness", "flags": "double_sided", "ambient_share": 1.0, "roughness": 0.8,
        "diffuse": rgba[:3], "opacity": rgba[3], "slots": slots,
        "blend": blend or ("sorted" if is_translucent else "opaque"), **values}))


def file_look(context, desc, metallic=0.0):
    """The material of a file, unlit or as metallic-roughness: lights have one unit for all materials.

    `metallic` is the value of materials of the Blinn-Phong model.
    """
    if desc.model == _api.enum_type("shd_model").BLINN_PHONG:
        desc = desc.replace(metallic=metallic)
    if desc.model == _api.enum_type("shd_model").UNLIT:
        return Look(context, desc)
    slots = [s for s in desc._values.get("slots", ()) if enum_value("shd_slot_target", s.target, "target") not in PHONG]
    return Look(context, desc.replace(model="metallic_roughness", slots=slots, ambient_share=1.0))


def options_of(material):
    """Options of make_look() from a material of trimesh."""
    values = material_values(material)
    color, texture = values["baseColorFactor"], values["baseColorTexture"]
    maps = [(target, values[name], srgb, channel) for target, name, srgb, channel in (
        ("normal", "normalTexture", False, 0), ("occlusion", "occlusionTexture", False, 0),
        ("roughness", "metallicRoughnessTexture", False, 1), ("metallic", "metallicRoughnessTexture", False, 2),
        ("emission", "emissiveTexture", True, 0)) if values[name] is not None]
    if is_simple(material):
        color = color if texture is None else None  # trimesh makes up the colour of a material with a texture
    elif color is not None:  # factors of glTF are linear; trimesh stores them as codes 0..255 or as floats
        color = np.asarray(color) / (255 if np.asarray(color).dtype.kind in "iu" else 1)
    # glTF's default is a metal, which is black without an environment: only a texture makes it the default here.
    defaults = {"metallic": 0.0 if values["metallicRoughnessTexture"] is None else 1.0, "roughness": 1.0}
    made = {name: default if values[f"{name}Factor"] is None else float(values[f"{name}Factor"])
            for name, default in defaults.items()}
    emission = values["emissiveFactor"]
    if emission is not None or values["emissiveTexture"] is not None:
        made["emission"] = np.ones(3) if emission is None else np.asarray(emission, np.float64)
    if values["alphaMode"] == "MASK":
        made.update(blend="opaque", alpha_cutoff=0.5 if values["alphaCutoff"] is None else float(values["alphaCutoff"]))
    elif values["alphaMode"] == "OPAQUE":
        made["blend"] = "opaque"
    return {"texture": texture, "color": color, "maps": maps, **made}
