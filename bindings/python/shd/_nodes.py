# SPDX-License-Identifier: MIT
"""Nodes, cameras and lights of shd.pyrender."""
import numpy as np

from . import _camera
from ._camera import matrix

NEAR, FAR = 0.05, 100.0


def color(value, count, name):
    """A colour of 3 or 4 numbers 0..1; integers are 0..255."""
    array = np.asarray(value)
    if array.dtype.kind not in "fiu" or array.ndim != 1 or not 3 <= array.size <= count:
        raise ValueError(f"{name}: {count} numbers, not {value}")
    made = np.ones(count)
    made[:array.size] = array / 255 if array.dtype.kind in "iu" and array.max() > 1 else array
    return made


class Camera:
    """Base of the cameras, which look along the -z axis of their node."""

    def __init__(self, znear=NEAR, zfar=FAR, name=None):
        self.znear, self.zfar, self.name = znear, zfar, name

    def lens(self):
        raise NotImplementedError


class PerspectiveCamera(Camera):
    """A camera with a vertical field of view [rad]; without zfar it has no far plane."""

    def __init__(self, yfov, znear=NEAR, zfar=None, aspectRatio=None, name=None):
        super().__init__(znear, zfar, name)
        self.yfov, self.aspectRatio = yfov, aspectRatio
        self.lens()  # checks the values

    def lens(self):
        return _camera.perspective(self.yfov, self.aspectRatio, self.znear, self.zfar)


class OrthographicCamera(Camera):
    """A parallel projection; ymag is half of the height of the picture, whose aspect decides the width."""

    def __init__(self, xmag, ymag, znear=NEAR, zfar=FAR, name=None):
        super().__init__(znear, zfar, name)
        self.xmag, self.ymag = xmag, ymag
        self.lens()

    def lens(self):
        return _camera.orthographic(self.ymag, self.znear, self.zfar)


class IntrinsicsCamera(Camera):
    """A pinhole camera by focal lengths and principal point [pixels]."""

    def __init__(self, fx, fy, cx, cy, znear=NEAR, zfar=FAR, name=None):
        super().__init__(znear, zfar, name)
        self.fx, self.fy, self.cx, self.cy = fx, fy, cx, cy
        self.lens()

    def lens(self):
        return _camera.intrinsics(self.fx, self.fy, self.cx, self.cy, self.znear, self.zfar)


class Light:
    """Base of the lights, which shine along the -z axis of their node."""

    kind = ""

    def __init__(self, color=None, intensity=None, name=None):
        self.color = (1.0, 1.0, 1.0) if color is None else color
        self.intensity = 1.0 if intensity is None else float(intensity)
        self.name = name

    def options(self):
        """Options of Renderer.add_light()."""
        return {"kind": self.kind, "color": color(self.color, 3, "color"), "intensity": self.intensity}


class DirectionalLight(Light):
    """A light from afar, of irradiance `intensity`."""

    kind = "directional"


class PointLight(Light):
    """A light at a point: its irradiance at distance r is `intensity` / r^2."""

    kind = "point"

    def __init__(self, color=None, intensity=None, range=None, name=None):
        super().__init__(color, intensity, name)
        self.range = range

    def options(self):
        return {**super().options(), "range": self.range or 0.0}


class SpotLight(PointLight):
    """A light at a point with a cone."""

    kind = "spot"

    def __init__(self, color=None, intensity=None, range=None, innerConeAngle=0.0, outerConeAngle=np.pi / 4, name=None):
        super().__init__(color, intensity, range, name)
        if not 0 <= innerConeAngle <= outerConeAngle <= np.pi / 2 + 1e-9:
            raise ValueError(f"innerConeAngle {innerConeAngle} and outerConeAngle {outerConeAngle} are not in order "
                             "within 0..pi/2")
        self.innerConeAngle, self.outerConeAngle = innerConeAngle, outerConeAngle

    def options(self):
        outer = min(self.outerConeAngle, 1.5707)
        return {**super().options(), "inner_angle": min(self.innerConeAngle, outer), "outer_angle": outer}


def rotation_matrix(quaternion):
    """The rotation of a quaternion x, y, z, w."""
    x, y, z, w = np.asarray(quaternion, np.float64) / np.linalg.norm(quaternion)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


class Node:
    """A place in a scene: node to parent, with a mesh, a light or a camera."""

    def __init__(self, name=None, camera=None, children=None, matrix=None, mesh=None, rotation=None, scale=None,
                 translation=None, light=None):
        self.name, self.camera, self.mesh, self.light = name, camera, mesh, light
        self.children = list(children or [])
        made = np.eye(4)
        if rotation is not None:
            made[:3, :3] = rotation_matrix(rotation)
        if scale is not None:
            made[:3, :3] = made[:3, :3] * scale
        if translation is not None:
            made[:3, 3] = translation
        self.matrix = made if matrix is None else matrix

    @property
    def matrix(self):
        return self._matrix

    @matrix.setter
    def matrix(self, value):
        self._matrix = matrix(value, "matrix")

    @property
    def translation(self):
        return self._matrix[:3, 3]

    @translation.setter
    def translation(self, value):
        self._matrix[:3, 3] = value


class Scene:
    """A tree of nodes with meshes, lights and cameras. The first camera is the main camera."""

    def __init__(self, nodes=None, bg_color=None, ambient_light=None, name=None):
        self.bg_color = np.ones(4) if bg_color is None else bg_color
        self.ambient_light = np.zeros(3) if ambient_light is None else ambient_light
        self.name = name
        self.clear()
        children = {id(child) for node in nodes or () for child in node.children}
        for node in nodes or ():
            if id(node) not in children:
                self.add_node(node)

    def clear(self):
        """Removes all nodes."""
        self._parents, self.main_camera_node = {}, None  # in the order of their addition

    @property
    def bg_color(self):
        return self._bg_color

    @bg_color.setter
    def bg_color(self, value):
        self._bg_color = color(value, 4, "bg_color")

    @property
    def ambient_light(self):
        return self._ambient_light

    @ambient_light.setter
    def ambient_light(self, value):
        self._ambient_light = color(value, 4, "ambient_light")[:3]

    @property
    def nodes(self):
        return set(self._parents)

    def _having(self, name):
        return [node for node in self._parents if getattr(node, name) is not None]

    mesh_nodes = property(lambda self: set(self._having("mesh")))
    light_nodes = property(lambda self: set(self._having("light")))
    camera_nodes = property(lambda self: set(self._having("camera")))
    meshes = property(lambda self: {node.mesh for node in self._having("mesh")})
    lights = property(lambda self: {node.light for node in self._having("light")})
    cameras = property(lambda self: {node.camera for node in self._having("camera")})

    def placed(self, name):
        """The nodes with a mesh, a light or a camera, in the order of their addition, and their poses."""
        return [(node, self.get_pose(node)) for node in self._having(name)]

    def add(self, obj, name=None, pose=None, parent_node=None, parent_name=None):
        """Adds a mesh, a light or a camera, and returns its node."""
        kinds = {"light": isinstance(obj, Light), "camera": isinstance(obj, Camera),
                 "mesh": hasattr(obj, "primitives")}
        kind = next((k for k, fits in kinds.items() if fits), None)
        if kind is None:
            raise TypeError(f"add: a Mesh, Light or Camera, not {type(obj).__name__}")
        if parent_name is not None and parent_node is None:
            found = self.get_nodes(name=parent_name)
            if len(found) != 1:
                raise ValueError(f"parent_name: {len(found)} nodes have the name {parent_name!r}")
            parent_node = next(iter(found))
        node = Node(name=name, matrix=pose, **{kind: obj})
        self.add_node(node, parent_node)
        return node

    def add_node(self, node, parent_node=None):
        """Adds a node with its children."""
        if node in self._parents:
            raise ValueError("node: it is in the scene")
        if parent_node is not None:
            self._require(parent_node)
            if node not in parent_node.children:
                parent_node.children.append(node)
        self._parents[node] = parent_node
        if node.camera is not None and self.main_camera_node is None:
            self.main_camera_node = node
        for child in node.children:
            self.add_node(child, node)

    def remove_node(self, node):
        """Removes a node with its children."""
        self._require(node)
        parent = self._parents[node]
        if parent is not None:
            parent.children.remove(node)
        self._remove(node)

    def _remove(self, node):
        del self._parents[node]
        if node is self.main_camera_node:
            self.main_camera_node = next(iter(self._having("camera")), None)
        for child in node.children:
            self._remove(child)

    def _require(self, node):
        if node not in self._parents:
            raise ValueError("node: it is not in the scene")

    def has_node(self, node):
        return node in self._parents

    def get_nodes(self, node=None, name=None, obj=None, obj_name=None):
        """The nodes that match all arguments."""
        found = set()
        for each in self._parents:
            objects = [o for o in (each.mesh, each.light, each.camera) if o is not None]
            if ((node is None or each is node) and (name is None or each.name == name)
                    and (obj is None or obj in objects)
                    and (obj_name is None or obj_name in [o.name for o in objects])):
                found.add(each)
        return found

    def get_pose(self, node):
        """Node to world."""
        self._require(node)
        pose = node.matrix
        while self._parents[node] is not None:
            node = self._parents[node]
            pose = node.matrix @ pose
        return pose.copy()

    def set_pose(self, node, pose):
        """Sets node to parent."""
        self._require(node)
        node.matrix = pose

    @property
    def bounds(self):
        """Lowest and highest x, y, z of all meshes in the world, [2][3]."""
        points = [(pose @ np.append(corner, 1))[:3] for node, pose in self.placed("mesh")
                  for corner in node.mesh.corners()]
        return np.array([np.min(points, axis=0), np.max(points, axis=0)]) if points else np.zeros((2, 3))

    centroid = property(lambda self: self.bounds.mean(axis=0))
    extents = property(lambda self: np.diff(self.bounds, axis=0).reshape(-1))
    scale = property(lambda self: float(np.linalg.norm(self.extents)))

    @staticmethod
    def from_trimesh_scene(trimesh_scene, bg_color=None, ambient_light=None):
        """A scene with the meshes of a scene of trimesh."""
        from .pyrender import Mesh
        made = Scene(bg_color=bg_color, ambient_light=ambient_light)
        meshes = {name: Mesh.from_trimesh(mesh) for name, mesh in trimesh_scene.geometry.items()}
        for node in trimesh_scene.graph.nodes_geometry:
            pose, name = trimesh_scene.graph[node]
            made.add(meshes[name], pose=pose)
        return made
