# SPDX-License-Identifier: MIT
"""Environments: light from all directions."""
import ctypes

import numpy as np

from . import _api
from ._array import pixels_of
from ._columns import inputs, outputs, shape_of
from ._objects import Object, document, make_desc, option_texts


@document
class Environment(Object):
    """Environment(context, image, projection="lat_long", tables="all", ...).

    `image` is an array [height][width] or [height][width][channels] of linear radiance. A frame takes the environment
    as an option: render(..., environment=environment, background="environment").
    """

    _kind = "shd_environment"

    def __init__(self, context, image=None, desc=None, **values):
        keep = []
        if image is not None:
            values["image"] = pixels_of(image, "environment.image")
        made = make_desc("shd_environment_desc", desc, values)
        built = made.build(keep)
        self._adopt(keep, _api.lib.shd_environment_create, context.handle("shd_context", keep),
                    ctypes.addressof(built))
        self._options = option_texts(made)

    @property
    def info(self):
        """Tables, mean radiance and memory, as a dict."""
        return self._info("shd_environment_info")

    def _look_up(self, function, out, **values):
        keep, shape = [], shape_of(values["direction"], "direction")
        lookups = inputs("shd_environment_lookups", values, keep)
        made, arrays = outputs("shd_environment_values", "channel", shape, keep, out)
        _api.check(function(self.handle("shd_environment", keep), ctypes.addressof(lookups), ctypes.addressof(made)))
        return arrays[0]

    def sample_irradiance(self, direction, out=None) -> np.ndarray:
        """The irradiance of surfaces with these normals, as an array [..., 3] of float32."""
        return self._look_up(_api.lib.shd_environment_sample_irradiance, out, direction=direction)

    def sample_radiance(self, direction, roughness=None, exponent=None, out=None) -> np.ndarray:
        """The radiance along directions, or its mean over lobes of GGX or Phong, as an array [..., 3] of float32."""
        return self._look_up(_api.lib.shd_environment_sample_radiance, out, direction=direction, roughness=roughness,
                             exponent=exponent)
