# SPDX-License-Identifier: MIT
"""Solid textures and noise as batches."""
import ctypes

from . import _api
from ._columns import answer, inputs, outputs, shape_of
from ._objects import make_desc


def evaluate_solid(context, position, desc=None, want: "str | tuple" = "value", width=None, out=None, **values):
    """A solid texture at positions [..., 3]: evaluate_solid(context, position, kind="perlin", octaves=6).

    `want` is "value", "gradient" or "channel", or a tuple of these names for a tuple of arrays. The other options are
    the fields of SolidDesc.
    """
    keep, shape = [], shape_of(position, "position")
    built = make_desc("shd_solid_desc", desc, values).build(keep)
    points = inputs("shd_solid_points", {"position": position, "width": width}, keep)
    made, arrays = outputs("shd_solid_values", want, shape, keep, out)
    _api.check(_api.lib.shd_solid_evaluate(context.handle("shd_context", keep), ctypes.addressof(built),
                                           ctypes.addressof(points), ctypes.addressof(made)))
    return answer(want, arrays)
