# SPDX-License-Identifier: MIT
"""Lights of shd.pyrender, which shine along the -z axis of their node."""
import functools
import math

import numpy as np

from .._texture import Texture as Image
from ._checked import Checked, Shown, anything, color, number, text
from .camera import OrthographicCamera, PerspectiveCamera
from .constants import SHADOW_TEX_SZ
from .mesh import context
from .texture import Texture

WIDEST = 1.55         # outer angle of a spot light with a cookie [rad]
COOKIE_SIZE = 256     # texels of a side


@functools.lru_cache(maxsize=64)
def falloff(inner, outer):
    """A cookie that makes the falloff of shd, t^2 (3 - 2 t), the t^2 of pyrender (t as in shd/light.h)."""
    side = (2 * np.arange(COOKIE_SIZE) + 1) / COOKIE_SIZE - 1
    cosine = 1 / np.sqrt(1 + (side ** 2 + side[:, np.newaxis] ** 2) * math.tan(outer) ** 2)
    t = np.clip((cosine - math.cos(outer)) / max(math.cos(inner) - math.cos(outer), 1e-6), 0, 1)
    return Image(context(), 1 / (3 - 2 * t), swizzle=("r", "r", "r", "fill"))


class Light(Shown):
    """Base of the lights."""

    kind = ""
    name = Checked(text)
    color = Checked(color(3), "Linear r, g, b.")
    intensity = Checked(number(-math.inf), "Irradiance, or irradiance at a distance of 1.")
    shadow_texture = Checked(anything, "A place for the shadow map of a program; shd makes its own for each frame.")

    def __init__(self, color=None, intensity=None, name=None):
        self.color = (1.0, 1.0, 1.0) if color is None else color
        self.intensity = 1.0 if intensity is None else intensity
        self.name, self.shadow_texture = name, None

    def options(self):
        """Options of Renderer.add_light()."""
        return {"kind": self.kind, "color": self.color, "intensity": self.intensity}

    def _generate_shadow_texture(self, size=None):
        """Sets shadow_texture to an empty texture."""
        size = SHADOW_TEX_SZ if size is None else size
        self.shadow_texture = Texture(width=size, height=size, source_channels="D")

    def _get_shadow_camera(self, scene_scale):
        """A camera whose view has what the light shines on."""
        raise NotImplementedError(f"{type(self).__name__}: its shadow has no camera")


class DirectionalLight(Light):
    """A light from afar, of irradiance `intensity`."""

    kind = "directional"

    def _get_shadow_camera(self, scene_scale):
        return OrthographicCamera(scene_scale, scene_scale, 0.01 * scene_scale, 10 * scene_scale)


class PointLight(Light):
    """A light at a point: its irradiance at distance r is `intensity` / r^2."""

    kind = "point"
    range = Checked(number(0, or_equal=False, optional=True), "Distance where the light ends; None for none.")

    def __init__(self, color=None, intensity=None, range=None, name=None):
        super().__init__(color, intensity, name)
        self.range = range

    def options(self):
        return {**super().options(), "range": self.range or 0.0}

    def _generate_shadow_texture(self, size=None):
        raise NotImplementedError("PointLight: its shadow has six images")


def _inner(light, value, name):
    return number(0, light.outerConeAngle)(light, value, name)


class SpotLight(Light):
    """A light at a point with a cone."""

    kind = "spot"
    range = PointLight.range
    outerConeAngle = Checked(number(0, math.pi / 2 + 1e-9), "Angle from the axis where the light ends [rad].")
    innerConeAngle = Checked(_inner, "Angle from the axis where the light begins to fall off [rad].")

    def __init__(self, color=None, intensity=None, range=None, innerConeAngle=0.0, outerConeAngle=math.pi / 4,
                 name=None):
        super().__init__(color, intensity, name)
        self.range = range
        self.outerConeAngle, self.innerConeAngle = outerConeAngle, innerConeAngle

    def options(self):
        outer = min(self.outerConeAngle, WIDEST)
        inner = min(self.innerConeAngle, outer)
        return {**super().options(), "range": self.range or 0.0, "inner_angle": inner, "outer_angle": outer,
                "texture": falloff(inner, outer)}

    def _get_shadow_camera(self, scene_scale):
        field = min(2 * self.outerConeAngle + math.pi / 16, math.pi - math.pi / 16)
        return PerspectiveCamera(field, 0.01 * scene_scale, 10 * scene_scale, 1.0)
