#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs a program of the tutorial and compares its picture with the one of its page.

    check_picture.py PROGRAM STORED.png [FILE...]

PROGRAM gets the files as arguments, and writes PROGRAM.png, named after itself, into the current folder. Exits with 77,
as CTest skips tests, if a file is absent. Decoders of other versions may give other texels of a JPEG file, so
channels may differ by 2 codes; at most 1 pixel of 1000 may differ by more.
"""
import pathlib
import struct
import subprocess
import sys
import zlib

CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}  # by the colour types of PNG
LARGEST, MOST = 2, 1 / 1000


def read_png(path):
    """Width, height, channels and rows of a PNG file of 8 bits without interlacing."""
    data = path.read_bytes()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        sys.exit(f"{path}: no PNG file")
    offset, packed = 8, b""
    while offset < len(data):
        size, kind = struct.unpack(">I4s", data[offset:offset + 8])
        chunk = data[offset + 8:offset + 8 + size]
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlaced = struct.unpack(">IIBBBBB", chunk)
        packed += chunk if kind == b"IDAT" else b""
        offset += size + 12
    if depth != 8 or interlaced or color not in CHANNELS:
        sys.exit(f"{path}: depth {depth}, colour type {color}, interlaced {interlaced}")
    return width, height, CHANNELS[color], unfilter(zlib.decompress(packed), width * CHANNELS[color], CHANNELS[color])


def unfilter(data, stride, channels):
    rows, above = [], bytes(stride)
    for start in range(0, len(data), stride + 1):
        kind, row = data[start], bytearray(data[start + 1:start + 1 + stride])
        for i in range(stride):
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


def compare(made, stored):
    """The part of the pixels that differ by more than LARGEST."""
    if made[:3] != stored[:3]:
        sys.exit(f"width, height and channels are {made[:3]}, not {stored[:3]}")
    width, height, channels = made[:3]
    count = 0
    for row, other in zip(made[3], stored[3]):
        far = [abs(a - b) > LARGEST for a, b in zip(row, other)]
        count += sum(any(far[x:x + channels]) for x in range(0, width * channels, channels))
    return count / (width * height)


def main():
    program, stored, files = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), sys.argv[3:]
    for file in files:
        if not pathlib.Path(file).is_file():
            print(f"{file} is not there; Debian: assimp-testmodels")
            sys.exit(77)
    picture = pathlib.Path(f"{program.name}.png")
    picture.unlink(missing_ok=True)
    subprocess.run([program, *files], check=True)
    part = compare(read_png(picture), read_png(stored))
    print(f"{picture}: {100 * part:.3f} % of the pixels differ from {stored}")
    sys.exit(part > MOST)


main()
