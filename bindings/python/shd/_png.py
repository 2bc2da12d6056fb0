# SPDX-License-Identifier: MIT
"""Writes PNG files, after "PNG (Portable Network Graphics) Specification" (third edition, 2023)."""
import struct
import zlib

import numpy as np

from . import _srgb
from ._array import pixels_of

COLOUR_TYPES = {1: 0, 2: 4, 3: 2, 4: 6}


def encode(pixels):
    """Bytes of a PNG file from an array [height][width][1..4] of sRGB-coded uint8 or uint16; 2 and 4 have alpha."""
    if not isinstance(pixels, np.ndarray) or pixels.ndim != 3:
        raise TypeError("pixels: an array [height][width][1..4], not " +
                        (f"of shape {pixels.shape}" if isinstance(pixels, np.ndarray) else type(pixels).__name__))
    height, width, channels = pixels.shape
    if pixels.dtype not in (np.uint8, np.uint16) or channels not in COLOUR_TYPES:
        raise TypeError(f"pixels: [height][width][1..4] of uint8 or uint16, not {pixels.shape} of {pixels.dtype}")
    if not pixels.size:
        raise ValueError("pixels: the array is empty")
    size = pixels.dtype.itemsize
    rows = np.zeros((height, 1 + width * channels * size), np.uint8)  # filter 0 before each row
    rows[:, 1:] = np.ascontiguousarray(pixels, f">u{size}").view(np.uint8).reshape(height, -1)
    header = struct.pack(">IIBBBBB", width, height, 8 * size, COLOUR_TYPES[channels], 0, 0, 0)
    chunks = [(b"IHDR", header), (b"sRGB", b"\0"), (b"IDAT", zlib.compress(rows.tobytes(), 6)), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
        for name, body in chunks)


def save_png(path, pixels):
    """Writes a framebuffer, or an image [height][width][1..4] of uint8 or uint16 in sRGB, as a PNG file. Needs no
    component."""
    if hasattr(pixels, "read_color"):
        pixels = straight(pixels.read_color("rgba8_srgb"))
    array = pixels_of(pixels, "pixels")
    encoded = encode(array[..., np.newaxis] if array.ndim == 2 else array)
    with open(path, "wb") as file:
        file.write(encoded)


def straight(color):
    """Premultiplied sRGB codes of RGBA to straight ones, as PNG has them."""
    made = color.copy()
    partial = (made[..., 3] > 0) & (made[..., 3] < 255)
    if partial.any():
        opacity = made[partial][:, 3:] / 255
        linear = np.minimum(_srgb.decode(made[partial][:, :3] / 255) / opacity, 1)
        made[partial, :3] = np.rint(255 * _srgb.encode(linear))
    return made
