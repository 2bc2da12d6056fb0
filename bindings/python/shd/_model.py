# SPDX-License-Identifier: MIT
"""Models of the renderer: parts with a mesh and a material, from arrays, from meshes of trimesh, and from files."""
import copy
import itertools

import numpy as np

from ._array import array_of, check_range
from ._camera import matrix
from ._convert import enum_value
from ._desc import desc_type
from ._material import Fixed, file_look, linear_color, make_look, options_of
from ._objects import Mesh
from ._srgb import decode
from ._trimesh import surface_of, unshared


def floats(value, width, name):
    """Numbers [count][width] as float32."""
    array = array_of(value, name)
    if array.dtype.kind not in "fiu" or array.ndim != 2 or array.shape[1] != width:
        raise ValueError(f"{name}: numbers of shape [count][{width}], not {array.dtype} of shape {array.shape}")
    return np.ascontiguousarray(array, np.float32)


def triangles(value, count, name):
    """Numbers of vertices as uint32, [triangles][3]."""
    array = array_of(value, name)
    if array.dtype.kind not in "iu" or (array.ndim == 2 and array.shape[1] != 3) or array.size % 3:
        raise ValueError(f"{name}: integers of shape [triangles][3], not {array.dtype} of shape {array.shape}")
    check_range(array, count - 1, name)
    return np.ascontiguousarray(array.reshape(-1, 3), np.uint32)


def corners_of(bounds):
    """The eight corners of the lowest and highest x, y, z, [8][3]."""
    return bounds[np.array(list(itertools.product((0, 1), repeat=3))), np.arange(3)]


class Part:
    """A mesh with a material at a place of its model."""

    def __init__(self, mesh, look, local=None, values=None):
        self.mesh, self.look, self.values = mesh, look, values or {}
        self.local = np.eye(4) if local is None else local
        info = mesh.info
        corners = corners_of(np.array([info["bounds_min"], info["bounds_max"]], np.float64))
        self.corners = np.append(corners, np.ones((8, 1)), axis=1).T
        self.instances = None
        self.is_empty = not info["triangle_count"]

    def at(self, matrices):
        """This part at several places, [n][4][4]: one part, or two if some of the places are mirrored."""
        placed = matrices @ self.local
        mirrored = np.linalg.det(placed[:, :3, :3]) < 0
        made = []
        for group in (placed[~mirrored], placed[mirrored]):
            if len(group):
                made.append(copy.copy(self))
                made[-1].local, made[-1].instances = np.eye(4), group
                made[-1].corners = np.moveaxis(group @ self.corners, 1, 0).reshape(4, -1)
        return made

    def draw(self, pose, **values):
        """A draw at a pose. Culling is that of the surface: mirrors turn the winding of its triangles."""
        placed = pose @ self.local
        made = {"mesh": self.mesh, "object_to_world": placed.astype(np.float32), "compare": "greater", **self.values,
                **values}
        if self.instances is not None:
            made["instances"] = (placed @ self.instances).astype(np.float32)
            placed = placed @ self.instances[0]
        if np.linalg.det(placed[:3, :3]) < 0:
            cull = enum_value("shd_cull", made.get("cull", "none"), "cull")
            made["cull"] = {1: "front", 2: "back"}.get(int(cull), cull)
        return desc_type("shd_draw")(**made)


def from_arrays(context, position, indices=None, normal=None, uv=None, color=None, texture=None, material=None,
                cull="none", local=None, shows_codes=False, **values):
    """A part from arrays. `color` is one colour, or one for each vertex: integers are sRGB codes, floats are linear.
    `shows_codes` is that of its Look."""
    position = floats(position, 3, "position")
    columns = {name: floats(value, width, name) for name, value, width in (("normal", normal, 3), ("uv", uv, 2))
               if value is not None}
    for name, column in columns.items():
        if len(column) != len(position):
            raise ValueError(f"{name}: {len(column)} rows, not {len(position)}")
    if indices is not None:
        columns["indices"] = triangles(indices, len(position), "indices")
    rgba = None if color is None else linear_color(color)
    if rgba is not None and rgba.ndim == 2:
        if len(rgba) != len(position):
            raise ValueError(f"color: {len(rgba)} rows, not {len(position)}")
        if texture is not None:
            raise ValueError("color: one colour if there is a texture, not one for each vertex")
        coded = [np.append(decode(rgba[:, :3]), rgba[:, 3:], axis=1)] if shows_codes else []
        columns["attributes"] = list(np.ascontiguousarray(np.concatenate([rgba, *coded], axis=1).T, np.float32))
    if any(target == "normal" for target, *_ in values.get("maps", ())):
        columns["flags"] = "tangents"
    if material is None:
        material = _look(context, rgba, texture, values)
        material.shows_codes, material.has_codes = shows_codes, shows_codes and "attributes" in columns
    elif values:
        raise TypeError(f"add: {', '.join(values)} cannot change a material")
    else:
        material = Fixed(material)
    return Part(Mesh(context, position, **columns), material, local, {"cull": cull})


def _look(context, rgba, texture, values):
    per_vertex = rgba is not None and rgba.ndim == 2
    if per_vertex and (rgba[:, 3] < 1).any():
        values.setdefault("blend", "sorted")
    return make_look(context, None if per_vertex else rgba, texture, per_vertex, **values)


def from_trimesh(context, item, smooth=True, material=None, local=None, **values):
    """A part from an object like trimesh.Trimesh: vertices, faces, vertex_normals and visual."""
    position = floats(item.vertices, 3, "vertices")
    faces = triangles(item.faces, len(position), "faces")
    kind, columns, own = surface_of(item)
    columns.update(position=position, normal=getattr(item, "vertex_normals", None) if smooth else None)
    if not smooth or kind == "face":
        columns = unshared(columns, faces, kind)
    else:
        columns["indices"] = faces
    options = {} if own is None or material is not None else options_of(own)
    if "uv" in columns:
        columns["uv"] = columns["uv"] * (1.0, -1.0) + (0.0, 1.0)  # v of trimesh grows upwards
    elif options:  # textures have no place
        options.update(texture=None, maps=[])
    if material is not None:
        columns.pop("color", None)
    return from_arrays(context, **{**columns, **options, **values}, material=material, local=local)


def parts_of(context, item, **values):
    """The parts of an object: a mesh of trimesh, a scene of trimesh, or a Mesh of shd with a material."""
    if isinstance(item, Mesh):
        material = values.pop("material", None)
        return [Part(item, make_look(context, **values) if material is None else Fixed(material))]
    if hasattr(item, "vertices") and hasattr(item, "faces"):
        return [from_trimesh(context, item, **values)]
    if hasattr(item, "geometry") and hasattr(item, "graph"):
        parts = []
        for node in item.graph.nodes_geometry:
            local, name = item.graph[node]
            if hasattr(item.geometry[name], "faces"):
                parts.append(from_trimesh(context, item.geometry[name], local=matrix(local, f"graph[{node!r}]"),
                                          **values))
        return parts
    raise TypeError(f"add: a mesh or scene of trimesh, a path, a Mesh or arrays, not {type(item).__name__}")


def from_scene(context, scene, **values):
    """The parts of a model file. Options are those of file_look()."""
    looks = [file_look(context, desc, **values) for desc in scene.material_descs]
    meshes = scene.meshes
    return [Part(meshes[i.mesh], looks[i.material], np.float64(i.object_to_world),
                 {"cull": "back" if int(i.cull) else "none"}) for i in scene.instances]
