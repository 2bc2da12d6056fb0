# SPDX-License-Identifier: MIT
"""The renderer of shd.pyrender."""
import copy
import threading

import numpy as np

from .._array import array_of
from ..renderer import Item, Renderer, exclusive
from ._checked import Checked, codes, number, whole
from .constants import GLTF, RenderFlags
from .mesh import context

SHADOWS = {"directional": RenderFlags.SHADOWS_DIRECTIONAL, "point": RenderFlags.SHADOWS_POINT,
           "spot": RenderFlags.SHADOWS_SPOT}


LARGEST = 16384  # pixels of a side of a framebuffer


class OffscreenRenderer:
    """Renders scenes into arrays. The framebuffer is kept between frames; delete() drops it."""

    viewport_width = Checked(whole(1, LARGEST), "Width of the pictures [pixels].")
    viewport_height = Checked(whole(1, LARGEST), "Height of the pictures [pixels].")
    point_size = Checked(number(0, or_equal=False), "Side of the squares of points [pixels].")

    def __init__(self, viewport_width, viewport_height, point_size=1.0):
        self.viewport_width, self.viewport_height, self.point_size = viewport_width, viewport_height, point_size
        self._size, self._lock = (self.viewport_width, self.viewport_height), threading.Lock()
        self._renderer = Renderer(*self._size, context=context())

    def _require_open(self):
        if self._renderer is None:
            raise ValueError("renderer: it was deleted")

    @exclusive
    def render(self, scene, flags=RenderFlags.NONE, seg_node_map=None):
        """Colour [height][width][3] of uint8 (4 with RGBA), and depth [height][width] of float32 [world units].

        Depth is 0 in the background. DEPTH_ONLY gives depth alone; SEG gives the colours of `seg_node_map`, by nodes.
        """
        if scene.main_camera_node is None:
            raise ValueError("scene: it has no camera")
        renderer = self._prepare(scene, flags, seg_node_map)
        values = {"cull": "none"} if flags & (RenderFlags.SKIP_CULL_FACES | RenderFlags.SEG) else {}
        if flags & RenderFlags.DEPTH_ONLY:
            return renderer.render_depth(**values)
        if flags & RenderFlags.SEG:
            return self._segments(scene, seg_node_map, values)
        color, depth = renderer.render(alpha=bool(flags & RenderFlags.RGBA), flat=bool(flags & RenderFlags.FLAT),
                                       shadows=[kind for kind, flag in SHADOWS.items() if flags & flag], **values)
        if any(node.mesh.is_transparent for node in scene.mesh_nodes if node.mesh.is_visible):
            depth = renderer.render_depth(**values)  # translucent surfaces have a depth, too
        return color, depth

    def _prepare(self, scene, flags, seg_node_map):
        """Puts the models, lights and camera of a scene into the renderer."""
        renderer, size = self._renderer, (self.viewport_width, self.viewport_height)
        if size != self._size:
            renderer.resize(*size)
            self._size = size
        renderer.items = [Item(self._parts(node.mesh, flags), pose) for node, pose in scene.placed("mesh")
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

    def _parts(self, mesh, flags):
        """Copies of parts with the size of points and the fill of the flags, and normals as lines."""
        made = []
        for primitive in mesh.primitives:
            for part in map(copy.copy, primitive.parts):
                part.values = {**part.values, "fill": self._fill(primitive, part, flags)}
                if part.values["fill"] == "points":
                    part.values["fill_width"] = self.point_size
                made.append(part)
            for flag, of_faces in ((RenderFlags.VERTEX_NORMALS, False), (RenderFlags.FACE_NORMALS, True)):
                if flags & flag and not flags & (RenderFlags.SEG | RenderFlags.DEPTH_ONLY):
                    made += primitive.normal_lines(of_faces)
        return made

    @staticmethod
    def _fill(primitive, part, flags):
        """The fill of a part. Flags of wireframes change triangles alone."""
        fill = part.values.get("fill", "solid")
        if primitive.mode < GLTF.TRIANGLES:
            return fill
        if flags & RenderFlags.ALL_SOLID:
            return "solid"
        if flags & RenderFlags.ALL_WIREFRAME:
            return "wireframe"
        flipped = {"solid": "wireframe", "wireframe": "solid"} if flags & RenderFlags.FLIP_WIREFRAME else {}
        return flipped.get(fill, fill)

    def _segments(self, scene, seg_node_map, values):
        nodes = [node for node, _ in scene.placed("mesh") if self._is_drawn(node, RenderFlags.SEG, seg_node_map)]
        table = np.zeros((len(nodes) + 1, 3), np.uint8)  # the last row is the background
        for row, node in zip(table, nodes):
            color = codes(array_of(seg_node_map[node], "seg_node_map"), "seg_node_map")
            if color.shape not in ((), (1,), (3,)):
                raise ValueError(f"seg_node_map: r, g, b or one number, not an array of shape {color.shape}")
            row[:] = color
        return table[self._renderer.render_ids(**values)], self._renderer.render_depth(**values)

    def __repr__(self):
        return f"<shd.pyrender.OffscreenRenderer {self.viewport_width}x{self.viewport_height}>"

    def delete(self):
        """Drops the framebuffer; later renders raise ValueError."""
        if self._renderer is not None:
            self._renderer.close()
        self._renderer = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.delete()
