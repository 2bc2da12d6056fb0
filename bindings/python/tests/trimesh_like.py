# SPDX-License-Identifier: MIT
"""Stand-ins for trimesh, which Debian does not package: the attributes that its documentation gives for Trimesh, its
visuals, its materials and its Scene, with their types (float64 and int64), defaults and directions of v.
"""
import numpy as np


class Image:
    """The parts of an image of Pillow that are used: mode, convert() and the array interface."""

    def __init__(self, pixels, mode="RGBA"):
        self._pixels, self.mode = pixels, mode

    def convert(self, mode):
        channels = {"RGB": 3, "RGBA": 4}[mode]
        grey = np.repeat(self._pixels[..., :1], 3, axis=2)
        return Image(np.concatenate([grey, self._pixels[..., 1:2]], axis=2)[..., :channels], mode)

    @property
    def __array_interface__(self):
        return self._pixels.__array_interface__


class SimpleMaterial:
    """Of an OBJ file. The diffuse colour has codes 0..255."""

    def __init__(self, image=None, diffuse=(102, 102, 102, 255), glossiness=1.0):
        self.image, self.diffuse, self.glossiness = image, np.uint8(diffuse), glossiness
        self.ambient = self.specular = np.uint8([102, 102, 102, 255])

    @property
    def main_color(self):
        return self.diffuse


class PBRMaterial:
    """Of a glTF file. Factors that the file lacks are None."""

    def __init__(self, **values):
        for name in ("emissiveFactor", "emissiveTexture", "baseColorFactor", "baseColorTexture", "metallicFactor",
                     "roughnessFactor", "metallicRoughnessTexture", "normalTexture", "occlusionTexture", "alphaMode",
                     "alphaCutoff", "doubleSided"):
            setattr(self, name, values.pop(name, None))
        assert not values, values

    @property
    def main_color(self):
        return np.uint8([102, 102, 102, 255]) if self.baseColorFactor is None else self.baseColorFactor


class TextureVisuals:
    kind, defined = "texture", True

    def __init__(self, uv, material):
        self.uv, self.material = uv, material


class ColorVisuals:
    """Colours of vertices or of faces, as codes 0..255; grey if there are none."""

    def __init__(self, vertex_colors=None, face_colors=None):
        self._vertex, self._face = vertex_colors, face_colors
        self.kind = "vertex" if vertex_colors is not None else "face" if face_colors is not None else None
        self.defined = self.kind is not None

    @property
    def vertex_colors(self):
        return np.full((4, 4), 102, np.uint8) if self._vertex is None else self._vertex

    @property
    def face_colors(self):
        return np.full((4, 4), 102, np.uint8) if self._face is None else self._face


class Trimesh:
    def __init__(self, vertices, faces, visual=None):
        self.vertices, self.faces = np.float64(vertices), np.int64(faces)
        self.visual = visual or ColorVisuals()

    @property
    def face_normals(self):
        a, b, c = (self.vertices[self.faces[:, i]] for i in range(3))
        cross = np.cross(b - a, c - a)
        return cross / np.linalg.norm(cross, axis=1, keepdims=True)

    @property
    def vertex_normals(self):
        summed = np.zeros_like(self.vertices)
        for corner in range(3):
            np.add.at(summed, self.faces[:, corner], self.face_normals)
        return summed / np.linalg.norm(summed, axis=1, keepdims=True)


class Graph:
    def __init__(self, nodes):
        self._nodes = nodes

    @property
    def nodes_geometry(self):
        return list(self._nodes)

    def __getitem__(self, node):
        return self._nodes[node]


class Scene:
    """Geometry by name, and a graph of nodes: name -> (matrix, name of the geometry)."""

    def __init__(self, geometry, nodes):
        self.geometry, self.graph = geometry, Graph(nodes)


def square(visual=None, z=0.0):
    """A square of side 2 that faces +z, with v upwards."""
    vertices = [[-1, -1, z], [1, -1, z], [1, 1, z], [-1, 1, z]]
    return Trimesh(vertices, [[0, 1, 2], [0, 2, 3]], visual)


UV = np.float64([[0, 0], [1, 0], [1, 1], [0, 1]])
