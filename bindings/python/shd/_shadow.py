# SPDX-License-Identifier: MIT
"""Shadow maps."""
import ctypes
import threading

import numpy as np

from . import _api
from ._callback import raise_failures
from ._columns import inputs, outputs, shape_of
from ._objects import _Simple, document, make_desc


@document
class Shadow(_Simple):
    """Shadow(context, filter="pcf", size=1024, ...): a shadow without a map. Call render() before other uses.

    A frame takes shadows as a list at the places of their lights: render(..., lights=[sun, lamp], shadows=[shadow,
    None]).
    """

    _kind = "shd_shadow"

    def __init__(self, context, desc=None, **values):
        super().__init__(context, desc, **values)
        self.lock = threading.Lock()

    def render(self, context, light=None, draws=(), desc=None, **values):
        """Renders the map of a light: shadow.render(context, sun, draws). Raises what a program raised."""
        keep = []
        if light is not None:
            values["light"] = light
        built = make_desc("shd_shadow_render_desc", desc, {**values, "draws": list(draws)}).build(keep)
        handle = self.handle("shd_shadow", keep)
        if not self.lock.acquire(blocking=False):
            raise ValueError("shadow: another call renders it")
        try:
            result = _api.lib.shd_shadow_render(context.handle("shd_context", keep), handle, ctypes.addressof(built))
        finally:
            self.lock.release()
        raise_failures(keep)
        _api.check(result)

    def sample(self, position, normal=None, out=None) -> np.ndarray:
        """The fraction of the light that reaches points, 0 to 1, as an array of float32."""
        keep, shape = [], shape_of(position, "position")
        lookups = inputs("shd_shadow_lookups", {"position": position, "normal": normal}, keep)
        made, arrays = outputs("shd_shadow_values", "visibility", shape, keep, out)
        _api.check(_api.lib.shd_shadow_sample(self.handle("shd_shadow", keep), ctypes.addressof(lookups),
                                              ctypes.addressof(made)))
        return arrays[0]
