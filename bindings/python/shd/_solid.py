# SPDX-License-Identifier: MIT
"""Solid textures and noise as batches."""
import ctypes

from . import _api
from ._columns import answer, inputs, outputs, shape_of
from ._objects import make_desc


def evaluate_solid(position, desc=None, want="value", width=None, context=None, out=None, **values):
    """A solid texture at positions [..., 3]: evaluate_solid(position, kind="perlin", octaves=6).

    `want` is "value", "gradient" or "color", or a tuple of these names for a tuple of arrays. The other options are the
    fields of SolidDesc. A context provides the workers; without one the calling thread does the work.
    """
    keep, shape = [], shape_of(position, "position")
    built = make_desc("shd_solid_desc", desc, values).build(keep)
    points = inputs("shd_solid_points", {"position": position, "width": width}, keep)
    made, arrays = outputs("shd_solid_values", want, shape, keep, out)
    _api.check(_api.lib.shd_solid_evaluate(None if context is None else context.handle("shd_context", keep),
                                           ctypes.addressof(built), ctypes.addressof(points), ctypes.addressof(made)))
    return answer(want, arrays)
