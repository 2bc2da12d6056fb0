# SPDX-License-Identifier: MIT
"""Shadow maps."""
import ctypes
import threading

import numpy as np

from . import _api
from ._callback import raise_failures
from ._columns import inputs, outputs, shape_of
from ._objects import _Simple, document, make_desc, read_columns


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

    @property
    def info(self):
        """Filter, size and range of the map, as a dict."""
        return self._info("shd_shadow_info")

    def read_map(self, face=0):
        """A face of the map as its filter reads it: an array [height][width] of depths, or [height][width][2] of
        moments or sums."""
        keep, info = [], self.info
        columns = 2 if info["filter"].name in ("VARIANCE", "SUMMED_AREA_VARIANCE") else 1
        out = np.empty((info["height"], info["width"], columns), np.float32)
        read_columns(_api.lib.shd_shadow_read_map, (self.handle("shd_shadow", keep), face), out, count=2)
        return out if columns == 2 else out[..., 0]

    def sample(self, position, normal=None, out=None) -> np.ndarray:
        """The fraction of the light that reaches points, 0 to 1, as an array of float32."""
        keep, shape = [], shape_of(position, "position")
        lookups = inputs("shd_shadow_lookups", {"position": position, "normal": normal}, keep)
        made, arrays = outputs("shd_shadow_values", "visibility", shape, keep, out)
        _api.check(_api.lib.shd_shadow_sample(self.handle("shd_shadow", keep), ctypes.addressof(lookups),
                                              ctypes.addressof(made)))
        return arrays[0]
