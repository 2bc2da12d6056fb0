# SPDX-License-Identifier: MIT
"""Objects of the library and their references: contexts, samplers, materials, lights and meshes."""
import collections
import ctypes
import enum

import numpy as np

from . import _api
from ._array import array_of, batch, converted
from ._callback import Callback, local, raise_failures
from ._convert import address, columns, enum_value
from ._desc import desc_type, read_struct

_deferred = collections.deque()


class Reference:
    """One reference to an object of C, released with the last user: an object, an array over its memory, a call.

    `keep` has the callbacks of the object and the references of the objects that it was made from: callbacks of a
    context live as long as its objects.
    """

    def __init__(self, kind, handle, keep):
        self.handle, self.keep = handle, keep
        self._release = getattr(_api.lib, _api.handles[kind]["release"])

    def __del__(self, deferred=_deferred, local=local):
        deferred.append((self._release, self.handle, self.keep))
        if not getattr(local, "depth", 0):  # callbacks may not call the library
            while deferred:
                release, handle, keep = deferred.popleft()
                release(handle)
                del keep


class Object:
    """Base of the objects. `with` closes an object; memory is freed when nothing uses it any more."""

    _kind = ""
    _reference = None
    _options = ()  # texts of the options of an object that is made from a desc

    def _adopt(self, keep, create, *arguments, path=None):
        out = ctypes.c_void_p()
        result = create(*arguments, ctypes.addressof(out))
        if result:
            raise_failures(keep)
            _api.check(result, path)
        self._reference = Reference(self._kind, out.value, [k for k in keep if isinstance(k, (Callback, Reference))])

    @classmethod
    def borrowed(cls, handle, keep):
        """An object with a reference of its own to an object of C, or None; `keep` lives as long as the object."""
        if not handle:
            return None
        getattr(_api.lib, _api.handles[cls._kind]["retain"])(handle)
        made = cls.__new__(cls)
        made._reference = Reference(cls._kind, handle, list(keep))
        return made

    def handle(self, kind, keep, name="object"):
        """The handle for a call; `keep` gets what must live until its end."""
        if kind != self._kind:
            raise TypeError(f"{name}: {type(self).__name__}, not {_api.camel(kind)}")
        if self._reference is None:
            raise ValueError(f"{name}: the {type(self).__name__} is closed")
        keep.append(self._reference)
        return self._reference.handle

    def close(self):
        """Drops the reference. Later uses raise ValueError; closing again has no effect."""
        self._reference = None

    def _parts(self):
        """What repr() says of the object."""
        return self._options

    def __repr__(self):
        parts = ["closed"] if self._reference is None else self._parts()
        return f"<{' '.join([f'shd.{type(self).__name__}', *parts])}>"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __reduce__(self):
        raise TypeError(f"a {type(self).__name__} cannot be pickled; pickle its desc")

    def _info(self, name, function=None):
        keep, out = [], _api.new(name)
        get = getattr(_api.lib, function or f"{self._kind}_get_info")
        _api.check(get(self.handle(self._kind, keep), ctypes.addressof(out)))
        return read_struct(name, out)


def read_columns(function, arguments, array, kind="shd_f32_out", count=0):
    """Calls a function that writes `count` columns: the last axis of a packed array, and no data for further ones."""
    width = array.shape[-1]
    out = (_api.struct_type(kind) * max(width, count))()
    for i in range(width):
        out[i].data = address(array) + i * array.itemsize
        out[i].stride = width * array.itemsize
    _api.check(function(*arguments, ctypes.addressof(out)))
    return array


def size_text(info, texel_format):
    """512x512 RGBA8_SRGB."""
    return [f"{info['width']}x{info['height']}", texel_format.name]


def counted(number, noun):
    return f"{number} {noun}{'' if number == 1 else 's'}"


def option_texts(desc):
    """The options of a desc that are numbers and names: filter=ewa."""
    return [f"{k}={v.name.lower() if isinstance(v, enum.Enum) else v}" for k, v in desc._values.items()
            if isinstance(v, (str, int, float))]


def make_desc(struct, desc, values):
    if desc is not None and values:
        return desc.replace(**values)
    return desc if desc is not None else desc_type(struct)(**values)


def document(cls):
    """Adds the texts of the headers to a class."""
    texts = [cls.__doc__ or "", _api.words.python(_api.functions[f"{cls._kind}_create"].get("doc", "")),
             desc_type(f"{cls._kind}_desc").__doc__]
    cls.__doc__ = "\n\n".join(filter(None, texts))
    return cls


class _Simple(Object):
    """An object that is made from a desc alone."""

    def __init__(self, context, desc=None, **values):
        keep, made = [], make_desc(f"{self._kind}_desc", desc, values)
        built = made.build(keep)
        self._adopt(keep, getattr(_api.lib, f"{self._kind}_create"), context.handle("shd_context", keep),
                    ctypes.addressof(built), path=self._path(made))
        self._options = option_texts(made)

    @staticmethod
    def _path(made):
        """The file that the desc names, for errors."""
        return None


@document
class Context(Object):
    """Context(worker_count=4, ...): memory, threads and SIMD target of the objects that are made from it.

    `log` is a logging.Logger, or a function log(level, message).
    """

    _kind = "shd_context"

    def __init__(self, desc=None, **values):
        keep = []
        built = make_desc("shd_context_desc", desc, values).build(keep)
        self._adopt(keep, _api.lib.shd_context_create, ctypes.addressof(built))

    def _parts(self):
        return [counted(self.worker_count, "worker"), self.simd_target]

    @property
    def simd_target(self):
        """Name of the instructions, such as "AVX2"."""
        return _api.lib.shd_context_get_simd_target(self.handle("shd_context", [])).decode()

    @property
    def worker_count(self):
        """Number of threads that work on a frame."""
        return _api.lib.shd_context_get_worker_count(self.handle("shd_context", []))


@document
class Sampler(_Simple):
    """Sampler(context, filter="ewa", ...)."""

    _kind = "shd_sampler"


@document
class Material(_Simple):
    """Material(context, model="blinn_phong", slots=[slot("diffuse", texture)], ...)."""

    _kind = "shd_material"


@document
class Light(_Simple):
    """Light(context, kind="directional", direction=(0, -1, 0), ...)."""

    _kind = "shd_light"


VECTORS = (("position", 3), ("normal", 3), ("tangent", 4), ("uv", 2), ("uv1", 2))  # columns of a mesh, with widths


@document
class Mesh(Object):
    """Mesh(context, position, indices=None, uv=None, normal=None, ...).

    `position` and `normal` are arrays [n][3] or three columns, `uv` is [n][2]. `indices` is an array of integers of any
    size; numbers of other types than float32, uint32 and uint16 are converted once. `uv_projection` computes uv from
    positions: "planar", "spherical", "cylindrical" or "box", through the matrix `object_to_projection`.
    """

    _kind = "shd_mesh"

    def __init__(self, context, position=None, indices=None, desc=None, **values):
        keep = []
        made = make_desc("shd_mesh_desc", desc, values)
        if position is not None:
            made = made.replace(position=position)
        made = made.replace(**{name: batch(made._values[name], f"mesh.{name}") for name, _ in VECTORS
                               if made._values.get(name) is not None})
        if indices is not None:
            indices = array_of(indices, "mesh.indices")
            if indices.dtype == np.uint16:
                made = made.replace(indices16=indices)
            else:
                made = made.replace(indices=converted(indices, np.dtype("u4"), "mesh.indices"))
        for name in ("indices", "indices16"):
            count = np.size(made._values.get(name, ()))
            if made._values.get("index_count", count) > count > 0:
                raise ValueError(f"mesh.index_count: {made.index_count}, but {name} has {count} elements")
            if count and "index_count" not in made._values:
                made = made.replace(index_count=count)
        built = made.build(keep)
        self._set_count(built, made._values)
        self._adopt(keep, _api.lib.shd_mesh_create, context.handle("shd_context", keep), ctypes.addressof(built))

    @staticmethod
    def _set_count(built, values):
        """The number of vertices, which all columns must have."""
        sizes = {"vertex_count": values["vertex_count"]} if "vertex_count" in values else {}
        for name, width in VECTORS:
            if values.get(name) is not None:
                sizes.update({f"{name}[{i}]": np.size(c) for i, c in
                              enumerate(columns(values[name], width, f"mesh.{name}"))})
        sizes.update({f"attributes[{i}]": np.size(c) for i, c in enumerate(values.get("attributes") or ())
                      if c is not None})
        if len(set(sizes.values())) > 1:
            raise ValueError("mesh: the columns have different lengths: " +
                             ", ".join(f"{k} {n}" for k, n in sizes.items()))
        built.vertex_count = next(iter(sizes.values()), 0)

    @classmethod
    def shape(cls, context, desc=None, flags=0, **values):
        """The mesh of a shape: Mesh.shape(context, kind="torus", ...)."""
        keep, made = [], cls.__new__(cls)
        built = make_desc("shd_shape_desc", desc, values).build(keep)
        made._adopt(keep, _api.lib.shd_mesh_create_shape, context.handle("shd_context", keep), ctypes.addressof(built),
                    enum_value("shd_mesh_flag", flags, "flags"))
        return made

    def _parts(self):
        info = self.info
        return [counted(info["vertex_count"], "vertex").replace("vertexs", "vertices"),
                counted(info["triangle_count"], "triangle")]

    @property
    def info(self):
        """Counts and bounds, as a dict."""
        return self._info("shd_mesh_info")

    def _vertices(self, function, width):
        keep = []
        return read_columns(function, (self.handle("shd_mesh", keep),),
                            np.empty((self.info["vertex_count"], width), np.float32))

    @property
    def positions(self):
        return self._vertices(_api.lib.shd_mesh_read_positions, 3)

    @property
    def normals(self):
        return self._vertices(_api.lib.shd_mesh_read_normals, 3)

    @property
    def tangents(self):
        return self._vertices(_api.lib.shd_mesh_read_tangents, 4)

    @property
    def uv(self):
        return self._vertices(_api.lib.shd_mesh_read_uv, 2)

    @property
    def indices(self):
        keep, flat = [], np.empty((3 * self.info["triangle_count"], 1), np.uint32)
        read_columns(_api.lib.shd_mesh_read_indices, (self.handle("shd_mesh", keep),), flat, "shd_u32_out")
        return flat.reshape(-1, 3)


def slot(target, texture=None, sampler=None, procedure=None, solid=None, **values):
    """A source for a coefficient of a material: slot("diffuse", texture, sampler), slot("height", procedure=f)."""
    sources = {"texture": texture, "procedure": procedure, "solid": solid, "vertex": values.get("attribute")}
    given = [name for name, value in sources.items() if value is not None]
    if len(given) > 1:
        raise ValueError(f"slot: one source, not {' and '.join(given)}")
    fields = {k: v for k, v in {"texture": texture, "sampler": sampler, "procedure": procedure, "solid": solid}.items()
              if v is not None}
    source = {"source": given[0]} if given and "source" not in values else {}
    return desc_type("shd_slot")(target=target, **fields, **source, **values)
