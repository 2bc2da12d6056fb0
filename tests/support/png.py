# SPDX-License-Identifier: MIT
"""A reader of PNG files of 8 bits without interlacing and palettes, which needs no other package. Tests compare pictures
by it."""
import struct
import zlib

CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}  # by the colour types of PNG


def read_png(path):
    """Width, height, channels and rows of bytes. Raises an exception for any other file."""
    with open(path, "rb") as file:
        data = file.read()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError(f"{path}: no PNG file")
    offset, packed = 8, b""
    while offset < len(data):
        size, kind = struct.unpack_from(">I4s", data, offset)
        chunk = data[offset + 8:offset + 8 + size]
        if zlib.crc32(kind + chunk) != struct.unpack_from(">I", data, offset + 8 + size)[0]:
            raise ValueError(f"{path}: checksum of {kind}")
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlaced = struct.unpack(">IIBBBBB", chunk)
        packed += chunk if kind == b"IDAT" else b""
        offset += size + 12
    if depth != 8 or interlaced or color not in CHANNELS:
        raise ValueError(f"{path}: depth {depth}, colour type {color}, interlaced {interlaced}")
    channels = CHANNELS[color]
    rows = unfilter(zlib.decompress(packed), width * channels, channels)
    if len(rows) != height or len(rows[-1]) != width * channels:
        raise ValueError(f"{path}: {len(rows)} rows, not {height}")
    return width, height, channels, rows


def unfilter(data, stride, channels):
    rows, above = [], bytes(stride)
    for start in range(0, len(data), stride + 1):
        kind, row = data[start], bytearray(data[start + 1:start + 1 + stride])
        for i in range(len(row)):
            left = row[i - channels] if i >= channels else 0
            corner = above[i - channels] if i >= channels else 0
            row[i] = row[i] + predict(kind, left, above[i], corner) & 255
        rows.append(bytes(row))
        above = row
    return rows


def predict(kind, left, up, corner):
    """Portable Network Graphics Specification, 9.2: filter types."""
    if kind < 4:
        return (0, left, up, (left + up) // 2)[kind]
    distances = [abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)]
    return (left, up, corner)[distances.index(min(distances))]
