# SPDX-License-Identifier: MIT
"""Reads PNG files that are not interlaced, after "PNG (Portable Network Graphics) Specification" (third edition, 2023).

Malformed files raise ValueError. A file cannot cause more memory to be used than MAX_BYTES and its own size.
"""
import struct
import zlib

import numpy as np

SIGNATURE = b"\x89PNG\r\n\x1a\n"
MAX_BYTES = 1 << 29
# colour type: (channels, bit depths)
COLOUR_TYPES = {0: (1, (1, 2, 4, 8, 16)), 2: (3, (8, 16)), 3: (1, (1, 2, 4, 8)), 4: (2, (8, 16)), 6: (4, (8, 16))}


def _chunks(data):
    """(name, body) of each chunk up to IEND."""
    if not data.startswith(SIGNATURE):
        raise ValueError("not a PNG file")
    position = len(SIGNATURE)
    while True:
        if len(data) < position + 12:
            raise ValueError("the file ends before IEND")
        length, name = struct.unpack_from(">I4s", data, position)
        end = position + 8 + length
        if len(data) < end + 4:
            raise ValueError(f"the file ends in chunk {name.decode('latin-1')!r}")
        body = data[position + 8:end]
        if zlib.crc32(name + body) != struct.unpack_from(">I", data, end)[0]:
            raise ValueError(f"chunk {name.decode('latin-1')!r} has a wrong checksum")
        yield name, body
        if name == b"IEND":
            return
        position = end + 4


class _Header:
    def __init__(self, body):
        if len(body) != 13:
            raise ValueError(f"IHDR has {len(body)} bytes, not 13")
        self.width, self.height, self.depth, self.kind = struct.unpack_from(">IIBB", body)
        compression, filters, interlace = body[10:]
        if self.width == 0 or self.height == 0 or max(self.width, self.height) >= 1 << 31:
            raise ValueError(f"the size is {self.width} x {self.height} pixels")
        if self.kind not in COLOUR_TYPES or self.depth not in COLOUR_TYPES[self.kind][1]:
            raise ValueError(f"colour type {self.kind} with {self.depth} bits does not exist")
        if compression or filters:
            raise ValueError(f"compression {compression} with filters {filters} does not exist")
        if interlace:
            raise ValueError("interlaced files cannot be read")
        self.channels = COLOUR_TYPES[self.kind][0]
        self.row = (self.width * self.channels * self.depth + 7) // 8
        if (self.row + 1) * self.height > MAX_BYTES:
            raise ValueError(f"the size is {self.width} x {self.height} pixels, more than {MAX_BYTES} bytes")


def _inflate(data, size):
    """Exactly `size` bytes."""
    stream = zlib.decompressobj()
    try:
        out = stream.decompress(data, size)
        rest = stream.decompress(stream.unconsumed_tail, 1) if len(out) == size and stream.unconsumed_tail else b""
    except zlib.error as problem:
        raise ValueError(f"IDAT: {problem}") from None
    if len(out) < size or rest:
        raise ValueError(f"IDAT has {'more' if rest else 'less'} than {size} bytes")
    return out


def _average(row, above, step):
    for i in range(len(row)):
        left = row[i - step] if i >= step else 0
        row[i] = (row[i] + (left + above[i]) // 2) & 255


def _paeth(row, above, step):
    for i in range(min(step, len(row))):
        row[i] = (row[i] + above[i]) & 255
    for i in range(step, len(row)):
        a, b, c = row[i - step], above[i], above[i - step]
        near_a, near_b, near_c = abs(b - c), abs(a - c), abs(a + b - 2 * c)
        best = a if near_a <= near_b and near_a <= near_c else b if near_b <= near_c else c
        row[i] = (row[i] + best) & 255


def _unfilter(data, header):
    """Rows [height][bytes] without their filters."""
    lines = np.frombuffer(data, np.uint8).reshape(header.height, header.row + 1)
    if lines[:, 0].max() > 4:
        raise ValueError(f"filter {lines[:, 0].max()} does not exist")
    out = lines[:, 1:].copy()
    step = max(1, header.channels * header.depth // 8)
    above = np.zeros(header.row, np.uint8)
    for row, kind in zip(out, lines[:, 0]):
        if kind == 1:
            for channel in range(step):  # additions modulo 256
                row[channel::step] = np.add.accumulate(row[channel::step], dtype=np.uint8)
        elif kind == 2:
            row += above
        elif kind >= 3:
            values = bytearray(row)
            (_average if kind == 3 else _paeth)(values, above.tobytes(), step)
            row[:] = np.frombuffer(values, np.uint8)
        above = row
    return out


def _samples(rows, header):
    """[height][width][channels] of uint8 or uint16. Grey levels of fewer than 8 bits are scaled to 0..255."""
    shape = (header.height, header.width, header.channels)
    if header.depth == 16:
        return rows.view(">u2").astype(np.uint16).reshape(shape)
    if header.depth == 8:
        return rows.reshape(shape)
    per_byte = 8 // header.depth
    shifts = np.arange(per_byte - 1, -1, -1, dtype=np.uint8) * header.depth
    values = (rows[..., np.newaxis] >> shifts) & np.uint8((1 << header.depth) - 1)
    values = values.reshape(header.height, -1)[:, :header.width].reshape(shape)
    return values if header.kind == 3 else values * np.uint8(255 // ((1 << header.depth) - 1))


def _colours(values, palette, transparency):
    """Colours of a palette: [height][width][3], or [4] with transparency."""
    if palette is None or len(palette) == 0 or len(palette) % 3 or len(palette) > 768:
        raise ValueError("PLTE is absent or has a wrong length")
    table = np.frombuffer(palette, np.uint8).reshape(-1, 3)
    if values.max() >= len(table):
        raise ValueError(f"colour {values.max()} is not in the palette of {len(table)} colours")
    if transparency is not None:
        if len(transparency) > len(table):
            raise ValueError("tRNS is longer than the palette")
        alpha = np.full(len(table), 255, np.uint8)
        alpha[:len(transparency)] = np.frombuffer(transparency, np.uint8)
        table = np.column_stack([table, alpha])
    return table[values[..., 0]]


def _keyed(pixels, transparency, header):
    """Adds alpha: the colour of tRNS is transparent."""
    if len(transparency) != 2 * header.channels:
        raise ValueError(f"tRNS has {len(transparency)} bytes, not {2 * header.channels}")
    key = np.array(struct.unpack(f">{header.channels}H", transparency), np.int64)
    if header.depth < 8:
        key *= 255 // ((1 << header.depth) - 1)
    top = np.iinfo(pixels.dtype).max
    alpha = np.where((pixels == key).all(axis=2, keepdims=True), 0, top).astype(pixels.dtype)
    return np.concatenate([pixels, alpha], axis=2)


def decode(data):
    """Pixels of a PNG file as an array [height][width][1..4] of uint8 or uint16."""
    chunks = _chunks(data)
    name, body = next(chunks)
    if name != b"IHDR":
        raise ValueError("the first chunk is not IHDR")
    header, palette, transparency, packed = _Header(body), None, None, []
    for name, body in chunks:
        if name == b"IDAT":
            packed.append(body)
        elif name == b"PLTE":
            palette = body
        elif name == b"tRNS":
            transparency = body
        elif not name[0] & 32 and name != b"IEND":
            raise ValueError(f"chunk {name.decode('latin-1')!r} is critical and has no meaning here")
    rows = _unfilter(_inflate(b"".join(packed), (header.row + 1) * header.height), header)
    pixels = _samples(rows, header)
    if header.kind == 3:
        return _colours(pixels, palette, transparency)
    if transparency is not None and header.kind in (0, 2):
        return _keyed(pixels, transparency, header)
    return pixels
