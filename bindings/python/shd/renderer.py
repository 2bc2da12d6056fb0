# SPDX-License-Identifier: MIT
"""Pictures of meshes in few lines.

    with shd.Renderer(640, 480) as renderer:
        renderer.add("model.glb")                                   # or a mesh of trimesh, or arrays
        color, depth = renderer.render()                            # or look_at(eye, target), frame(direction) before
"""
import functools
import os
import threading

import numpy as np

from . import _camera
from ._camera import matrix, point
from ._frame import Framebuffer, render
from ._model import from_arrays, from_scene, parts_of
from ._objects import Context, Light, Material, counted
from ._png import encode, straight
from ._srgb import decode

FORWARD = np.array([0.0, 0.0, -1.0])
DIRECTION = (0.48, 0.36, 0.8)           # from the right, above and in front
UNIT = np.array([[-0.5], [0.5]]) * np.ones(3)
SHADOWED = ("directional", "spot", "point")


class Item:
    """A model in the scene of a renderer. `pose` and `visible` may change between frames."""

    def __init__(self, parts, pose, scene=None):
        self.parts, self.visible, self.scene = parts, True, scene
        self.pose = np.eye(4) if pose is None else pose

    @property
    def pose(self):
        """Object to world, [4][4]."""
        return self._pose

    @pose.setter
    def pose(self, value):
        self._pose = matrix(value)

    def __repr__(self):
        return f"<shd.Item {counted(len(self.parts), 'part')}{'' if self.visible else ' invisible'}>"


def exclusive(method):
    """A method that needs an open renderer, and the renderer for itself."""
    @functools.wraps(method)
    def run(self, *arguments, **values):
        self._require_open()
        if not self._lock.acquire(blocking=False):
            raise ValueError("renderer: another thread renders with it")
        try:
            return method(self, *arguments, **values)
        finally:
            self._lock.release()
    return run


class Renderer:
    """Renderer(width, height, sample_count=4, background=(0, 0, 0, 0)): a scene, a camera and a framebuffer.

    `background` has sRGB values 0..1 and an opacity. `ambient` is ambient light, `environment` an Environment, which is
    the background if `shows_environment` is true. Without any light a headlight and some ambient light are used. Models
    and the framebuffer are kept between frames. Until the camera is placed, frame() places it for each picture. A
    renderer serves one thread; objects of shd may be shared.
    """

    def __init__(self, width, height, sample_count=4, background=(0, 0, 0, 0), context=None):
        self._context = Context() if context is None else context
        self._sample_count, self._lock = sample_count, threading.Lock()
        self._framebuffer = self._ids = self._plain = None
        self.items, self.lights, self.ambient = [], [], None
        self.environment, self.shows_environment = None, False
        self.background = background
        self.resize(width, height)
        self.frame()
        self._is_placed = False

    def resize(self, width, height):
        """Sets the size of the pictures [pixels]."""
        made = Framebuffer(self._context, width, height, sample_count=self._sample_count, color_format="rgba8_srgb")
        self._framebuffer, self._size, self._ids = made, (width, height), None

    @property
    def context(self):
        return self._context

    @property
    def background(self):
        return self._background

    @background.setter
    def background(self, value):
        rgba = np.ones(4)
        rgba[:len(value)] = value
        if len(value) not in (3, 4) or not ((rgba >= 0) & (rgba <= 1)).all():
            raise ValueError(f"background: three or four numbers 0..1, not {value}")
        self._background = rgba

    def add(self, item=None, pose=None, **values) -> Item:
        """Adds a model and returns its Item, whose pose may change between frames.

        add(mesh)                               an object like trimesh.Trimesh or trimesh.Scene; smooth=False for flat
        add("model.glb")                        a file or its bytes, by libshd_scene, with its lights if lights=True
        add(scene.pose("Walk", 0.5))            a Scene of the context of the renderer
        add(position=p, indices=i, uv=uv, texture=pixels)        arrays; also normal, color, metallic, roughness
        add(shd_mesh, material=material)        objects of shd

        Integers of colours are sRGB codes, floats are linear; uv have v downwards, except those of trimesh.
        """
        scene = None
        self._require_open()
        if isinstance(item, (str, bytes, os.PathLike)) or getattr(item, "_kind", None) == "shd_scene":
            scene = self._load(item, values)
            parts = from_scene(self._context, scene)
        elif item is None:
            parts = [from_arrays(self._context, **values)]
        else:
            parts = parts_of(self._context, item, **values)
        self.items.append(Item(parts, pose, scene))
        return self.items[-1]

    def _load(self, source, values):
        from .scene import Scene
        with_lights = values.pop("lights", False)
        scene = source if isinstance(source, Scene) and not values else Scene(self._context, source, **values)
        if with_lights:
            self.lights += [(light, None) for light in scene.lights]
        return scene

    def remove(self, item):
        """Removes a model that add() returned."""
        self.items.remove(item)

    def add_light(self, kind="directional", color=(1, 1, 1), intensity=3.0, pose=None, **values):
        """Adds a light: a kind and fields of LightDesc, or a pose whose -z axis is the direction of the light.

        White surfaces are as bright as `intensity` / pi where a light of the kind "directional" meets them upright.
        """
        if pose is not None:
            pose = matrix(pose)
            values.setdefault("direction", pose[:3, :3] @ FORWARD)
            values.setdefault("position", pose[:3, 3])
        made = Light(self._context, kind=kind, intensity=np.multiply(color, intensity), **values)
        self.lights.append((made, kind if kind in SHADOWED else None))
        return made

    def clear(self):
        """Removes all models and lights, and the environment."""
        self.items, self.lights, self.environment = [], [], None

    def look_at(self, eye, target=(0, 0, 0), up=(0, 1, 0), yfov=0.8, near=None, far=None):
        """Places the camera at `eye`. Planes that are not given are fitted to the models in each frame.

        Vertex programs may move vertices beyond fitted planes: give both planes then.
        """
        self.look_from(_camera.look_at(eye, target, up), yfov, near=near, far=far)

    def frame(self, direction=DIRECTION, up=(0, 1, 0), yfov=0.8):
        """Places the camera so that the models that are visible now fill the picture. `direction` points to the camera.

        Models that come or move later do not move the camera.
        """
        corners = [(item.pose @ part.local @ part.corners)[:3] for item in self._visible() for part in item.parts
                   if not part.is_empty]
        ends = [f(np.concatenate(corners, axis=1), axis=1) for f in (np.min, np.max)] if corners else UNIT
        if np.array_equal(*ends):  # a single point
            ends = np.add(ends, UNIT)
        eye, target = _camera.framed(ends, point(direction, "direction"), point(up, "up"), yfov,
                                     self._size[0] / self._size[1])
        self.look_at(eye, target, up, yfov)

    def look_from(self, pose, yfov=0.8, aspect=None, near=None, far=None, lens=None):
        """Places the camera by a pose, camera to world [4][4]: x right, y up, and -z along the view."""
        lens = lens or _camera.perspective(yfov, aspect, near, far)
        self._pose, self._lens, self._is_placed = matrix(pose), lens, True

    def _view(self):
        """The view, and its near and far plane."""
        if not self._is_placed:
            self.frame()
            self._is_placed = False
        width, height = self._size
        to_view = np.linalg.inv(self._pose)
        found = [-(to_view @ item.pose @ part.local @ part.corners)[2] for item in self._visible()
                 for part in item.parts if not part.is_empty]
        distances = np.concatenate(found) if found else np.zeros(1)
        planes = self._lens.fit((distances.min(), distances.max()))
        view = {"world_to_view": to_view, "eye": self._pose[:3, 3],
                "view_to_clip": self._lens.matrix(width, height, *planes)}
        return view, planes

    def _visible(self):
        return [item for item in self.items if item.visible]

    def _require_open(self):
        if self._framebuffer is None:
            raise ValueError("renderer: the Renderer is closed")

    def _lights(self, draws, shadows):
        """Lights, their shadows or None, and the environment, as options of a frame."""
        lights, kinds = list(self.lights), SHADOWED if shadows is True else tuple(shadows or ())
        if not lights and self.ambient is None and self.environment is None:
            lights = [(Light(self._context, kind="directional", direction=self._pose[:3, :3] @ FORWARD,
                             intensity=(2.5,) * 3), None),
                      (Light(self._context, kind="ambient", intensity=(0.2,) * 3), None)]
        if self.ambient is not None and np.any(self.ambient):
            lights.append((Light(self._context, kind="ambient", intensity=self.ambient), None))
        made = [self._shadow(light, draws) if kind in kinds else None for light, kind in lights]
        options = {"lights": [light for light, _ in lights], **({"shadows": made} if any(made) else {})}
        if self.environment is not None:
            options.update(environment=self.environment,
                           background="environment" if self.shows_environment else "clear")
        return options

    def _shadow(self, light, draws):
        from ._shadow import Shadow
        shadow = Shadow(self._context, filter="pcf", size=2048)
        shadow.render(self._context, light, draws)
        return shadow

    def _draws(self, material, **values):
        """The draws of visible models with a material, or with the function of a part that gives it."""
        choose = material if callable(material) else lambda part: material
        return [part.draw(item.pose, material=choose(part), **values) for item in self._visible()
                for part in item.parts]

    @exclusive
    def render(self, alpha=False, flat=False, shadows=False, progress=None, **values):
        """Draws a frame: color [height][width][3] of uint8 in sRGB, and depth [height][width] of float32.

        Depth is the distance along the view [world units], 0 in the background. `alpha` adds a channel of opacity, with
        straight colours. `flat` shows colours without light. `shadows` is True, or the kinds of lights with shadows.
        `progress` is a function of the finished fraction, which may return False to end the frame; True is a bar for
        frames of more than half a second. Other options are fields of all draws, such as cull="back".
        """
        draws = self._draws((lambda part: part.look.flat) if flat else (lambda part: part.look.lit), **values)
        view, planes = self._view()
        background = self._background
        clear = np.append(decode(background[:3]) * background[3], background[3])
        render(self._context, self._framebuffer, draws, view=view, clear_color=clear, clear_depth=0,
               progress=progress, **self._lights(draws, shadows))
        depth = self._lens.distances(self._framebuffer.plane("depth"), *planes)
        color = self._framebuffer.view_color()
        return (straight(color) if alpha else color[..., :3].copy()), depth

    @exclusive
    def render_depth(self, **values) -> np.ndarray:
        """The depth of a frame, without colours. Options are fields of all draws."""
        view, planes = self._view()
        render(self._context, self._framebuffer, self._draws(None, **values), view=view, clear_depth=0)
        return self._lens.distances(self._framebuffer.plane("depth"), *planes)

    @exclusive
    def render_ids(self, **values) -> np.ndarray:
        """The index of the model in `items` that is visible at each pixel, -1 in the background; not antialiased."""
        if self._ids is None:
            self._ids = Framebuffer(self._context, *self._size, aovs="draw", color_format="rgba8")
            self._plain = Material(self._context, model="unlit")
        numbers = [i for i, item in enumerate(self.items) if item.visible for _ in item.parts]
        render(self._context, self._ids, self._draws(self._plain, **values), view=self._view()[0], clear_depth=0)
        return np.append(numbers, -1).astype(np.int32)[np.minimum(self._ids.plane("draw"), len(numbers))]

    def __repr__(self):
        if self._framebuffer is None:
            return "<shd.Renderer closed>"
        width, height = self._size
        return (f"<shd.Renderer {width}x{height} {counted(len(self.items), 'model')} "
                f"{counted(len(self.lights), 'light')}>")

    def _repr_png_(self):
        """The picture in a notebook: a frame with the present models, lights and camera."""
        return None if self._framebuffer is None else encode(self.render(alpha=True)[0])

    def close(self):
        """Drops models, lights and the framebuffer. Closing again has no effect."""
        self._framebuffer = self._ids = self._plain = None
        self.clear()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()
