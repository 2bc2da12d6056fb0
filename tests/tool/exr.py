# SPDX-License-Identifier: MIT
"""A reader of OpenEXR files with scan lines, without compression or with ZIP, after "OpenEXR File Layout"."""
import struct
import zlib

SIZES = {0: 4, 1: 2, 2: 4}  # uint, half, float
FORMATS = {0: "I", 1: "e", 2: "f"}


class Exr:
    """`attributes` by name as (type, bytes); `channels` by name as rows of numbers."""

    def __init__(self, path):
        with open(path, "rb") as file:
            self.data = file.read()
        magic, version = struct.unpack_from("<II", self.data)
        assert magic == 20000630 and version & 0xff == 2 and not version & 0x1a00, (magic, version)
        self.at = 8
        self.attributes = {}
        while self.data[self.at]:
            name, kind = self.text(), self.text()
            size, = struct.unpack_from("<I", self.data, self.at)
            self.attributes[name] = kind, self.data[self.at + 4:self.at + 4 + size]
            self.at += 4 + size
        self.at += 1
        box = struct.unpack("<4i", self.attributes["dataWindow"][1])
        self.width, self.height = box[2] - box[0] + 1, box[3] - box[1] + 1
        self.compression = self.attributes["compression"][1][0]
        self.layout = self.read_layout()
        self.channels = {name: [] for name, _ in self.layout}
        self.read_pixels()

    def text(self):
        end = self.data.index(b"\0", self.at)
        text = self.data[self.at:end].decode()
        self.at = end + 1
        return text

    def string(self, name):
        kind, data = self.attributes[name]
        assert kind == "string", (name, kind)
        return data.decode()

    def matrix(self, name):
        kind, data = self.attributes[name]
        assert kind == "m44f", (name, kind)
        numbers = struct.unpack("<16f", data)
        return [numbers[4 * row:4 * row + 4] for row in range(4)]

    def read_layout(self):
        data, at, layout = self.attributes["channels"][1], 0, []
        while data[at]:
            end = data.index(b"\0", at)
            layout.append((data[at:end].decode(), struct.unpack_from("<i", data, end + 1)[0]))
            at = end + 17
        return layout

    def read_pixels(self):
        rows = {0: 1, 2: 1, 3: 16}[self.compression]  # none, ZIPS, ZIP
        pixel = sum(SIZES[kind] for _, kind in self.layout)
        count = (self.height + rows - 1) // rows
        for offset in struct.unpack_from(f"<{count}Q", self.data, self.at):
            y, size = struct.unpack_from("<iI", self.data, offset)
            block = self.data[offset + 8:offset + 8 + size]
            lines = min(rows, self.height - y)
            if size < lines * self.width * pixel:
                block = unzip(block)
            at = 0
            for _ in range(lines):
                for name, kind in self.layout:
                    self.channels[name].append(struct.unpack_from(f"<{self.width}{FORMATS[kind]}", block, at))
                    at += self.width * SIZES[kind]


def unzip(block):
    """Undoes the differences of bytes, and the split into even and odd ones."""
    data = bytearray(zlib.decompress(block))
    for i in range(1, len(data)):
        data[i] = (data[i - 1] + data[i] - 128) & 255
    half = (len(data) + 1) // 2
    out = bytearray(len(data))
    out[::2], out[1::2] = data[:half], data[half:]
    return bytes(out)
