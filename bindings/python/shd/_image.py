# SPDX-License-Identifier: MIT
"""Arrays as images and textures: [height][width][channels], without a copy."""
import numpy as np

from . import _api
from ._convert import address

KINDS = {"uint8": "8", "uint16": "16", "float16": "16F", "float32": "32F"}
LAYOUTS = {"R": 1, "RG": 2, "RGB": 3, "RGBA": 4}
FACES = 6  # of a cube


def format_of(array, channels, srgb, name):
    """The format of an array with that number of channels."""
    kind = KINDS.get(array.dtype.name)
    if kind is None:
        raise TypeError(f"{name}: the array is of {array.dtype}, not {', '.join(KINDS)}")
    if srgb and kind != "8":
        raise TypeError(f"{name}: sRGB texels are of uint8, not {array.dtype}")
    if not 1 <= channels <= 4:
        raise ValueError(f"{name}: {channels} channels, not 1 to 4; images are [height][width][channels]")
    layout = next(k for k, n in LAYOUTS.items() if n == channels)
    return int(_api.enum_type("shd_format")[f"{layout}{kind}" + ("_SRGB" if srgb else "")])


def array_type(texel_format):
    """Type and channels of the arrays of a format."""
    name = _api.enum_type("shd_format")(texel_format).name.removesuffix("_SRGB")
    layout = name.rstrip("0123456789F")
    kind = name.removeprefix(layout)
    return np.dtype(next(d for d, k in KINDS.items() if k == kind)), LAYOUTS[layout]


def split(array, axes, name):
    """The array with an axis of channels behind `axes` others; pixels must be packed, rows may be apart."""
    if not isinstance(array, np.ndarray):
        raise TypeError(f"{name}: a NumPy array, not {type(array).__name__}")
    if array.ndim == axes:
        array = array[..., np.newaxis]
    if array.ndim != axes + 1:
        raise ValueError(f"{name}: {array.ndim} axes, not {axes} or {axes + 1}")
    if not array.size:
        raise ValueError(f"{name}: the array is empty")
    size, channels = array.dtype.itemsize, array.shape[-1]
    packed = (channels == 1 or array.strides[-1] == size) and (array.shape[-2] == 1 or
                                                              array.strides[-2] == size * channels)
    if not packed:
        raise ValueError(f"{name}: the channels of a row must be packed; numpy.ascontiguousarray() copies them")
    if any(s < 0 for s in array.strides):
        raise ValueError(f"{name}: rows in reverse order; numpy.ascontiguousarray() copies them")
    return array


def image(array, keep, name="image", srgb=False, texel_format=None):
    """A shd_image over an array."""
    array = split(array, 2, name)
    made = _api.new("shd_image")
    made.format = texel_format or format_of(array, array.shape[2], srgb, name)
    made.height, made.width = array.shape[:2]
    made.pixels = address(array)
    made.row_stride = array.strides[0] if array.shape[0] > 1 else 0
    keep += [array, made]
    return made
