# SPDX-License-Identifier: MIT
"""Volumes: 3D textures of density with a transfer function."""
import ctypes

import numpy as np

from . import _api
from ._columns import same_length
from ._convert import columns
from ._objects import Object, document, make_desc


@document
class Volume(Object):
    """Volume(context, texture, density=[0, 1], extinction=[0, 20], color=None, ...).

    `density` and `extinction` are columns of the points of the transfer function, `color` is [points][3]. A frame takes
    volumes as a list: render(..., volumes=[VolumeDraw(volume=volume)]).
    """

    _kind = "shd_volume"

    def __init__(self, context, texture=None, desc=None, **values):
        keep = []
        if texture is not None:
            values["texture"] = texture
        made = make_desc("shd_volume_desc", desc, values)
        built = made.build(keep)
        built.point_count = self._count(made._values)
        self._adopt(keep, _api.lib.shd_volume_create, context.handle("shd_context", keep), ctypes.addressof(built))

    @staticmethod
    def _count(values):
        """The number of points, which all columns must have."""
        sizes = {"point_count": values["point_count"]} if "point_count" in values else {}
        for name in ("density", "extinction"):
            if values.get(name) is not None:
                sizes[name] = np.size(values[name])
        if values.get("color") is not None:
            sizes.update({f"color[{i}]": np.size(c) for i, c in
                          enumerate(columns(values["color"], 3, "volume.color"))})
        return same_length(sizes, "volume")
