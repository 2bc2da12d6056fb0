#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs a command that writes a picture, its last argument, and decodes the picture: check_png.py COMMAND... FILE"""
import pathlib
import struct
import subprocess
import sys
import zlib


def chunks(data):
    """Type and content of each chunk of a PNG, whose checksums must hold."""
    at = 8
    while at < len(data):
        size, = struct.unpack_from(">I", data, at)
        body = data[at + 4:at + 8 + size]
        assert zlib.crc32(body) == struct.unpack_from(">I", data, at + 8 + size)[0], "checksum of a chunk"
        yield body[:4], body[4:]
        at += 12 + size


def main(command):
    path = pathlib.Path(command[-1])
    path.unlink(missing_ok=True)
    subprocess.run(command, check=True)
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "signature"
    parts = dict(chunks(data))
    width, height = struct.unpack_from(">II", parts[b"IHDR"])
    rows = zlib.decompress(parts[b"IDAT"])
    assert len(rows) == height * (1 + 4 * width), "size of the pixels"
    colours = {rows[i:i + 4] for y in range(height)
               for i in range(y * (1 + 4 * width) + 1, (y + 1) * (1 + 4 * width), 4)}
    print(f"{width} x {height} pixels, {len(colours)} colours")
    assert len(colours) > 1000, "too few colours for a shaded teapot"


if __name__ == "__main__":
    main(sys.argv[1:])
