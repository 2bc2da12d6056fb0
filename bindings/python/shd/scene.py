# SPDX-License-Identifier: MIT
"""Model files: meshes, materials, textures, lights and cameras. Needs the component libshd_scene."""
import collections.abc
import ctypes

import numpy as np

from . import _api
from ._callback import Callback
from ._convert import address, enum_value, is_bytes, text_bytes
from ._desc import desc_type, read_struct
from ._objects import Light, Material, Mesh, Object, Sampler, counted, make_desc
from ._texture import Texture

_HANDLES = {"shd_texture": Texture, "shd_sampler": Sampler, "shd_mesh": Mesh, "shd_material": Material}


def _matrix(values):
    """A matrix of C, columns first, as an array [row][column]."""
    return np.array(values, np.float32).reshape(4, 4).T.copy()


def _finder(find):
    """The callback of C for find(name), which returns the bytes of a file or None, or for a dict of them."""
    get, answers = find.get if isinstance(find, collections.abc.Mapping) else find, []
    if not callable(get):
        raise TypeError(f"scene.find: a function or a dict, not {type(find).__name__}")

    def run(name, out_bytes, out_size):
        answer = get(name)
        if answer is None:
            return _api.enum_type("shd_result").ERROR_NOT_FOUND
        if not is_bytes(answer):
            raise TypeError(f"scene.find: bytes or None for {name!r}, not {type(answer).__name__}")
        answers.append(np.frombuffer(answer, np.uint8))  # until the load ends
        ctypes.c_void_p.from_address(out_bytes).value = address(answers[-1])
        ctypes.c_size_t.from_address(out_size).value = answers[-1].size
        return 0

    return run


class Scene(Object):
    """Scene(context, "model.glb", ...): the contents of a model file, or of the bytes of one.

    The parts are ordinary objects and descs, which may be used longer than the scene:

        scene = shd.Scene(context, "model.glb")
        shd.render(context, framebuffer, scene.draws, lights=scene.lights, camera=scene.cameras[0])

    Options are the fields of SceneDesc: flags="any_folder", max_triangles=10**6. `find` answers the names of the
    model's files in place of its folder: a dict of bytes, or a function find(name) that returns bytes or None. The load
    raises what the function raises. `name` is that of a model in memory, for formats without a mark of their own:

        scene = shd.Scene(context, archive.read("a.obj"), name="a.obj", find={"a.mtl": archive.read("a.mtl")})
    """

    _kind = "shd_scene"

    def __init__(self, context, source, desc=None, *, name=None, **values):
        keep, made = [], make_desc("shd_scene_desc", desc, values)
        if made._values.get("find") is not None:
            made = made.replace(find=_finder(made.find))
        built, handle = ctypes.addressof(made.build(keep)), context.handle("shd_context", keep)
        if is_bytes(source):
            raw = np.frombuffer(source, np.uint8)
            self._adopt(keep, _api.lib.shd_scene_load_memory, handle, address(raw), raw.size, text_bytes(name, "name"),
                        built)
        elif name is not None:
            raise TypeError("name: only models in memory have one")
        else:
            self._adopt(keep, _api.lib.shd_scene_load, handle, text_bytes(source, "path"), built, path=source)
        self._reference.keep = [k for k in self._reference.keep if not isinstance(k, Callback)]  # find was for the load
        self._info_values = self._info("shd_scene_info")

    def _parts(self):
        return [counted(self.info[f"{part}_count"], part) for part in ("instance", "material", "light", "animation")
                if self.info[f"{part}_count"] or part == "instance"]

    @property
    def info(self) -> dict:
        """Counts and bounds, as a dict."""
        self.handle(self._kind, [])
        return dict(self._info_values)

    def _texts(self, function, count, *arguments):
        keep = []  # another thread may close the scene
        handle = self.handle(self._kind, keep)
        return [function(handle, *arguments, i).decode("utf-8", "replace") for i in range(count)]

    @property
    def warnings(self) -> list:
        """Parts of the file that were left out or changed, one text each."""
        return self._texts(_api.lib.shd_scene_get_warning, self.info["warning_count"])

    def names(self, part) -> list:
        """The names of the parts of a kind: names("mesh"), "material", "texture" (a path), "light",
        "camera" or "animation"."""
        kind = _api.enum_type("shd_scene_part")(enum_value("shd_scene_part", part, "part"))
        return self._texts(_api.lib.shd_scene_get_name, self.info[f"{kind.name.lower()}_count"], int(kind))

    def _objects(self, kind):
        get, name = getattr(_api.lib, f"shd_scene_get_{kind._kind[4:]}"), kind._kind[4:]
        keep = []
        handle = self.handle(self._kind, keep)
        return [kind.borrowed(get(handle, i), keep) for i in range(self.info[f"{name}_count"])]

    @property
    def meshes(self) -> list:
        return self._objects(Mesh)

    @property
    def materials(self) -> list:
        return self._objects(Material)

    @property
    def textures(self) -> list:
        return self._objects(Texture)

    @property
    def lights(self) -> list:
        return self._objects(Light)

    def _structs(self, function, struct, count):
        made, keep = [], []
        handle = self.handle(self._kind, keep)
        for i in range(self.info[count]):
            made.append(_api.new(struct))
            _api.check(function(handle, i, ctypes.addressof(made[-1])))
        return made

    @property
    def cameras(self) -> list:
        """The cameras of the file, as a list of Camera."""
        structs = self._structs(_api.lib.shd_scene_get_camera, "shd_camera", "camera_count")
        return [desc_type("shd_camera")(**read_struct("shd_camera", s)) for s in structs]

    @property
    def instances(self) -> list:
        """The instances of the file, as a list of SceneInstance: indices of a mesh and a material, and a matrix."""
        structs = self._structs(_api.lib.shd_scene_get_instance, "shd_scene_instance", "instance_count")
        return [desc_type("shd_scene_instance")(mesh=s.mesh, material=s.material,
                                                object_to_world=_matrix(s.object_to_world), cull=s.cull)
                for s in structs]

    @property
    def draws(self) -> list:
        """The instances of the file, as a list of Draw with mesh, material and object_to_world."""
        meshes, materials = self.meshes, self.materials
        return [desc_type("shd_draw")(mesh=meshes[i.mesh], material=materials[i.material],
                                      object_to_world=i.object_to_world, cull=i.cull) for i in self.instances]

    def animation_times(self, index) -> "tuple[float, float]":
        """The first and the last key of an animation [s]."""
        keep, times = [], (ctypes.c_double * 2)()
        _api.check(_api.lib.shd_scene_get_animation_times(self.handle(self._kind, keep), index,
                                                          ctypes.addressof(times), ctypes.addressof(times) + 8))
        return times[0], times[1]

    def pose(self, animation, seconds) -> "Scene":
        """A scene of the file at a time of an animation, given by its number or its name."""
        if isinstance(animation, str):
            names = self.names("animation")
            if animation not in names:
                raise ValueError(f"animation: \"{animation}\" is not one of {names}")
            animation = names.index(animation)
        keep, posed = [], Scene.__new__(Scene)
        posed._adopt(keep, _api.lib.shd_scene_pose, self.handle(self._kind, keep), animation, ctypes.c_double(seconds))
        posed._info_values = posed._info("shd_scene_info")
        return posed

    @property
    def light_descs(self) -> list:
        """The descs of the lights, for variants of them."""
        structs = self._structs(_api.lib.shd_scene_get_light_desc, "shd_light_desc", "light_count")
        return [self._desc("shd_light_desc", s) for s in structs]

    @property
    def material_descs(self) -> list:
        """The descs of the materials with their slots, for variants of them."""
        structs = self._structs(_api.lib.shd_scene_get_material_desc, "shd_material_desc", "material_count")
        return [self._desc("shd_material_desc", s) for s in structs]

    def _desc(self, struct, made):
        """A desc from a struct of the library: numbers, objects and slots, without programs."""
        keep, values = [], {}
        self.handle(self._kind, keep)
        for name, value in read_struct(struct, made).items():
            field = desc_type(struct)._fields[name]
            base = field["type"].replace("const", "").replace("*", "").strip()
            if base in _HANDLES:
                values[name] = _HANDLES[base].borrowed(value, keep)
            elif name == "slots" and value:
                rows = (_api.struct_type("shd_slot") * made.slot_count).from_address(value)
                values[name] = [self._desc("shd_slot", row) for row in rows]
            elif "*" in field["type"] or base in _api.callbacks or isinstance(value, dict):
                continue
            elif name == "place_transform":
                values[name] = _matrix(value)
            elif name not in ("slot_count", "varying_count"):
                values[name] = value
        return desc_type(struct)(**{k: v for k, v in values.items() if v is not None})
