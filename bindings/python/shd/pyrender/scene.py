# SPDX-License-Identifier: MIT
"""Scenes of shd.pyrender."""
import numpy as np

from .._model import corners_of
from ._checked import Boxed, Checked, bounds_of, color, text
from .camera import Camera
from .light import DirectionalLight, Light, PointLight, SpotLight
from .mesh import Mesh
from .node import Node


class Scene(Boxed):
    """A tree of nodes with meshes, lights and cameras. The first camera is the main camera."""

    name = Checked(text)
    bg_color = Checked(color(4, 1.0), "Background, sRGB and opacity.")
    ambient_light = Checked(color(3, 0.0), "Linear r, g, b.")

    def __init__(self, nodes=None, bg_color=None, ambient_light=None, name=None):
        self.bg_color, self.ambient_light, self.name = bg_color, ambient_light, name
        self.clear()
        children = [id(child) for node in nodes or () for child in node.children]
        if len(set(children)) < len(children):
            raise ValueError("nodes: a node has more than one parent")
        for node in nodes or ():
            if id(node) not in children:
                self.add_node(node)

    def clear(self):
        """Removes all nodes."""
        self._parents, self._main = {}, None  # in the order of their addition

    @property
    def main_camera_node(self):
        """The node of the camera that pictures are taken with."""
        return self._main

    @main_camera_node.setter
    def main_camera_node(self, node):
        self._require(node)
        self._main = node

    @property
    def nodes(self):
        return set(self._parents)

    def _having(self, name):
        return [node for node in self._parents if getattr(node, name) is not None]

    def _lit(self, kind):
        return {node for node in self._having("light") if isinstance(node.light, kind)}

    mesh_nodes = property(lambda self: set(self._having("mesh")))
    light_nodes = property(lambda self: self._lit(Light))
    point_light_nodes = property(lambda self: self._lit(PointLight))
    spot_light_nodes = property(lambda self: self._lit(SpotLight))
    directional_light_nodes = property(lambda self: self._lit(DirectionalLight))
    camera_nodes = property(lambda self: set(self._having("camera")))
    meshes = property(lambda self: {node.mesh for node in self.mesh_nodes})
    lights = property(lambda self: {node.light for node in self.light_nodes})
    point_lights = property(lambda self: {node.light for node in self.point_light_nodes})
    spot_lights = property(lambda self: {node.light for node in self.spot_light_nodes})
    directional_lights = property(lambda self: {node.light for node in self.directional_light_nodes})
    cameras = property(lambda self: {node.camera for node in self.camera_nodes})

    def placed(self, name):
        """The nodes with a mesh, a light or a camera, in the order of their addition, and their poses."""
        return [(node, self.get_pose(node)) for node in self._having(name)]

    def add(self, obj, name=None, pose=None, parent_node=None, parent_name=None):
        """Adds a mesh, a light or a camera, and returns its node."""
        kinds = {"light": isinstance(obj, Light), "camera": isinstance(obj, Camera),
                 "mesh": isinstance(obj, Mesh)}
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
        if node.camera is not None and self._main is None:
            self._main = node
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
        if node is self._main:
            self._main = next(iter(self._having("camera")), None)
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
        points = [corners_of(node.mesh.bounds) @ pose[:3, :3].T + pose[:3, 3] for node, pose in self.placed("mesh")
                  if node.mesh.primitives]
        return bounds_of(np.concatenate(points)) if points else np.zeros((2, 3))

    @staticmethod
    def from_trimesh_scene(trimesh_scene, bg_color=None, ambient_light=None):
        """A scene with the meshes of a scene of trimesh, or of a Model of load()."""
        made = Scene(bg_color=bg_color, ambient_light=ambient_light)
        meshes = {name: Mesh.from_trimesh(mesh) for name, mesh in trimesh_scene.geometry.items()}
        for node in trimesh_scene.graph.nodes_geometry:
            pose, name = trimesh_scene.graph[node]
            made.add(meshes[name], name=str(node), pose=pose)
        return made

    def __repr__(self):
        return (f"<shd.pyrender.Scene {len(self.meshes)} meshes {len(self.lights)} lights "
                f"{len(self.cameras)} cameras>")
