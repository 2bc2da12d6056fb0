# SPDX-License-Identifier: MIT
"""Models from files, with the attributes of meshes and scenes of trimesh."""
import copy
import itertools

import numpy as np

from .._camera import matrix
from .._model import from_scene
from ._checked import Boxed, bounds_of, face_normals, unit
from ._stored import stored_material
from .mesh import Primitive, context


def load(source, **values):
    """A model file of any format that libshd_scene reads, or its bytes. Options are those of shd.Scene."""
    from ..scene import Scene as File
    scene = File(context(), source, **values)
    parts, instances = from_scene(context(), scene, metallic=1.0), scene.instances
    for part in parts:
        part.look.shows_codes = True
    names = unique_names([(i.mesh, i.material) for i in instances], scene.names("mesh"))
    return Model([Piece(part, names[i.mesh, i.material]) for part, i in zip(parts, instances)], scene.warnings)


def unique_names(pairs, names):
    """A name for each pair of a mesh and a material: that of the mesh, with _1, _2 ... if others have it, too."""
    made, used = {}, set()
    for mesh, material in dict.fromkeys(pairs):
        name = names[mesh] or f"mesh{mesh}"
        tries = itertools.chain([name], (f"{name}_{i}" for i in itertools.count(1)))
        made[mesh, material] = next(t for t in tries if t not in used)
        used.add(made[mesh, material])
    return made


class Piece:
    """A part of a file and the name of its mesh in the model."""

    def __init__(self, part, name):
        self.part, self.name = part, name

    def moved(self, pose):
        made = copy.copy(self)
        made.part = copy.copy(self.part)
        made.part.local = pose
        return made

    def points(self):
        """Positions in the space of the model."""
        local = self.part.local
        return self.part.mesh.positions.astype(np.float64) @ local[:3, :3].T + local[:3, 3]

    def normals(self):
        return unit(self.part.mesh.normals @ np.linalg.inv(self.part.local[:3, :3]))

    def uv(self):
        """Texture coordinates with v upwards."""
        return self.part.mesh.uv * (1, -1) + (0, 1)

    def material(self):
        """The factors and textures of the file, for programs that read or change them."""
        return stored_material(self.part.look.desc, self.part.values.get("cull") != "back")


class Model(Boxed):
    """The triangles of a model file, for Mesh.from_trimesh() and Scene.from_trimesh_scene(). `warnings` are those of
    the file: features of the file that pictures do not show."""

    def __init__(self, pieces, warnings=()):
        self._pieces, self.warnings = list(pieces), list(warnings)

    @property
    def vertices(self):
        """Positions of all vertices [n][3]."""
        return np.concatenate([np.zeros((0, 3)), *(piece.points() for piece in self._pieces)])

    @property
    def vertex_normals(self):
        """Normals of all vertices [n][3]."""
        return np.concatenate([np.zeros((0, 3)), *(piece.normals() for piece in self._pieces)])

    @property
    def faces(self):
        """Numbers of vertices of triangles [m][3]."""
        starts = np.cumsum([0, *(p.part.mesh.info["vertex_count"] for p in self._pieces)])
        return np.concatenate([np.zeros((0, 3), np.int64), *(
            piece.part.mesh.indices.astype(np.int64) + start for piece, start in zip(self._pieces, starts))])

    @property
    def face_normals(self):
        """Normals of the triangles [m][3]."""
        return face_normals(self.vertices[self.faces])

    @property
    def bounds(self):
        """Lowest and highest x, y, z."""
        return bounds_of(self.vertices)

    @property
    def is_empty(self):
        return not self._pieces

    @property
    def geometry(self):
        """The meshes of the file by name, each a Model in its own space."""
        found = {}
        for piece in self._pieces:
            found.setdefault(piece.name, Model([piece.moved(np.eye(4))], self.warnings))
        return found

    @property
    def graph(self):
        """The places of the meshes: for node in graph.nodes_geometry: pose, name = graph[node]."""
        return Graph(self._pieces)

    def dump(self, concatenate=False):
        """The meshes at their places as a list of Model, or one Model."""
        return self if concatenate else [Model([piece], self.warnings) for piece in self._pieces]

    def copy(self):
        return Model(self._pieces, self.warnings)

    def apply_transform(self, transform):
        """Moves the model by a matrix [4][4], and returns it."""
        pose = matrix(transform, "transform")
        self._pieces = [piece.moved(pose @ piece.part.local) for piece in self._pieces]
        return self

    def apply_translation(self, translation):
        """Moves the model, and returns it."""
        pose = np.eye(4)
        pose[:3, 3] = translation
        return self.apply_transform(pose)

    def apply_scale(self, scaling):
        """Scales the model by a number or by three, and returns it."""
        return self.apply_transform(np.diag([*np.broadcast_to(np.asarray(scaling, np.float64), 3), 1.0]))

    def primitives(self, material=None, poses=None, wireframe=False, smooth=True):
        """Primitives of the pieces. Without another material they are drawn with the complete material of the file."""
        return [self._primitive(piece, material, poses, wireframe, smooth) for piece in self._pieces]

    @staticmethod
    def _primitive(piece, material, poses, wireframe, smooth):
        own = piece.material() if material is None else copy.copy(material)
        own.wireframe = own.wireframe or wireframe
        corners = piece.part.mesh.indices.reshape(-1)
        if smooth:
            made = Primitive(piece.points(), piece.normals(), texcoord_0=piece.uv(), indices=corners, material=own,
                             poses=poses)
        else:
            made = Primitive(piece.points()[corners], texcoord_0=piece.uv()[corners], material=own, poses=poses)
        if smooth and material is None:
            part = copy.copy(piece.part)
            part.values = {**part.values, **({"fill": "wireframe"} if wireframe else {})}
            made.keep_part(part)
        return made

    def __repr__(self):
        return f"<shd.pyrender.Model {len(self.vertices)} vertices {len(self.faces)} faces>"


class Graph:
    """Nodes of a model, like the graph of a scene of trimesh."""

    def __init__(self, pieces):
        self._nodes = {f"node{i}": (piece.part.local.copy(), piece.name) for i, piece in enumerate(pieces)}

    @property
    def nodes_geometry(self):
        return list(self._nodes)

    def __getitem__(self, node):
        return self._nodes[node]
