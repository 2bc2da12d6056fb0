# SPDX-License-Identifier: MIT
"""Meshes and primitives of shd.pyrender. Arrays are copied to shd at the first picture after a change."""
import copy
import functools

import numpy as np

from .._array import array_of, check_range, converted
from .._camera import matrix
from .._material import Fixed
from .._model import corners_of, floats, from_arrays
from .._objects import Context
from .._trimesh import surface_of, unshared
from ._checked import Boxed, Checked, Shown, anything, bounds_of, face_normals, instance_of, text, unit
from .constants import GLTF
from .material import Material, MetallicRoughnessMaterial, default_material, material_of

LINE_COLOR = (0.1, 0.1, 1.0)  # of normals
MODES = ("POINTS", "LINES", "LINE_LOOP", "LINE_STRIP", "TRIANGLES", "TRIANGLE_STRIP", "TRIANGLE_FAN")
LINE_LENGTH = 0.05            # of normals, as a part of the scale of their primitive


@functools.lru_cache(maxsize=None)
def context():
    """The context of all meshes of this module."""
    return Context()


def rows(*widths, optional=True, like_positions=True):
    """Arrays [n][width] of float32, of one of some widths, with a row for each position."""
    def check(primitive, value, name):
        if value is None and optional:
            return None
        array = np.array(converted(value, np.dtype("f4"), name), order="C")  # the caller keeps its own
        if not array.size and not like_positions:
            return array.reshape(-1, widths[0])
        count = len(primitive.positions) if like_positions else len(array)
        if array.ndim != 2 or array.shape[1] not in widths or len(array) != count:
            wanted = f"[{count if like_positions else 'n'}][{' or '.join(map(str, widths))}]"
            raise ValueError(f"{name}: an array of shape {array.shape}, not {wanted}")
        return array
    return check


def colors(primitive, value, name):
    """Linear colours of vertices [n][4]; integers are 0..255. One colour is that of all vertices."""
    if value is None:
        return None
    array = array_of(value, name)
    array = np.asarray(array / 255 if array.dtype.kind in "iu" else array, np.float32)
    array = np.tile(array, (len(primitive.positions), 1)) if array.ndim == 1 else array
    array = rows(3, 4)(primitive, array, name)
    return array if array.shape[1] == 4 else np.append(array, np.ones((len(array), 1), np.float32), axis=1)


def vertices(primitive, value, name):
    """Numbers of vertices."""
    if value is None:
        return None
    array = array_of(value, name)
    if array.size and array.dtype.kind not in "iu":
        raise TypeError(f"{name}: integers, not {array.dtype}")
    check_range(array, len(primitive.positions) - 1, name)
    return array.astype(np.int64)


def matrices(_, value, name):
    if value is None:
        return None
    array = np.asarray(value)
    array = array[np.newaxis] if array.ndim == 2 else array
    return np.array([matrix(pose, f"{name}[{i}]") for i, pose in enumerate(array)]).reshape(-1, 4, 4)


def material_or_default(primitive, value, name):
    return instance_of(Material, "a Material")(primitive, value, name) or MetallicRoughnessMaterial()


def mode_of(_, value, name):
    made = GLTF.TRIANGLES if value is None else int(value)
    if not GLTF.POINTS <= made <= GLTF.TRIANGLE_FAN:
        raise ValueError(f"{name}: {made} is not in 0..6, the modes of GLTF")
    return made


class Primitive(Boxed, Shown):
    """Points, lines or triangles with a material."""

    positions = Checked(rows(3, optional=False, like_positions=False), "[n][3]")
    normals = Checked(rows(3), "[n][3]")
    tangents = Checked(rows(4), "[n][4], kept for programs; shd makes its own from texcoord_0.")
    texcoord_0 = Checked(rows(2, 3, 4), "[n][2], v upwards.")
    texcoord_1 = Checked(rows(2, 3, 4), "[n][2], kept for programs.")
    color_0 = Checked(colors, "Linear colours [n][4].")
    joints_0 = Checked(anything, "Kept for programs.")
    weights_0 = Checked(anything, "Kept for programs.")
    indices = Checked(vertices, "Numbers of vertices; None for all of them in order.")
    material = Checked(material_or_default, "A Material; None is a white metal.")
    mode = Checked(mode_of, "One of the modes of GLTF.")
    targets = Checked(anything, "Kept for programs.")
    poses = Checked(matrices, "Poses of copies [x][4][4].")

    def __init__(self, positions, normals=None, tangents=None, texcoord_0=None, texcoord_1=None, color_0=None,
                 joints_0=None, weights_0=None, indices=None, material=None, mode=None, targets=None, poses=None):
        self.mode, self.positions, self.normals, self.tangents = mode, positions, normals, tangents
        self.texcoord_0, self.texcoord_1, self.color_0 = texcoord_0, texcoord_1, color_0
        self.joints_0, self.weights_0, self.indices, self.targets = joints_0, weights_0, indices, targets
        self.material, self.poses = material, poses
        self._made = None  # versions of what the parts were made from, and the parts

    @property
    def bounds(self):
        """Lowest and highest x, y, z of all copies."""
        own = bounds_of(self.positions.astype(np.float64))
        if self.poses is None or not len(self.positions):
            return own
        placed = corners_of(own) @ self.poses[:, :3, :3].swapaxes(1, 2) + self.poses[:, np.newaxis, :3, 3]
        return bounds_of(placed.reshape(-1, 3))

    @property
    def is_transparent(self):
        """Whether the material or a colour lets light through."""
        return self.material.is_transparent or (self.color_0 is not None and bool((self.color_0[:, 3] < 1).any()))

    def _texts(self):
        copies = [] if self.poses is None else [f"{len(self.poses)} poses"]
        return [MODES[self.mode], f"{len(self.positions)} vertices", *copies]

    def __getstate__(self):  # of copies and pickles, which make parts of their own
        return {**self.__dict__, "_made": None}

    def versions(self):
        return self.version, self.material.versions()

    def keep_part(self, part):
        """Draws a part that has the same contents, until the primitive changes."""
        self._made = self.versions(), self._placed([part])

    @property
    def parts(self):
        """The parts for the renderer of shd."""
        if self._made is None or self._made[0] != self.versions():
            self._made = self.versions(), self._placed([self._part()] if len(self.positions) else [])
        return self._made[1]

    def _placed(self, parts):
        """Copies of parts at each of the poses."""
        return parts if self.poses is None else [placed for part in parts for placed in part.at(self.poses)]

    def _corners(self):
        """Numbers of vertices of triangles, and their fill. Points and lines are triangles without area."""
        flat = np.arange(len(self.positions)) if self.indices is None else self.indices.reshape(-1)
        if self.mode == GLTF.POINTS:
            return flat.repeat(3), "points"
        if self.mode in (GLTF.LINES, GLTF.LINE_STRIP, GLTF.LINE_LOOP):
            pairs = flat[:len(flat) // 2 * 2].reshape(-1, 2)
            if self.mode != GLTF.LINES:
                ends = np.roll(flat, -1) if self.mode == GLTF.LINE_LOOP else flat[1:]
                pairs = np.stack([flat[:len(ends)], ends], axis=1)
            return pairs[:, (0, 1, 1)], "wireframe"
        fill = "wireframe" if self.material.wireframe else "solid"
        if self.mode == GLTF.TRIANGLES:
            return flat[:len(flat) // 3 * 3], fill
        if len(flat) < 3:
            return flat[:0], fill
        if self.mode == GLTF.TRIANGLE_FAN:
            return np.stack([np.full(len(flat) - 2, flat[0]), flat[1:-1], flat[2:]], axis=1), fill
        strip = np.stack([flat[:-2], flat[1:-1], flat[2:]], axis=1)
        strip[1::2, :2] = strip[1::2, 1::-1]  # every second triangle has the other winding
        return strip, fill

    def _part(self):
        options, (corners, fill) = self.material.options(), self._corners()
        uv = None if self.texcoord_0 is None else self.texcoord_0[:, :2] * (1, -1) + (0, 1)
        if uv is None:
            options.update(texture=None, maps=[])
        if self.color_0 is not None and options["texture"] is None:  # a slot has one source
            options["diffuse"] = options.pop("color")[:3]
            options["color"] = self.color_0.astype(np.float64)
            if self.is_transparent and options.get("alpha_cutoff") is None and self.material.alphaMode != "OPAQUE":
                options["blend"] = "sorted"
        is_solid = self.mode >= GLTF.TRIANGLES
        cull = "none" if self.material.doubleSided or not is_solid else "back"
        part = from_arrays(context(), self.positions, corners, self.normals, uv, cull=cull, shows_codes=True, **options)
        part.values["fill"] = fill
        if not is_solid and self.normals is None:
            part.look = Fixed(part.look.flat)
        return part

    def normal_lines(self, of_faces):
        """Parts that show the normals of vertices or of faces as lines."""
        if not len(self.positions) or self.mode < GLTF.TRIANGLES:
            return []
        corners = self.positions[self._corners()[0]].reshape(-1, 3, 3)
        across = face_normals(corners)
        if of_faces:
            start, along = corners.mean(axis=1), across
        elif self.normals is None:
            start, along = corners.reshape(-1, 3), across.repeat(3, axis=0)
        else:
            start, along = self.positions, self.normals
        if not len(start):
            return []
        ends = start + LINE_LENGTH * np.linalg.norm(np.ptp(self.positions, axis=0)) * unit(along)
        numbers = np.arange(len(start))[:, np.newaxis] + (0, len(start), len(start))
        part = from_arrays(context(), np.concatenate([start, ends]), numbers, color=LINE_COLOR, shows_codes=True)
        part.values["fill"], part.look = "wireframe", Fixed(part.look.flat)
        return self._placed([part])


class Mesh(Boxed, Shown):
    """Primitives that are drawn together."""

    name = Checked(text)

    def __init__(self, primitives, name=None, weights=None, is_visible=True):
        self.primitives, self.name, self.weights, self.is_visible = list(primitives), name, weights, is_visible

    @property
    def parts(self):
        return [part for primitive in self.primitives for part in primitive.parts]

    @property
    def bounds(self):
        """Lowest and highest x, y, z of all primitives."""
        found = [p.bounds for p in self.primitives if len(p.positions)]
        return bounds_of(np.concatenate(found)) if found else np.zeros((2, 3))

    def _texts(self):
        return [*super()._texts(), f"{len(self.primitives)} primitives"]

    @property
    def is_transparent(self):
        """Whether a primitive lets light through."""
        return any(p.is_transparent for p in self.primitives)

    @staticmethod
    def from_points(points, colors=None, normals=None, is_visible=True, poses=None):
        """Points, drawn as squares of OffscreenRenderer.point_size pixels; without normals they show their colours."""
        return Mesh([Primitive(points, normals, color_0=colors, mode=GLTF.POINTS, poses=poses)], is_visible=is_visible)

    @staticmethod
    def from_trimesh(mesh, material=None, is_visible=True, poses=None, wireframe=False, smooth=True):
        """A mesh from one or several objects like trimesh.Trimesh, or from a Model of load()."""
        made = []
        for each in mesh if isinstance(mesh, (list, tuple, set, np.ndarray)) else [mesh]:
            if hasattr(each, "primitives"):
                made += each.primitives(material, poses, wireframe, smooth)
            elif hasattr(each, "vertices") and hasattr(each, "faces"):
                made.append(_primitive(each, material, poses, wireframe, smooth))
            else:
                raise TypeError(f"from_trimesh: vertices and faces, or a Model, not {type(each).__name__}")
        return Mesh(made, is_visible=is_visible)


def _primitive(item, material, poses, wireframe, smooth):
    """A primitive from a mesh of trimesh."""
    kind, columns, own = surface_of(item)
    if kind == "face" and smooth:
        raise ValueError("from_trimesh: smooth is True, but colours of faces need smooth=False")
    if material is not None:
        columns.pop("color", None)
        made = copy.copy(material)
    else:
        made = copy.copy(material_of(own)) if own is not None else default_material(has_colors=kind is not None)
    made.wireframe = wireframe or (material is not None and material.wireframe)
    positions, faces = floats(item.vertices, 3, "vertices"), np.asarray(item.faces)
    check_range(faces, len(positions) - 1, "faces")
    columns.update(position=positions, normal=getattr(item, "vertex_normals", None) if smooth else None)
    if not smooth:
        columns = unshared(columns, faces, kind)
    return Primitive(columns["position"], columns.get("normal"), texcoord_0=columns.get("uv"),
                     color_0=columns.get("color"), indices=faces if smooth else None, material=made, poses=poses)
