#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs shd-check on correct, wrong and malformed tables of lookups.

    check_shd_check.py PROGRAM FOLDER

The files are written here, without NumPy.
"""
import os
import math
import pathlib
import random
import struct
import subprocess
import sys

SIZE = 8


def npy(path, type_, shape, data):
    """Writes a .npy file of version 1; `type_` is the text of its descr."""
    header = f"{{'descr': {type_}, 'fortran_order': False, 'shape': {shape}, }}"
    header += " " * (-(len(header) + 11) % 64) + "\n"
    path.write_bytes(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() + data)


def shdlook(path, names, rows):
    columns = [struct.pack(f"<{len(rows)}f", *(row[c] for row in rows)) for c in range(len(names))]
    path.write_bytes(b"SHDLOOK1" + struct.pack("<IQ", len(names), len(rows)) +
                     b"".join(n.encode().ljust(16, b"\0") for n in names) + b"".join(columns))


def csv(path, names, rows):
    path.write_text("\n".join([",".join(names), *(",".join(repr(x) for x in row) for row in rows)]) + "\n")


def bilinear(texels, u, v):
    """A correct result: REPEAT, red of an image of one channel."""
    x, y = u * SIZE - 0.5, v * SIZE - 0.5
    i, j = math.floor(x), math.floor(y)
    s, t = x - i, y - j
    def texel(column, row):
        return texels[row % SIZE * SIZE + column % SIZE] / 255
    return ((1 - s) * (1 - t) * texel(i, j) + s * (1 - t) * texel(i + 1, j) + (1 - s) * t * texel(i, j + 1)
            + s * t * texel(i + 1, j + 1))


class Checker:
    def __init__(self, program, folder):
        self.program, self.folder, self.failures, self.count = program, folder, 0, 0

    def run(self, name, arguments, code, *texts):
        """One call, its exit code, and texts that it prints."""
        done = subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True, timeout=60,
                              check=False)
        output = done.stdout + done.stderr
        self.count += 1
        if done.returncode != code or any(text not in output for text in texts):
            self.failures += 1
            print(f"{name}: exit {done.returncode} instead of {code}, expected {texts}, got:\n{output}")


def main():
    folder = pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    check = Checker(sys.argv[1], folder)
    numbers = random.Random(1)
    texels = [numbers.randrange(256) for _ in range(SIZE * SIZE)]
    image = folder / "image.npy"
    npy(image, "'|u1'", f"({SIZE}, {SIZE})", bytes(texels))
    names = ["u", "v", "r"]
    points = [(numbers.random(), numbers.random()) for _ in range(100)]
    right = [(u, v, bilinear(texels, u, v)) for u, v in points]
    shifted = [(u, v, bilinear(texels, u + 0.5 / SIZE, v)) for u, v in points]
    base = ["--filter", "bilinear", image]
    path = {kind: folder / f"lookups.{kind}" for kind in ("csv", "npy", "bin")}

    # Each form of file: correct results, and results with a shift of half a texel.
    for rows, code in ((right, 0), (shifted, 1)):
        csv(path["csv"], names, rows)
        npy(path["npy"], "[('u', '<f4'), ('v', '<f8'), ('r', '<f4')]", "(100,)",
            b"".join(struct.pack("<fdf", *row) for row in rows))
        shdlook(path["bin"], names, rows)
        for kind, file in path.items():
            text = "0 of 100 lookups are not legal" if code == 0 else "nearest legal value"
            check.run(f"{kind}/{code}", [*base, file], code, text)
        npy(path["npy"], "'<f4'", "(100, 3)", b"".join(struct.pack("<fff", *row) for row in rows))
        check.run(f"npy_2d/{code}", ["--columns", "u,v,r", *base, path["npy"]], code)
    for rules in ("vulkan", "d3d11", "webgpu", "opengl"):
        csv(path["csv"], names, right)
        check.run(rules, ["--rules", rules, *base, path["csv"]], 0)
    check.run("texels", ["--list", "1", *base, path["bin"]], 1, "texels (layer level x y: weight): (0 0 ")

    # Results that are not numbers, or not finite.
    for name, value in (("nan", "nan"), ("inf", "inf"), ("minus_inf", "-inf")):
        path["csv"].write_text(f"u,v,r\n0.5,0.5,{value}\n")
        check.run(name, [*base, path["csv"]], 1, "1 of 1 lookups are not legal", value)
    path["csv"].write_text("u,v,r\n")
    check.run("no_rows", [*base, path["csv"]], 0, "0 of 0")

    # Malformed tables.
    bad_texts = {
        "empty": ("", "empty; the first line names the columns"),
        "short_line": ("u,v,r\n0.1,0.2\n", "line 2 has 2 numbers, but the first line names 3"),
        "long_line": ("u,v,r\n0,0,0\n1,2,3,4\n", "line 3 has 4 numbers"),
        "word": ("u,v,r\n0.1,abc,0\n", "line 2: \"abc\" is not a number"),
        "twice": ("u,v,u\n", "two columns have the name u"),
        "unnamed": ("u,,r\n", "a column has no name"),
        "unknown": ("u,v,r,x\n0,0,0,0\n", "column x is not known"),
        "no_v": ("u,r\n0,0\n", "no columns u and v"),
        "no_result": ("u,v\n0,0\n", "no column r, g, b or a"),
        "not_text": ("\x00\x01\x02", ""),
    }
    for name, (text, message) in bad_texts.items():
        path["csv"].write_text(text)
        check.run(name, [*base, path["csv"]], 3, message)
    shdlook(path["bin"], names, right)
    whole = path["bin"].read_bytes()
    for name, data, message in (
            ("bin_header", whole[:15], "shorter than the header"),
            ("bin_cut", whole[:-1], "bytes are not 3 columns of 100 rows"),
            ("bin_long", whole + b"1", "bytes are not 3 columns"),
            ("bin_columns", whole[:8] + struct.pack("<I", 2**31) + whole[12:], "columns are not in 1..64"),
            ("bin_rows", whole[:12] + struct.pack("<Q", 2**62) + whole[20:], "bytes are not 3 columns")):
        path["bin"].write_bytes(data)
        check.run(name, [*base, path["bin"]], 3, message)
    pixels = b"\0" * 64
    for name, type_, shape, data, message in (
            ("npy_short", "'<f4'", "(100, 3)", pixels, "the file is shorter than its array"),
            ("npy_long", "'<f4'", "(1, 3)", pixels, "the file is longer than its array"),
            ("npy_huge", "'<f4'", "(99999999999, 99999999999)", pixels, "the file is shorter"),
            ("npy_digits", "'<f4'", "(99999999999999999999, 1)", pixels, "the shape is too large"),
            ("npy_type", "'<c8'", "(8,)", pixels, "type <c8 is not one of"),
            ("npy_order", "'>f4'", "(16,)", pixels, "type >f4 is not one of"),
            ("npy_columns", "'<f4'", "(4, 4)", pixels, "one column for each of --columns")):
        npy(path["npy"], type_, shape, data)
        check.run(name, [*base, path["npy"]], 3, message)
    path["npy"].write_bytes(b"\x93NUMPY\x01\x00\xff\xff")
    check.run("npy_header", [*base, path["npy"]], 3, ".npy")
    csv(path["csv"], names, right)
    npy(path["npy"], "'|u1'", "(2, 2, 5)", bytes(20))
    check.run("image_channels", [path["npy"], path["csv"]], 3, "channels are not 1..4")
    check.run("image_absent", [folder / "absent.png", path["csv"]], 3, "absent.png")
    check.run("table_absent", [*base, folder / "absent.csv"], 3, "absent.csv")
    fifo = folder / "fifo"
    fifo.unlink(missing_ok=True)
    os.mkfifo(fifo)
    check.run("image_fifo", [fifo, path["csv"]], 3, "fifo: is not a regular file")
    check.run("table_fifo", [*base, fifo], 3, "fifo: is not a regular file")

    # Results as an image.
    npy(path["npy"], "'<f4'", "(10, 10, 4)", b"".join(struct.pack("<4f", r, 0, 0, 1) for _, _, r in right))
    csv(path["csv"], ["u", "v"], points)
    check.run("results", ["--results", path["npy"], *base, path["csv"]], 0, "0 of 100")
    pfm = folder / "results.pfm"
    for rows, code in ((right, 0), (shifted, 1)):
        pfm.write_bytes(b"Pf\n100 1\n-1.0\n" + b"".join(struct.pack("<f", r) for _, _, r in rows))
        check.run(f"results_pfm/{code}", ["--results", pfm, *base, path["csv"]], code, "of 100")
    check.run("results_codes", ["--results", image, *base, path["csv"]], 3, "results are not floats")
    csv(path["csv"], ["u", "v"], points[1:])
    check.run("results_count", ["--results", path["npy"], *base, path["csv"]], 3, "100 pixels, but 99 lookups")

    # Command lines.
    check.run("help", ["--help"], 0, "Usage: shd-check")
    for name, arguments, message in (
            ("none", [], "two files are needed"),
            ("filter", ["--filter", "ewa", "a", "b"], "\"ewa\" is not one of trilinear, nearest, bilinear"),
            ("option", ["--what", "1"], "--what is not an option"),
            ("value", ["a", "b", "--bias"], "--bias needs a value: a number"),
            ("number", ["--bias", "x", "a", "b"], "\"x\" is not a number"),
            ("misspelt", ["--fliter", "ewa"], "did you mean --filter?"),
            ("rules", ["--rules", "gl", "a", "b"], "\"gl\" is not one of"),
            ("bits", ["--subtexel-bits", "1", image, folder / "lookups.csv", "--results", path["npy"]], "")):
        check.run(f"usage/{name}", arguments, 3 if name == "bits" else 2, message)
    csv(path["csv"], names, right)
    check.run("usage/range", ["--subtexel-bits", "1", *base, path["csv"]], 2, "subtexel_bits: 1 is not in 2..24")
    check.run("usage/order", ["--subtexel-bits", "1", "--rules", "vulkan", *base, path["csv"]], 2, "subtexel_bits: 1 is")
    print(f"{check.count} calls, {check.failures} failures")
    return check.failures != 0


if __name__ == "__main__":
    sys.exit(main())
