# SPDX-License-Identifier: MIT
"""Materials of model files as those of shd.pyrender. Their textures are read when a program asks for the texels."""
import functools

import numpy as np

from .. import _api, _objects, _srgb, _texture
from .._convert import enum_value
from .._png import straight
from .constants import GLTF
from .material import MetallicRoughnessMaterial
from .mesh import context
from .texture import FILTERS, WRAPS, Sampler, Texture

DIFFUSE, OPACITY, EMISSION, METALLIC, ROUGHNESS, OCCLUSION, NORMAL = 0, 4, 5, 6, 7, 8, 9  # targets of slots


def stored_material(desc, is_double_sided):
    """The factors and textures of the desc of a material, which is not changed by changes of the result."""
    slots = {int(enum_value("shd_slot_target", s.target, "target")): s for s in desc._values.get("slots", ())
             if s._values.get("texture") is not None}
    plane = lambda target, channel=None: [] if target not in slots else [
        (slots[target], slots[target].channel if channel is None else channel)]
    color = lambda target: [plane(target, i) for i in range(3)]
    named = {
        "baseColorTexture": ("RGBA", [*color(DIFFUSE), plane(DIFFUSE, 3) + plane(OPACITY)]),
        "normalTexture": ("RGB", color(NORMAL)), "emissiveTexture": ("RGB", color(EMISSION)),
        "occlusionTexture": ("R", [plane(OCCLUSION)]),
        "metallicRoughnessTexture": ("GB", [plane(ROUGHNESS), plane(METALLIC)])}
    is_blended = enum_value("shd_blend", desc.blend, "blend") != enum_value("shd_blend", "opaque", "blend")
    return MetallicRoughnessMaterial(
        alphaMode="BLEND" if is_blended else "MASK" if desc.alpha_cutoff > 0 else "OPAQUE",
        alphaCutoff=desc.alpha_cutoff or None, metallicFactor=min(desc.metallic, 1.0),
        roughnessFactor=min(desc.roughness, 1.0), emissiveFactor=np.float32(desc.emission),
        baseColorFactor=np.float32([*desc.diffuse, desc.opacity]), doubleSided=is_double_sided,
        **{name: StoredTexture(channels, planes) for name, (channels, planes) in named.items() if any(planes)})


class StoredTexture(Texture):
    """A texture of a file. Each channel is the product of channels of slots, or 1 without any."""

    def __init__(self, channels, planes):
        first = next(slot for plane in planes for slot, _ in plane)
        super().__init__(sampler=stored_sampler(first._values.get("sampler")), source_channels=channels)
        self._planes = planes

    @property
    def source(self):
        if self._planes is not None:
            self.__dict__["_source"], self._planes = merged(self._planes), None
        return self.__dict__["_source"]

    @source.setter
    def source(self, value):
        self._planes = None
        Texture.source.__set__(self, value)

    def __getstate__(self):  # of copies and pickles, which have the texels
        return {**self.__dict__, "_source": self.source, "_planes": None}


def merged(planes):
    """The image of the channels of slots, as large as the largest of their textures."""
    read = {id(slot): texels(slot) for plane in planes for slot, _ in plane}
    height, width = np.max([image.shape[:2] for image in read.values()], axis=0)
    made = np.ones((height, width, len(planes)), np.float32)
    for i, plane in enumerate(planes):
        for slot, channel in plane:
            image = read[id(slot)]
            rows, columns = (np.arange(n) * have // n for n, have in zip((height, width), image.shape))
            made[..., i] *= image[rows[:, np.newaxis], columns, channel]
    return np.rint(255 * np.clip(made, 0, 1)).astype(np.uint8)


def texels(slot):
    """The base level of the texture of a slot as numbers 0..1 [height][width][4]: codes of sRGB for colours, components
    c of normals as (c + 1) / 2."""
    texture, target = slot.texture, int(enum_value("shd_slot_target", slot.target, "target"))
    info, is_color = texture.info, target in (DIFFUSE, EMISSION)
    kind = info["format"].name
    is_premultiplied = info["flags"] & _api.constant("SHD_TEXTURE_PREMULTIPLIED")
    if kind == ("RGBA8_SRGB" if is_color else "RGBA8"):
        codes = texture.read_level()
        return (straight(codes) if is_premultiplied else codes) / np.float32(255)
    v, u = ((np.arange(n, dtype=np.float32) + 0.5) / n for n in (info["height"], info["width"]))
    u, v = np.meshgrid(u, v)
    made = texture.sample(_objects.Sampler(context(), filter="nearest"), u, v)
    if is_premultiplied:
        made[..., :3] /= np.where(made[..., 3:] > 0, made[..., 3:], 1)
    if is_color:
        made[..., :3] = _srgb.encode(np.clip(made[..., :3], 0, 1))
    elif target == NORMAL and (kind.endswith(("F", "FLOAT", "SNORM"))):
        made = (made + 1) / 2
    return made


@functools.lru_cache(maxsize=None)
def probe():
    """A texture of 4 x 4 texels with three levels, whose values tell wraps and filters apart: texel (x, y) of the base
    is x + 4 y, the second level is 100 and 102, the third 200."""
    levels = [np.float32([[100, 102]] * 2), np.float32([[200]])]
    return _texture.Texture(context(), np.arange(16, dtype=np.float32).reshape(4, 4), tables="mipmap",
                            level_images=levels)


def stored_sampler(sampler):
    """The wraps and filters of a sampler of the library, by what it makes of a texture."""
    if sampler is None:
        return Sampler()
    look = lambda u, v, lod: float(probe().sample(sampler, np.float32([u]), np.float32([v]), 1, lod=np.float32([lod])))
    wraps = {1: "repeat", 3: "clamp", 2: "mirror"}  # of texel 5 of four, by the texel that is seen
    numbers = {name: number for number, name in WRAPS.items()}
    across, down = (wraps.get(round(x)) for x in (look(5.5 / 4, 0.5 / 4, -1), look(0.5 / 4, 5.5 / 4, -1) / 4))
    between = look(0.5, 0.25, 1.5)  # the second and the third level
    if between < 100:
        name = "nearest" if look(0.25, 0.125, 1.5) in (0, 1) else "bilinear"
    else:
        is_nearest = look(0.5, 0.25, 1.0) in (100, 102)
        name = {(True, False): "nearest_mip_linear", (True, True): "nearest_mip", (False, True): "bilinear_mip"}.get(
            (is_nearest, between in (100, 101, 102, 200)), "trilinear")
    magnified = GLTF.NEAREST if look(0.25, 0.125, -1) in (0, 1) else GLTF.LINEAR
    return Sampler(magFilter=magnified, minFilter={v: k for k, v in FILTERS.items()}[name],
                   wrapS=numbers[across or "repeat"], wrapT=numbers[down or "repeat"])
