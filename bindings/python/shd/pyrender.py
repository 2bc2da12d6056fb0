# SPDX-License-Identifier: MIT
"""The interface of pyrender for offscreen pictures, so that its programs run without OpenGL.

    import shd.pyrender as pyrender

Classes and arguments have pyrender's names. Lights have its units: a SpotLight or PointLight of intensity I gives the
irradiance I / r^2. Materials of OBJ files are rough metals, and colours of vertices are linear, as in pyrender.
Differences: light falls off at the edge of a spot as in shd/light.h, and colours have the piecewise sRGB curve. There
is no Viewer. load() reads model files by libshd_scene.
"""
import copy
import functools
import threading

import numpy as np

from ._camera import matrix
from ._material import Fixed, options_of
from ._model import floats, from_arrays, from_scene, from_trimesh
from ._nodes import (Camera, DirectionalLight, IntrinsicsCamera, Light, Node, OrthographicCamera, PerspectiveCamera,
                     PointLight, Scene, SpotLight)
from ._objects import Context
from .renderer import Item, Renderer, exclusive

__all__ = ["Camera", "DirectionalLight", "IntrinsicsCamera", "Light", "Mesh", "MetallicRoughnessMaterial", "Model",
           "Node", "OffscreenRenderer", "OrthographicCamera", "PerspectiveCamera", "PointLight", "Primitive",
           "RenderFlags", "Scene", "SpotLight", "load"]
POINTS, TRIANGLES = 0, 4
# Meshes without a material are grey; colours of vertices and faces replace the grey.
GREY, WHITE = ({"diffuse": (base,) * 3, "metallic": 0.2, "roughness": 0.8} for base in (0.3, 1.0))


class RenderFlags:
    """Options of OffscreenRenderer.render(); combine with |."""

    NONE = 0
    DEPTH_ONLY = 1
    OFFSCREEN = 2
    FLIP_WIREFRAME = 4
    ALL_WIREFRAME = 8
    ALL_SOLID = 16
    SHADOWS_DIRECTIONAL = 32
    SHADOWS_POINT = 64
    SHADOWS_SPOT = 128
    SHADOWS_ALL = 224
    VERTEX_NORMALS = 256
    FACE_NORMALS = 512
    SKIP_CULL_FACES = 1024
    RGBA = 2048
    FLAT = 4096
    SEG = 8192


UNSUPPORTED = RenderFlags.VERTEX_NORMALS | RenderFlags.FACE_NORMALS
SHADOWS = {"directional": RenderFlags.SHADOWS_DIRECTIONAL, "point": RenderFlags.SHADOWS_POINT,
           "spot": RenderFlags.SHADOWS_SPOT}


@functools.lru_cache(maxsize=None)
def _context():
    """The context of all meshes of this module."""
    return Context()


class MetallicRoughnessMaterial:
    """Factors and textures of glTF's metallic-roughness."""

    def __init__(self, name=None, normalTexture=None, occlusionTexture=None, emissiveTexture=None, emissiveFactor=None,
                 alphaMode="OPAQUE", alphaCutoff=None, doubleSided=False, smooth=True, wireframe=False,
                 baseColorFactor=None, baseColorTexture=None, metallicFactor=1.0, roughnessFactor=1.0,
                 metallicRoughnessTexture=None):
        values = dict(locals())
        del values["self"]
        self.__dict__.update({k: getattr(v, "source", v) for k, v in values.items()})


def _options(material):
    """Options of a part from a MetallicRoughnessMaterial, or the grey of meshes without one."""
    if material is None:
        return {**GREY, "cull": "back"}, "solid"
    return ({**options_of(material), "cull": "none" if getattr(material, "doubleSided", False) else "back"},
            "wireframe" if getattr(material, "wireframe", False) else "solid")


class Primitive:
    """Triangles or points with a material. Arrays are copied."""

    def __init__(self, positions, normals=None, tangents=None, texcoord_0=None, texcoord_1=None, color_0=None,
                 indices=None, material=None, mode=TRIANGLES, poses=None):
        if mode not in (TRIANGLES, POINTS):
            raise ValueError(f"mode: {mode} is neither {TRIANGLES}, triangles, nor {POINTS}, points")
        self.material, self.mode = material, mode
        options, fill = _options(material)
        if material is None and color_0 is not None:
            options.update(WHITE)
        if mode == POINTS:  # a point is a triangle without area
            count = len(floats(positions, 3, "positions"))
            indices, fill, options["cull"] = np.repeat(np.arange(count), 3), "points", "none"
        if texcoord_0 is None:
            options.update(texture=None, maps=[])
        elif color_0 is not None and options.get("texture") is not None:
            color_0 = None  # a slot has one source
        part = from_arrays(_context(), positions, indices, normals,
                           None if texcoord_0 is None else np.asarray(texcoord_0)[:, :2] * (1, -1) + (0, 1),
                           **_with_color(options, color_0))
        part.values["fill"] = fill
        if mode == POINTS and normals is None:
            part.look = Fixed(part.look.flat)
        self.parts = _placed([part], poses)


def _with_color(options, color_0):
    """Options with colours of vertices, which are linear and multiply the colour of the material."""
    if color_0 is None:
        return options
    colors = np.asarray(color_0)
    base = options.pop("color", None)
    if base is not None:
        options["diffuse"] = np.asarray(base, np.float64)[:3]
    return {**options, "color": colors / 255 if colors.dtype.kind in "iu" else colors}


def _placed(parts, poses):
    """Copies of parts at each of the poses."""
    if poses is None:
        return parts
    made = []
    for i, pose in enumerate(poses):
        for part in parts:
            made.append(copy.copy(part))
            made[-1].local = matrix(pose, f"poses[{i}]") @ part.local
    return made


class Model:
    """The triangles of a model file, for Mesh.from_trimesh(). `warnings` are those of the file."""

    def __init__(self, source, **values):
        from .scene import Scene as File
        scene = File(_context(), source, **values)
        self.parts, self.warnings = from_scene(_context(), scene, metallic=1.0), scene.warnings

    bounds = property(lambda self: _bounds(self.parts))
    extents = property(lambda self: np.diff(self.bounds, axis=0).reshape(-1))
    centroid = property(lambda self: self.bounds.mean(axis=0))
    scale = property(lambda self: float(np.linalg.norm(self.extents)))


def load(source, **values):
    """A model file of any format that libshd_scene reads, or its bytes. Options are those of shd.Scene."""
    return Model(source, **values)


def _corners(parts):
    return [corner for part in parts for corner in (part.local @ part.corners)[:3].T]


def _bounds(parts):
    corners = _corners(parts)
    return np.array([np.min(corners, axis=0), np.max(corners, axis=0)]) if corners else np.zeros((2, 3))


class Mesh:
    """Primitives that are drawn together."""

    def __init__(self, primitives, name=None, weights=None, is_visible=True):
        self.primitives, self.name, self.is_visible = list(primitives), name, is_visible

    @property
    def parts(self):
        return [part for primitive in self.primitives for part in primitive.parts]

    def corners(self):
        """Corners of the bounds of the parts."""
        return _corners(self.parts)

    bounds = property(lambda self: _bounds(self.parts))
    extents = property(lambda self: np.diff(self.bounds, axis=0).reshape(-1))
    centroid = property(lambda self: self.bounds.mean(axis=0))
    scale = property(lambda self: float(np.linalg.norm(self.extents)))

    @staticmethod
    def from_points(points, colors=None, normals=None, is_visible=True, poses=None):
        """Points, drawn as squares of OffscreenRenderer.point_size pixels; without normals they show their colours."""
        return Mesh([Primitive(points, normals, color_0=colors, mode=POINTS, poses=poses)], is_visible=is_visible)

    @staticmethod
    def from_trimesh(mesh, material=None, is_visible=True, poses=None, wireframe=False, smooth=True):
        """A mesh from one or several objects like trimesh.Trimesh, or from a Model of load()."""
        primitives = []
        for each in mesh if isinstance(mesh, (list, tuple, set)) else [mesh]:
            made = Primitive.__new__(Primitive)
            made.material, made.mode = material, TRIANGLES
            if isinstance(each, Model):
                parts = [copy.copy(part) for part in each.parts]
            else:
                parts = [_part(each, material, smooth)]
            for part in parts:
                part.values = {"cull": "back", **part.values, **({"fill": "wireframe"} if wireframe else {})}
            made.parts = _placed(parts, poses)
            primitives.append(made)
        return Mesh(primitives, is_visible=is_visible)


def _trimesh_options(item):
    """Options of from_trimesh() by the `visual` of a mesh of trimesh."""
    visual = getattr(item, "visual", None)
    kind = getattr(visual, "kind", None)
    if kind != "texture":
        return {"cull": "back", **(WHITE if kind in ("vertex", "face") else GREY)}
    options, color = options_of(visual.material), getattr(visual.material, "diffuse", None)
    if not hasattr(visual.material, "baseColorTexture"):
        options.update(metallic=1.0, color=None if color is None else np.asarray(color) / 255)
    return {"replace": options, "cull": "none" if getattr(visual.material, "doubleSided", False) else "back"}


def _part(item, material, smooth):
    """A part from a mesh of trimesh."""
    if not hasattr(item, "vertices") or not hasattr(item, "faces"):
        raise TypeError(f"from_trimesh: vertices and faces, or a Model, not {type(item).__name__}")
    if material is None:
        return from_trimesh(_context(), item, smooth, linear_codes=True, **_trimesh_options(item))
    options, fill = _options(material)
    part = from_trimesh(_context(), item, smooth, replace=options)
    part.values["fill"] = fill
    return part


class OffscreenRenderer:
    """Renders scenes into arrays. The framebuffer is kept between frames; delete() drops it."""

    def __init__(self, viewport_width, viewport_height, point_size=1.0):
        self._renderer = Renderer(int(viewport_width), int(viewport_height), context=_context())
        self._size, self._lock = (int(viewport_width), int(viewport_height)), threading.Lock()
        self.viewport_width, self.viewport_height, self.point_size = *self._size, point_size

    def _require_open(self):
        if self._renderer is None:
            raise ValueError("renderer: it was deleted")

    @exclusive
    def render(self, scene, flags=RenderFlags.NONE, seg_node_map=None):
        """Colour [height][width][3] of uint8 (4 with RGBA), and depth [height][width] of float32 [world units].

        Depth is 0 in the background. DEPTH_ONLY gives depth alone; SEG gives the colours of `seg_node_map`, by nodes.
        """
        if flags & UNSUPPORTED:
            raise ValueError(f"flags: {flags & UNSUPPORTED} is not supported")
        if scene.main_camera_node is None:
            raise ValueError("scene: it has no camera")
        renderer = self._prepare(scene, flags, seg_node_map)
        values = {"cull": "none"} if flags & (RenderFlags.SKIP_CULL_FACES | RenderFlags.SEG) else {}
        if flags & RenderFlags.ALL_SOLID:
            values["fill"] = "solid"
        if flags & RenderFlags.ALL_WIREFRAME:
            values["fill"] = "wireframe"
        if flags & RenderFlags.DEPTH_ONLY:
            return renderer.render_depth(**values)
        if flags & RenderFlags.SEG:
            return self._segments(scene, seg_node_map, values)
        return renderer.render(alpha=bool(flags & RenderFlags.RGBA), flat=bool(flags & RenderFlags.FLAT),
                               shadows=[kind for kind, flag in SHADOWS.items() if flags & flag], **values)

    def _prepare(self, scene, flags, seg_node_map):
        """Puts the models, lights and camera of a scene into the renderer."""
        renderer, size = self._renderer, (int(self.viewport_width), int(self.viewport_height))
        if size != self._size:
            renderer.resize(*size)
            self._size = size
        renderer.items = [Item(self._parts(node.mesh.parts, flags), pose) for node, pose in scene.placed("mesh")
                          if self._is_drawn(node, flags, seg_node_map)]
        renderer.lights = []
        for node, pose in scene.placed("light"):
            renderer.add_light(pose=pose, **node.light.options())
        renderer.ambient = scene.ambient_light
        renderer.background = scene.bg_color if flags & RenderFlags.RGBA else scene.bg_color[:3]
        camera = scene.main_camera_node
        renderer.look_from(scene.get_pose(camera), lens=camera.camera.lens())
        return renderer

    @staticmethod
    def _is_drawn(node, flags, seg_node_map):
        return node.mesh.is_visible and not (flags & RenderFlags.SEG and node not in (seg_node_map or {}))

    def _parts(self, parts, flags):
        """Copies of parts with the size of points, and with wireframes where they are flipped."""
        flipped = {"solid": "wireframe", "wireframe": "solid"} if flags & RenderFlags.FLIP_WIREFRAME else {}
        made = [copy.copy(part) for part in parts]
        for part in made:
            fill = part.values.get("fill", "solid")
            part.values = {**part.values, "fill": flipped.get(fill, fill)}
            if fill == "points":
                part.values["fill_width"] = self.point_size
        return made

    def _segments(self, scene, seg_node_map, values):
        nodes = [node for node, _ in scene.placed("mesh") if self._is_drawn(node, RenderFlags.SEG, seg_node_map)]
        table = np.zeros((len(nodes) + 1, 3), np.uint8)  # the last row is the background
        for row, node in zip(table, nodes):
            row[:] = seg_node_map[node]
        return table[self._renderer.render_ids(**values)], self._renderer.render_depth(**values)

    def delete(self):
        """Drops the framebuffer; later renders raise ValueError."""
        if self._renderer is not None:
            self._renderer.close()
        self._renderer = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.delete()
