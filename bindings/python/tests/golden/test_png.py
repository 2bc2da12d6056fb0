# SPDX-License-Identifier: MIT
"""The reader of PNG files: every format and filter, written by an encoder of the test, and malformed files."""
import random
import struct
import unittest
import zlib

import numpy as np

from shd import _png
from shd._png_read import COLOUR_TYPES, MAX_BYTES, decode

RANDOM = np.random.default_rng(7)


def chunk(name, body):
    return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))


def file(width, height, depth, kind, rows, *more, interlace=0):
    """A PNG file of filtered rows."""
    header = struct.pack(">IIBBBBB", width, height, depth, kind, 0, 0, interlace)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + b"".join(chunk(*m) for m in more)
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def predicted(kind, left, up, corner):
    """The prediction of a filter, in the words of section 9.2 of the specification."""
    if kind == 4:
        p = left + up - corner
        distances = abs(p - left), abs(p - up), abs(p - corner)
        return (left, up, corner)[distances.index(min(distances))]
    return (0, left, up, (left + up) // 2)[kind]


def filtered(rows, step, kinds):
    """Rows of bytes with a filter each."""
    out, above = b"", bytes(len(rows[0]))
    for kind, row in zip(kinds, rows):
        line = bytearray([kind])
        for i, value in enumerate(row):
            left, corner = (row[i - step], above[i - step]) if i >= step else (0, 0)
            line.append((value - predicted(kind, left, above[i], corner)) & 255)
        out, above = out + bytes(line), row
    return out


def packed(samples, depth):
    """Rows [height][width * channels] of samples as bytes."""
    rows = []
    for row in samples:
        bits = "".join(f"{int(v):0{depth}b}" for v in row)
        bits += "0" * (-len(bits) % 8)
        rows.append(bytes(int(bits[i:i + 8], 2) for i in range(0, len(bits), 8)))
    return rows


def make(width, height, depth, kind, kinds=None, *more):
    """(file, samples [height][width][channels]) with random samples."""
    channels = COLOUR_TYPES[kind][0]
    samples = RANDOM.integers(0, 1 << depth, (height, width * channels))
    rows = packed(samples, depth)
    kinds = kinds or [y % 5 for y in range(height)]
    data = file(width, height, depth, kind, filtered(rows, max(1, channels * depth // 8), kinds), *more)
    return data, samples.reshape(height, width, channels)


class Formats(unittest.TestCase):
    def test_all_depths_and_filters(self):
        for kind, (channels, depths) in COLOUR_TYPES.items():
            for depth in depths:
                for width, height in ((1, 1), (3, 7), (13, 11)):
                    with self.subTest(kind=kind, depth=depth, size=(width, height)):
                        palette = RANDOM.integers(0, 256, (1 << min(depth, 8), 3)).astype(np.uint8)
                        more = [(b"PLTE", palette.tobytes())] if kind == 3 else []
                        data, samples = make(width, height, depth, kind, None, *more)
                        pixels = decode(data)
                        if kind == 3:
                            samples = palette[samples[..., 0]]
                        elif depth < 8:
                            samples = samples * 255 // ((1 << depth) - 1)
                        self.assertEqual(pixels.dtype, np.uint16 if depth == 16 else np.uint8)
                        np.testing.assert_array_equal(pixels, samples)

    def test_each_filter_in_the_first_row(self):
        for kind in range(5):
            data, samples = make(9, 1, 8, 6, [kind])
            np.testing.assert_array_equal(decode(data), samples)

    def test_data_in_several_chunks(self):
        data, samples = make(9, 8, 8, 2)
        start = data.index(b"IDAT") - 4
        body = data[start + 8:start + 8 + struct.unpack_from(">I", data, start)[0]]
        split = (data[:start] + chunk(b"IDAT", body[:5]) + chunk(b"IDAT", b"") + chunk(b"IDAT", body[5:])
                 + chunk(b"IEND", b""))
        np.testing.assert_array_equal(decode(split), samples)

    def test_transparency(self):
        data = file(2, 1, 8, 3, b"\0\1\0", (b"PLTE", bytes(range(6))), (b"tRNS", b"\x40"))
        self.assertEqual(decode(data).tolist(), [[[3, 4, 5, 255], [0, 1, 2, 64]]])
        data = file(2, 1, 8, 0, b"\0\7\x08", (b"tRNS", b"\0\7"))
        self.assertEqual(decode(data).tolist(), [[[7, 0], [8, 255]]])
        data = file(1, 1, 16, 2, b"\0" + bytes(range(6)), (b"tRNS", bytes(range(6))))
        self.assertEqual(decode(data).tolist(), [[[1, 0x203, 0x405, 0]]])

    def test_the_writer(self):
        for dtype in (np.uint8, np.uint16):
            for channels in (1, 2, 3, 4):
                pixels = RANDOM.integers(0, np.iinfo(dtype).max, (5, 7, channels), dtype)
                np.testing.assert_array_equal(decode(_png.encode(pixels)), pixels)
        with self.assertRaisesRegex(TypeError, "of uint8 or uint16, not"):
            _png.encode(np.zeros((2, 2, 5), np.uint8))


class Malformed(unittest.TestCase):
    def refuse(self, pattern, data):
        with self.assertRaisesRegex(ValueError, pattern):
            decode(data)

    def test_messages(self):
        good, _ = make(4, 4, 8, 6)
        self.refuse("not a PNG file", b"")
        self.refuse("not a PNG file", b"GIF89a")
        self.refuse("ends before IEND", good[:-12])
        self.refuse("ends in chunk 'IDAT'", good[:60])
        self.refuse("wrong checksum", good[:50] + bytes([good[50] ^ 1]) + good[51:])
        self.refuse("0 x 4 pixels", file(0, 4, 8, 6, b""))
        self.refuse("colour type 5 with 8 bits", file(1, 1, 8, 5, b""))
        self.refuse("colour type 2 with 4 bits", file(1, 1, 4, 2, b""))
        self.refuse("interlaced", file(1, 1, 8, 0, b"\0\0", interlace=1))
        self.refuse("IDAT has less than 20 bytes", file(4, 4, 8, 0, b"\0" * 19))
        self.refuse("IDAT has more than 20 bytes", file(4, 4, 8, 0, b"\0" * 21))
        self.refuse("filter 5 does not exist", file(1, 1, 8, 0, b"\5\0"))
        self.refuse("PLTE is absent", file(1, 1, 8, 3, b"\0\0"))
        self.refuse("colour 1 is not in the palette of 1", file(1, 1, 8, 3, b"\0\1", (b"PLTE", b"abc")))
        self.refuse("tRNS is longer", file(1, 1, 8, 3, b"\0\0", (b"PLTE", b"abc"), (b"tRNS", b"ab")))
        self.refuse("tRNS has 2 bytes, not 6", file(1, 1, 8, 2, b"\0abc", (b"tRNS", b"ab")))
        self.refuse("'ABCD' is critical", file(1, 1, 8, 0, b"\0\0", (b"ABCD", b"")))
        self.refuse("first chunk is not IHDR", b"\x89PNG\r\n\x1a\n" + chunk(b"IDAT", b""))
        self.refuse("IHDR has 3 bytes", b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", b"abc"))

    def test_a_small_file_cannot_ask_for_much_memory(self):
        self.refuse(f"more than {MAX_BYTES} bytes", file(1 << 30, 1 << 30, 8, 6, b""))
        self.refuse("less than", file(20000, 6000, 8, 6, b"\0"))

    def test_truncations_and_flipped_bits(self):
        choose = random.Random(3)
        seeds = [make(5, 6, depth, kind, None, *([(b"PLTE", bytes(3 << depth))] if kind == 3 else []))[0]
                 for kind, (_, depths) in COLOUR_TYPES.items() for depth in depths]
        outcomes = {True: 0, False: 0}
        for seed in seeds:
            for _ in range(150):
                data = bytearray(seed[:choose.randrange(len(seed))] if choose.random() < 0.2 else seed)
                for _ in range(choose.randrange(1, 5) if data else 0):
                    data[choose.randrange(len(data))] ^= 1 << choose.randrange(8)
                outcomes[self.survives(repaired(bytes(data)) if choose.random() < 0.7 else bytes(data))] += 1
        self.assertGreater(min(outcomes.values()), 100, outcomes)

    def survives(self, data):
        """Any file is decoded, or refused with a ValueError."""
        try:
            self.assertIn(decode(data).ndim, (3,))
            return True
        except ValueError:
            return False


def repaired(data):
    """The file with right checksums, so that damage reaches the parser behind them."""
    out, position = data[:8], 8
    while position + 12 <= len(data):
        length = struct.unpack_from(">I", data, position)[0]
        end = min(position + 8 + length, len(data) - 4)
        out += data[position:end] + struct.pack(">I", zlib.crc32(data[position + 4:end]))
        position = end + 4
    return out


if __name__ == "__main__":
    unittest.main()
