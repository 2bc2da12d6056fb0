# SPDX-License-Identifier: MIT
"""Nodes of shd.pyrender."""
import numpy as np

from .._camera import matrix as checked_matrix
from ._checked import Checked, anything, instance_of, text, vector
from .camera import Camera
from .light import Light
from .mesh import Mesh


def rotation_matrix(quaternion):
    """The rotation of a quaternion x, y, z, w."""
    x, y, z, w = quaternion / np.linalg.norm(quaternion)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def quaternion_of(rotation):
    """The quaternion x, y, z, w of a rotation, with w >= 0: the eigenvector of Bar-Itzhack, "New Method for Extracting
    the Quaternion from a Rotation Matrix" (2000)."""
    m = rotation
    symmetric = np.array([
        [m[0, 0] - m[1, 1] - m[2, 2], m[1, 0] + m[0, 1], m[2, 0] + m[0, 2], m[2, 1] - m[1, 2]],
        [m[1, 0] + m[0, 1], m[1, 1] - m[0, 0] - m[2, 2], m[2, 1] + m[1, 2], m[0, 2] - m[2, 0]],
        [m[2, 0] + m[0, 2], m[2, 1] + m[1, 2], m[2, 2] - m[0, 0] - m[1, 1], m[1, 0] - m[0, 1]],
        [m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], m[0, 0] + m[1, 1] + m[2, 2]]])
    found = np.linalg.eigh(symmetric)[1][:, -1]
    return found if found[3] >= 0 else -found


def placing(check):
    """A check of a part of the place, which replaces the matrix."""
    def run(node, value, name):
        made = check(node, value, name)
        node._matrix = None
        return made
    return run


class Node:
    """A place in a scene: node to parent, with a mesh, a light or a camera.

    The place is a matrix, or a translation, a rotation (a quaternion x, y, z, w) and a scale.
    """

    name = Checked(text)
    camera = Checked(instance_of(Camera, "a Camera"))
    mesh = Checked(instance_of(Mesh, "a Mesh"))
    light = Checked(instance_of(Light, "a Light"))
    skin = Checked(anything, "Kept for programs.")
    weights = Checked(anything, "Kept for programs.")

    def __init__(self, name=None, camera=None, children=None, skin=None, matrix=None, mesh=None, rotation=None,
                 scale=None, translation=None, weights=None, light=None):
        self.name, self.camera, self.skin, self.mesh = name, camera, skin, mesh
        self.weights, self.light = weights, light
        self.children = [] if children is None else children
        if matrix is not None:
            self.matrix = matrix
        else:
            self.rotation = (0, 0, 0, 1) if rotation is None else rotation
            self.scale = np.ones(3) if scale is None else scale
            self.translation = np.zeros(3) if translation is None else translation

    rotation = Checked(placing(vector(4, unit=True)))
    scale = Checked(placing(vector(3)))
    translation = Checked(placing(vector(3)))

    @property
    def matrix(self):
        """Node to parent, [4][4]; a copy."""
        if self._matrix is None:
            made = np.eye(4)
            made[:3, :3] = rotation_matrix(self.rotation) * self.scale
            made[:3, 3] = self.translation
            self._matrix = made
        return self._matrix.copy()

    @matrix.setter
    def matrix(self, value):
        made = checked_matrix(value, "matrix")
        scale = np.linalg.norm(made[:3, :3], axis=0)
        self.rotation = quaternion_of(made[:3, :3] / np.where(scale > 0, scale, 1))
        self.scale, self.translation = scale, made[:3, 3]
        self._matrix = made

    def __repr__(self):
        held = [f"{kind}={type(value).__name__}" for kind, value in (
            ("mesh", self.mesh), ("light", self.light), ("camera", self.camera)) if value is not None]
        name = [] if self.name is None else [repr(self.name)]
        return f"<{' '.join(['shd.pyrender.Node', *name, *held, f'{len(self.children)} children'])}>"
