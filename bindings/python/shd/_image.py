# SPDX-License-Identifier: MIT
"""Arrays as images and textures: [height][width][channels]. Arrays that fit are not copied."""
import numpy as np

from . import _api
from ._array import pixels_of
from ._convert import address

KINDS = {"uint8": "8", "uint16": "16", "float16": "16F", "float32": "32F"}
LAYOUTS = {"R": 1, "RG": 2, "RGB": 3, "RGBA": 4}
FACES = 6  # of a cube


def format_of(array, srgb, name):
    """The format of an array whose last axis has the channels."""
    kind, channels = KINDS.get(array.dtype.name), array.shape[-1]
    if kind is None:
        codes = "; .astype(numpy.uint8) converts codes 0..255"
        cure = {"i": codes, "u": codes, "f": "; .astype(numpy.float32) converts it"}.get(array.dtype.kind, "")
        raise TypeError(f"{name}: the array is of {array.dtype}, not {', '.join(KINDS)}{cure}")
    if srgb and kind != "8":
        raise TypeError(f"{name}: sRGB texels are of uint8, not {array.dtype}")
    if not 1 <= channels <= 4:
        first = array.shape[-3] if array.ndim > 2 else 0
        cure = "; numpy.moveaxis(array, -3, -1) gives the channels the last axis" if 1 <= first <= 4 else ""
        raise ValueError(f"{name}: {channels} channels, not 1 to 4; images are [height][width][channels]{cure}")
    layout = next(k for k, n in LAYOUTS.items() if n == channels)
    return int(_api.enum_type("shd_format")[f"{layout}{kind}" + ("_SRGB" if srgb else "")])


def array_type(texel_format):
    """Type and channels of the arrays of a format."""
    name = _api.enum_type("shd_format")(texel_format).name.removesuffix("_SRGB")
    layout = name.rstrip("0123456789F")
    kind = name.removeprefix(layout)
    return np.dtype(next(d for d, k in KINDS.items() if k == kind)), LAYOUTS[layout]


def split(image, axes, name, in_place=False):
    """The array of an image with an axis of channels behind `axes` others, whose pixels are packed; rows may be apart.

    Other orders of memory are copied, unless the library uses the array in place. float64 becomes float32.
    """
    if in_place and not isinstance(image, np.ndarray):
        raise TypeError(f"{name}: a NumPy array, not {type(image).__name__}")
    array = pixels_of(image, name)
    if array.dtype == np.float64 and not in_place:
        array = array.astype(np.float32)
    if array.ndim == axes:
        array = array[..., np.newaxis]
    if array.ndim != axes + 1:
        raise ValueError(f"{name}: {array.ndim} axes, not {axes} or {axes + 1}; images are [height][width][channels]")
    if not array.size:
        raise ValueError(f"{name}: the array is empty")
    size, channels = array.dtype.itemsize, array.shape[-1]
    packed = (channels == 1 or array.strides[-1] == size) and (array.shape[-2] == 1 or
                                                              array.strides[-2] == size * channels)
    if packed and all(s >= 0 for s in array.strides) and array.dtype.isnative:
        return array
    if in_place:
        raise ValueError(f"{name}: rows in order with packed channels; numpy.ascontiguousarray() copies them")
    return np.ascontiguousarray(array, array.dtype.newbyteorder("="))


def image(array, keep, name="image", srgb=False, texel_format=None, in_place=False):
    """A shd_image over an array."""
    array = split(array, 2, name, in_place)
    made = _api.new("shd_image")
    made.format = texel_format or format_of(array, srgb, name)
    made.height, made.width = array.shape[:2]
    made.pixels = address(array)
    made.row_stride = array.strides[0] if array.shape[0] > 1 else 0
    keep += [array, made]
    return made
