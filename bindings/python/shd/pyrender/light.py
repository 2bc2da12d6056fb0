# SPDX-License-Identifier: MIT
"""Lights of shd.pyrender, which shine along the -z axis of their node."""
import math

from ._checked import Checked, anything, color, number, text
from .camera import OrthographicCamera, PerspectiveCamera
from .constants import SHADOW_TEX_SZ
from .texture import Texture

WIDEST = 1.5707  # outer angle of a spot light [rad]


class Light:
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
        return {**super().options(), "range": self.range or 0.0, "inner_angle": min(self.innerConeAngle, outer),
                "outer_angle": outer}

    def _get_shadow_camera(self, scene_scale):
        field = min(2 * self.outerConeAngle + math.pi / 16, math.pi - math.pi / 16)
        return PerspectiveCamera(field, 0.01 * scene_scale, 10 * scene_scale, 1.0)
