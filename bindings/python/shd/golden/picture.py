# SPDX-License-Identifier: MIT
"""Pictures as arrays [height][width][channels], from arrays and PNG files; their hash."""
import hashlib
import os
import pathlib

import numpy as np

from .. import _png
from .._png_read import decode

KINDS = ("uint8", "uint16", "float16", "float32", "float64")


class PictureError(ValueError):
    """A picture cannot be used: a file is malformed, or an array has another type or values that are not finite."""


def load(path):
    """A PNG file as an array [height][width][channels] of uint8 or uint16."""
    try:
        return decode(pathlib.Path(path).read_bytes())
    except ValueError as problem:
        raise PictureError(f"{path}: {problem}") from None


def save(path, picture):
    """Writes a PNG file from a picture of uint8 or uint16."""
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f"{path.name}.{os.getpid()}")  # a reader of the path finds a whole file
    temporary.write_bytes(_png.encode(np.ascontiguousarray(picture)))
    os.replace(temporary, path)


def as_picture(value, name="picture"):
    """An array [height][width][1..4] with finite values from a path, or from an array with two or three axes."""
    if isinstance(value, (str, os.PathLike)):
        return load(value)
    array = np.asarray(value)
    if array.dtype.name not in KINDS:
        raise PictureError(f"{name}: the type is {array.dtype}, not one of {', '.join(KINDS)}")
    if array.ndim == 2:
        array = array[..., np.newaxis]
    if array.ndim != 3 or array.shape[2] not in (1, 2, 3, 4) or 0 in array.shape:
        raise PictureError(f"{name}: the shape is {np.shape(value)}, not [height][width] or [height][width][1..4]")
    if array.dtype.kind == "f" and not np.isfinite(array).all():
        where = np.argwhere(~np.isfinite(array))
        raise PictureError(f"{name}: {len(where)} values are NaN or infinite, the first at {list(map(int, where[0]))} "
                           "of [height][width][channel]")
    return array


def coded(picture, name="picture"):
    """sRGB-coded numbers in [0, 1] as float64."""
    if picture.dtype.kind == "u":
        return picture / float(np.iinfo(picture.dtype).max)
    low, high = float(picture.min()), float(picture.max())
    if low < 0 or high > 1:
        raise PictureError(f"{name}: values are {low:g}..{high:g}, not in 0..1; linear pictures need hdr=True")
    return picture.astype(np.float64)


def storable(picture, name="picture"):
    """The picture as a PNG file has it: uint8 and uint16 as they are, numbers in [0, 1] as uint16."""
    if picture.dtype.kind == "u":
        return picture
    return np.rint(coded(picture, name) * 65535).astype(np.uint16)


def picture_hash(picture):
    """SHA-256 of the shape, the type and the little-endian bits: equal on every machine. A zero with a sign differs."""
    array = np.ascontiguousarray(picture)
    array = array.astype(array.dtype.newbyteorder("<"), copy=False)
    head = f"{'x'.join(map(str, array.shape))} {array.dtype.name}\n".encode("ascii")
    return hashlib.sha256(head + array.tobytes()).hexdigest()
