# SPDX-License-Identifier: MIT
"""shd: texture filtering, shading and software rasterisation on the CPU, with NumPy arrays.

    context = shd.Context()
    texture = shd.Texture(context, texels, tables="mipmap")
    colours = texture.sample(shd.Sampler(context, filter="trilinear"), u, v, lod=lod)

Descs (SamplerDesc, RenderDesc, Draw, Camera, ...) and enums (Filter, Model, ...) of all headers are attributes of the
module. Arrays of the library's types are not copied; other numbers, lists, images of Pillow and objects with DLPack are
converted once. Objects may be shared between threads as the C headers say; a framebuffer serves one call of render().

Components have modules of their own: shd.scene, shd.color, shd.io and shd.embree. shd.Renderer draws pictures of
meshes in few lines, and shd.pyrender has the interface of pyrender.
"""
from importlib import import_module as _import_module

try:
    import numpy as _numpy
except ModuleNotFoundError:
    raise ImportError("shd needs NumPy (Debian: python3-numpy)") from None

from . import _api
from ._api import Error, InvalidArgument, MissingFile, OutOfMemory
from ._desc import Desc, desc_type as _desc_type
from ._frame import Framebuffer, render
from ._objects import Context, Light, Material, Mesh, Object, Sampler, slot
from ._texture import Lookup, Texture

_names = {_api.camel(name): (_desc_type, name) for name, e in _api.structs.items()}
_names.update({_api.camel(name): (_api.enum_type, name) for name in _api.enums})

# Modules that are imported when a name is first used, so that a small program starts fast.
_modules = {"Environment": "_environment", "Shadow": "_shadow", "Volume": "_volume", "evaluate_solid": "_solid",
            "evaluate_polygon": "_polygon", "Polyhedron": "_polygon",
            "bake": "_bake", "bake_occlusion": "_bake", "occlusion": "_bake", "vertex_occlusion": "_bake",
            "project": "_projection", "unproject": "_projection", "convert_projection": "_projection",
            "save_png": "_png", "TileCache": "_tiles", "Color": "color", "Scene": "scene",
            "Renderer": "renderer", "Item": "renderer"}
_submodules = ("color", "embree", "golden", "io", "pyrender", "renderer", "scene")

__version__ = ".".join(str(_api.constants[f"SHD_VERSION_{part}"]) for part in ("MAJOR", "MINOR", "PATCH"))


def version():
    """Version of the library: (major, minor, patch)."""
    value = _api.lib.shd_version()
    return value >> 16, value >> 8 & 255, value & 255


def __getattr__(name):
    if name in _submodules:
        return _import_module(f"{__name__}.{name}")
    if name in _modules:
        globals()[name] = getattr(_import_module(f"{__name__}.{_modules[name]}"), name)
        return globals()[name]
    if name not in _names:
        raise AttributeError(f"module shd has no attribute {name}")
    make, entry = _names[name]
    globals()[name] = make(entry)
    return globals()[name]


__all__ = sorted({"Error", "InvalidArgument", "MissingFile", "OutOfMemory", "Desc", "Framebuffer", "render", "Context",
                  "Light", "Material", "Mesh", "Object", "Sampler", "slot", "Lookup", "Texture", "version", *_names,
                  *_modules, *_submodules} - {"renderer"})


def __dir__():
    return [*__all__, "__doc__", "__file__", "__name__", "__path__", "__version__"]
