# SPDX-License-Identifier: MIT
"""Bakes of materials and of ambient occlusion, into textures and onto vertices."""
import ctypes

import numpy as np

from . import _api
from ._callback import raise_failures
from ._columns import inputs, outputs, shape_of
from ._convert import column
from ._desc import read_struct
from ._objects import make_desc

FLOAT, STATE = np.dtype("f4"), np.dtype("u4")


def _column(array, dtype, count, name, keep):
    """An output column of a length."""
    made = _api.struct_type("shd_f32_out" if dtype == FLOAT else "shd_u32_out")()
    made.data, made.stride, size = column(array, dtype, True, name, keep)
    if size != count:
        raise ValueError(f"{name}: {size} rows, not {count}")
    keep.append(made)
    return made


def _finish(result, keep):
    raise_failures(keep)
    _api.check(result)


def _set_bake(made, states, count, keep):
    """Statistics and states of a bake, or of a texture of occlusion."""
    stats = _api.new("shd_bake_stats")
    made.stats = ctypes.addressof(stats)
    if states is not None:
        made.states = _column(states, STATE, count, "states", keep)
    return stats


def bake(context, framebuffer, draws=(), desc=None, uv_set=0, dilation=0, states=None, **values):
    """Shades surfaces at their texture coordinates: bake(context, framebuffer, [Draw(mesh=m, material=n)], dilation=4).

    The other options are those of a frame that a bake reads. `states` is an array [height][width] of uint32 for the
    TexelState of each texel. Returns statistics as a dict, and raises what a program raised.
    """
    keep, info = [], framebuffer.info
    frame = make_desc("shd_render_desc", desc, {**values, "draws": list(draws)}).replace(framebuffer=framebuffer)
    built = frame.build(keep)
    made = make_desc("shd_bake_desc", None, {"uv_set": uv_set, "dilation": dilation}).build(keep)
    stats = _set_bake(made, states, info["width"] * info["height"], keep)
    arguments = context.handle("shd_context", keep), ctypes.addressof(built), ctypes.addressof(made)
    _finish(framebuffer.exclusive(_api.lib.shd_bake, *arguments), keep)
    return read_struct("shd_bake_stats", stats)


def _occluders(desc, values, keep):
    return make_desc("shd_occlusion_desc", desc, values).build(keep)


def occlusion(context, position, normal, desc=None, out=None, **values):
    """The open part of the sky above points, 0 to 1: occlusion(context, position, normal, draws=[...], ray_count=256).

    The other options are the fields of OcclusionDesc. `tracer` is the tracer of shd.embree.Tree, or a dict with a
    function `trace(rays, blocked)`.
    """
    keep, shape = [], shape_of(position, "position")
    points = inputs("shd_occlusion_points", {"position": position, "normal": normal}, keep)
    target, arrays = outputs("shd_occlusion_values", "visibility", shape, keep, out)
    made = _occluders(desc, values, keep)
    _finish(_api.lib.shd_occlusion_compute(context.handle("shd_context", keep), ctypes.addressof(made),
                                           ctypes.addressof(points), ctypes.addressof(target)), keep)
    return arrays[0]


def vertex_occlusion(context, draw, desc=None, out=None, **values):
    """The occlusion of the vertices of a draw, as a column for `attributes` of a mesh. Options as of occlusion()."""
    keep, count = [], draw.mesh.info["vertex_count"]
    out = np.empty(count, FLOAT) if out is None else out
    target, built = _column(out, FLOAT, count, "out", keep), draw.build(keep)
    made = _occluders(desc, values, keep)
    _finish(_api.lib.shd_occlusion_compute_vertices(context.handle("shd_context", keep), ctypes.addressof(made),
                                                    ctypes.addressof(built), ctypes.addressof(target)), keep)
    return out


def bake_occlusion(context, width, height, surfaces, desc=None, out=None, states=None, uv_set=0, dilation=0, empty=1.0,
                   **values):
    """A texture of occlusion at the texture coordinates of surfaces, and its statistics.

    `surfaces` is a list of draws. Other options are those of occlusion(); without draws and a tracer the surfaces are
    their own occluders. The texture is an array [height][width] of float32.
    """
    keep = []
    if "draws" not in values and "tracer" not in values and desc is None:
        values["draws"] = surfaces
    made = _occluders(desc, values, keep)
    atlas = make_desc("shd_occlusion_atlas", None, {
        "width": width, "height": height, "draws": list(surfaces), "uv_set": uv_set, "dilation": dilation,
        "empty": empty}).build(keep)
    out = np.empty((height, width), FLOAT) if out is None else out
    target = _column(out, FLOAT, width * height, "out", keep)
    stats = _set_bake(atlas, states, width * height, keep)
    _finish(_api.lib.shd_occlusion_bake(context.handle("shd_context", keep), ctypes.addressof(made),
                                        ctypes.addressof(atlas), ctypes.addressof(target)), keep)
    return out, read_struct("shd_bake_stats", stats)
