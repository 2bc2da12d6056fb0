# SPDX-License-Identifier: MIT
"""Materials of shd.pyrender."""
import numpy as np

from .._trimesh import material_values
from ._checked import Checked, Shown, anything, color, number, text
from .texture import Texture, one_of


def texture_of(channels):
    """Textures, or images of which a texture with these channels is made."""
    def check(_, value, name):
        return value if value is None or isinstance(value, Texture) else Texture(source=value, source_channels=channels)
    return check


def factor(_, value, name):
    return number(0, 1)(None, 1.0 if value is None else value, name)


def has_source(texture):
    return texture is not None and texture.source is not None


def channel_of(texture, letter, target):
    """The number of a channel of a texture. Without source_channels, the images of two channels have G and B."""
    channels = texture.source_channels or ("", "R", "GB", "RGB", "RGBA")[texture.source.shape[2]]
    if letter not in channels:
        raise ValueError(f"metallicRoughnessTexture: the channels {channels} of the source have no {letter}, {target}")
    return channels.index(letter)


class Material(Shown):
    """Base of the materials: what all models have."""

    name = Checked(text)
    normalTexture = Checked(texture_of("RGB"), "Normals in tangent space.")
    occlusionTexture = Checked(texture_of("R"), "The part of ambient light that arrives.")
    emissiveTexture = Checked(texture_of("RGB"), "Colour of emitted light, sRGB.")
    emissiveFactor = Checked(color(3, 0.0), "Linear colour of emitted light.")
    alphaMode = Checked(lambda self, value, name: one_of(("OPAQUE", "MASK", "BLEND"))(self, value or "OPAQUE", name))
    alphaCutoff = Checked(lambda self, value, name: number(0, 1)(self, 0.5 if value is None else value, name))
    doubleSided = Checked(lambda _, value, name: bool(value))
    smooth = Checked(anything)
    wireframe = Checked(lambda _, value, name: bool(value))

    def __init__(self, name=None, normalTexture=None, occlusionTexture=None, emissiveTexture=None, emissiveFactor=None,
                 alphaMode=None, alphaCutoff=None, doubleSided=False, smooth=True, wireframe=False):
        self.name, self.normalTexture, self.occlusionTexture = name, normalTexture, occlusionTexture
        self.emissiveTexture, self.emissiveFactor = emissiveTexture, emissiveFactor
        self.alphaMode, self.alphaCutoff, self.doubleSided = alphaMode, alphaCutoff, doubleSided
        self.smooth, self.wireframe = smooth, wireframe


class MetallicRoughnessMaterial(Material):
    """Factors and textures of glTF's metallic-roughness. Textures are arrays, images of Pillow or Texture."""

    baseColorFactor = Checked(color(4, 1.0), "Linear r, g, b and opacity.")
    baseColorTexture = Checked(texture_of("RGBA"), "Colour in sRGB and opacity; multiplies baseColorFactor.")
    metallicFactor = Checked(factor, "0 for dielectrics, 1 for metals.")
    roughnessFactor = Checked(factor, "0 for mirrors, 1 for rough surfaces.")
    metallicRoughnessTexture = Checked(texture_of("GB"), "Roughness and metalness, in the channels G and B.")

    def __init__(self, name=None, normalTexture=None, occlusionTexture=None, emissiveTexture=None, emissiveFactor=None,
                 alphaMode=None, alphaCutoff=None, doubleSided=False, smooth=True, wireframe=False,
                 baseColorFactor=None, baseColorTexture=None, metallicFactor=1.0, roughnessFactor=1.0,
                 metallicRoughnessTexture=None):
        super().__init__(name, normalTexture, occlusionTexture, emissiveTexture, emissiveFactor, alphaMode, alphaCutoff,
                         doubleSided, smooth, wireframe)
        self.baseColorFactor, self.baseColorTexture = baseColorFactor, baseColorTexture
        self.metallicFactor, self.roughnessFactor = metallicFactor, roughnessFactor
        self.metallicRoughnessTexture = metallicRoughnessTexture

    @property
    def is_transparent(self):
        """Whether a part of the surface lets light through."""
        if self.alphaMode == "OPAQUE":
            return False
        cutoff = {"MASK": self.alphaCutoff, "BLEND": 1.0}[self.alphaMode]
        texture = self.baseColorTexture
        return bool(self.baseColorFactor[3] < cutoff or (texture is not None and texture.is_transparent(cutoff)))

    def versions(self):
        """Numbers that change when the material, a texture or a sampler changes."""
        textures = [t for t in self.__dict__.values() if isinstance(t, Texture)]
        return (self.version, *((id(t), t.version, t.sampler.version) for t in textures))

    def options(self):
        """Options of a material of the renderer."""
        maps = [(target, getattr(self, f"{name}Texture"), srgb, channel) for target, name, srgb, channel in (
            ("normal", "normal", False, 0), ("occlusion", "occlusion", False, 0), ("emission", "emissive", True, 0),
            ("roughness", "metallicRoughness", False, "G"), ("metallic", "metallicRoughness", False, "B"))]
        maps = [(target, texture, srgb, channel_of(texture, channel, target) if isinstance(channel, str) else channel)
                for target, texture, srgb, channel in maps if has_source(texture)]
        values = {"color": np.asarray(self.baseColorFactor, np.float64),
                  "texture": self.baseColorTexture if has_source(self.baseColorTexture) else None,
                  "metallic": self.metallicFactor, "roughness": self.roughnessFactor,
                  "emission": np.asarray(self.emissiveFactor, np.float64),
                  "maps": maps}
        if self.alphaMode == "MASK":
            values.update(blend="opaque", alpha_cutoff=self.alphaCutoff)
        elif self.alphaMode == "OPAQUE" or not self.is_transparent:
            values["blend"] = "opaque"
        return values


def default_material(has_colors):
    """The material of meshes without one; their colours multiply a white one."""
    base = (1.0,) * 4 if has_colors else (0.3, 0.3, 0.3, 1.0)
    return MetallicRoughnessMaterial(alphaMode="BLEND", baseColorFactor=base, metallicFactor=0.2, roughnessFactor=0.8)


def material_of(material):
    """A material from one of trimesh."""
    if isinstance(material, MetallicRoughnessMaterial):
        return material
    values = material_values(material)
    mode = "MASK" if values["alphaMode"] == "MASK" else "BLEND"
    return MetallicRoughnessMaterial(**{**values, "alphaMode": mode})
