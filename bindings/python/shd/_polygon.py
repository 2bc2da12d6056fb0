# SPDX-License-Identifier: MIT
"""Generalised barycentric coordinates of points in polygons and polyhedra."""
import ctypes

import numpy as np

from . import _api
from ._array import converted
from ._columns import inputs, same_length, shape_of
from ._convert import column, columns
from ._objects import Object, document, make_desc

FLOAT = np.dtype("f4")


def _count(parts, name):
    return same_length({f"{name}[{i}]": np.size(part) for i, part in enumerate(parts)}, name)


def _columns(values, kind, keep, name):
    """Structs of columns, and their address."""
    made = (_api.struct_type(kind) * max(len(values), 1))()
    for target, (i, value) in zip(made, enumerate(values)):
        target.data, target.stride, _ = column(value, FLOAT, kind == "shd_f32_out", f"{name}[{i}]", keep)
    keep.append(made)
    return ctypes.addressof(made)


def _results(struct, field, shape, count, keep, out):
    """A struct whose field is a list of output columns, and the array [..., count] behind them."""
    size = int(np.prod(shape, dtype=np.int64))
    if out is None:
        planes = np.empty((count, *shape), FLOAT)
        out, parts = np.moveaxis(planes, 0, -1), list(planes.reshape(count, -1))
    else:
        parts = columns(out, count, "out", True)
        if any(np.size(part) != size for part in parts):
            raise ValueError(f"out: columns of {[np.size(part) for part in parts]} rows, not {size}")
    made = _api.new(struct)
    setattr(made, field, _columns(parts, "shd_f32_out", keep, "out"))
    setattr(made, f"{field}_count", count)
    return made, out


def evaluate_polygon(context, vertex, position, desc=None, out=None, **values) -> np.ndarray:
    """The coordinates of points [..., 2] in a polygon of vertices [n][2]: an array [..., n] of float32.

    evaluate_polygon(context, [(0, 0), (1, 0), (0, 1)], points, kind="mean_value"). The other options are the fields of
    PolygonDesc.
    """
    keep, shape = [], shape_of(position, "position")
    count = _count(columns(vertex, 2, "vertex"), "vertex")
    built = make_desc("shd_polygon_desc", desc, {**values, "vertex": vertex}).replace(vertex_count=count).build(keep)
    points = inputs("shd_polygon_points", {"position": position}, keep)
    made, out = _results("shd_polygon_weights", "weight", shape, count, keep, out)
    _api.check(_api.lib.shd_polygon_evaluate(context.handle("shd_context", keep), ctypes.addressof(built),
                                             ctypes.addressof(points), ctypes.addressof(made)))
    return out


@document
class Polyhedron(Object):
    """Polyhedron(context, position, indices, kind="mean_value"): a closed mesh of triangles as a cage.

    `position` is an array [n][3], `indices` [triangles][3].
    """

    _kind = "shd_polyhedron"

    def __init__(self, context, position, indices, desc=None, **values):
        keep = []
        self._size = _count(columns(position, 3, "polyhedron.position"), "polyhedron.position")
        indices = converted(indices, np.dtype("u4"), "polyhedron.indices").reshape(-1)
        made = make_desc("shd_polyhedron_desc", desc, {**values, "position": position, "indices": indices})
        built = made.replace(vertex_count=self._size, index_count=indices.size).build(keep)
        self._adopt(keep, _api.lib.shd_polyhedron_create, context.handle("shd_context", keep), ctypes.addressof(built))

    def _run(self, function, position, made, keep):
        points = inputs("shd_polyhedron_points", {"position": position}, keep)
        _api.check(function(self.handle("shd_polyhedron", keep), ctypes.addressof(points), ctypes.addressof(made)))

    def evaluate(self, position, out=None) -> np.ndarray:
        """The coordinates of points [..., 3]: an array [..., n] of float32 for the n vertices."""
        keep, shape = [], shape_of(position, "position")
        made, out = _results("shd_polyhedron_weights", "weight", shape, self._size, keep, out)
        self._run(_api.lib.shd_polyhedron_evaluate, position, made, keep)
        return out

    def interpolate(self, position, value, out=None) -> np.ndarray:
        """Values of the vertices [n][k] at points [..., 3]: an array [..., k] of float32.

        With the positions of a moved cage as values, points of a model move with the cage.
        """
        keep, shape = [], shape_of(position, "position")
        value = np.asarray(converted(value, FLOAT, "value"))
        if value.ndim != 2 or len(value) != self._size:
            raise ValueError(f"value: an array [{self._size}][values], not of shape {value.shape}")
        made, out = _results("shd_polyhedron_values", "value", shape, value.shape[1], keep, out)
        made.vertex_value = _columns(list(value.T), "shd_f32_in", keep, "value")
        self._run(_api.lib.shd_polyhedron_interpolate, position, made, keep)
        return out
