# SPDX-License-Identifier: MIT
"""PNG files of 8-bit pixels, after "PNG (Portable Network Graphics) Specification" (third edition, 2023)."""
import struct
import zlib

import numpy as np


def encode(pixels):
    """Bytes of a PNG file from an array [height][width][3 or 4] of uint8."""
    if not isinstance(pixels, np.ndarray) or pixels.ndim != 3:
        raise TypeError("pixels: an array [height][width][3 or 4], not " +
                        (f"of shape {pixels.shape}" if isinstance(pixels, np.ndarray) else type(pixels).__name__))
    height, width, channels = pixels.shape
    if pixels.dtype != np.uint8 or channels not in (3, 4):
        raise TypeError(f"pixels: [height][width][3 or 4] of uint8, not {pixels.shape} of {pixels.dtype}")
    rows = np.zeros((height, 1 + width * channels), np.uint8)  # filter 0 before each row
    rows[:, 1:] = pixels.reshape(height, -1)
    header = struct.pack(">IIBBBBB", width, height, 8, 2 if channels == 3 else 6, 0, 0, 0)
    chunks = [(b"IHDR", header), (b"sRGB", b"\0"), (b"IDAT", zlib.compress(rows.tobytes(), 6)), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
        for name, body in chunks)


def save_png(path, pixels):
    """Writes an array [height][width][3 or 4] of uint8 in sRGB as a PNG file. Needs no component."""
    encoded = encode(pixels)
    with open(path, "wb") as file:
        file.write(encoded)
