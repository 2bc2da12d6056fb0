#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs a command that writes a picture, its last argument, and decodes the picture: check_png.py COMMAND... FILE"""
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "tests" / "support"))
from png import read_png  # noqa: E402


def main(command):
    path = pathlib.Path(command[-1])
    path.unlink(missing_ok=True)
    subprocess.run(command, check=True)
    width, height, channels, rows = read_png(path)
    assert channels == 4, channels
    colours = {row[x:x + 4] for row in rows for x in range(0, len(row), 4)}
    print(f"{width} x {height} pixels, {len(colours)} colours")
    assert len(colours) > 1000, "too few colours for a shaded teapot"


if __name__ == "__main__":
    main(sys.argv[1:])
