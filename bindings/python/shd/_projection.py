# SPDX-License-Identifier: MIT
"""Projections: directions to points of images of all directions, and back."""
import ctypes

import numpy as np

from . import _api
from ._columns import answer, inputs, outputs, shape_of
from ._convert import enum_value
from ._image import FACES, image


def project(context, direction, projection="lat_long", want: "str | tuple" = ("u", "v"), out=None, **more):
    """Points of an image for directions [..., 3]: u, v = project(context, direction, "octahedral").

    `want` has names of columns of ProjectedPoints, such as "face" and "dudx"; direction_dx and direction_dy are further
    inputs.
    """
    keep, shape = [], shape_of(direction, "direction")
    made = inputs("shd_directions", {"direction": direction, **more}, keep)
    made.projection = enum_value("shd_projection", projection, "projection")
    points, arrays = outputs("shd_projected_points", want, shape, keep, out)
    _api.check(_api.lib.shd_projection_project(context.handle("shd_context", keep), ctypes.addressof(made),
                                               ctypes.addressof(points)))
    return answer(want, arrays)


def unproject(context, u, v, projection="lat_long", face=None, want: "str | tuple" = "direction", out=None):
    """Directions of points of an image, as an array [..., 3]; `want` may also name "solid_angle"."""
    keep = []
    made = inputs("shd_image_points", {"u": u, "v": v, "face": face}, keep)
    made.projection = enum_value("shd_projection", projection, "projection")
    directions, arrays = outputs("shd_point_directions", want, np.shape(u), keep, out)
    _api.check(_api.lib.shd_projection_unproject(context.handle("shd_context", keep), ctypes.addressof(made),
                                                 ctypes.addressof(directions)))
    return answer(want, arrays)


def _images(images, projection, layout, name, keep, in_place=False):
    made = _api.new("shd_direction_images")
    made.projection = enum_value("shd_projection", projection, f"{name}_projection")
    made.layout = enum_value("shd_cube_layout", layout, f"{name}_layout")
    several = list(images) if isinstance(images, (list, tuple)) else [images]
    is_faces = (made.projection == enum_value("shd_projection", "cube", name)
                and made.layout == enum_value("shd_cube_layout", "faces", name))
    if len(several) != (FACES if is_faces else 1):
        raise ValueError(f"{name}: {len(several)} images, not {FACES if is_faces else 1}")
    rows = [image(each, keep, f"{name}[{i}]", in_place=in_place) for i, each in enumerate(several)]
    array = (_api.struct_type("shd_image") * len(rows))(*rows)
    keep.append(array)
    made.images = ctypes.addressof(array)
    return made


def convert_projection(context, source, target, source_projection="lat_long", target_projection="cube",
                       source_layout="faces", target_layout="faces"):
    """Writes the directions of an image, or of six faces, to the images of another projection, layout or size."""
    keep = []
    for i, each in enumerate([target] if isinstance(target, np.ndarray) else target):
        if not isinstance(each, np.ndarray) or not each.flags.writeable:
            raise ValueError(f"target[{i}]: a writable NumPy array")
    made = [_images(source, source_projection, source_layout, "source", keep),
            _images(target, target_projection, target_layout, "target", keep, in_place=True)]
    _api.check(_api.lib.shd_projection_convert(context.handle("shd_context", keep),
                                               *(ctypes.addressof(m) for m in made)))
    return target
