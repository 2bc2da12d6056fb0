#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs a program of the tutorial and compares its picture with the one of its page.

    check_picture.py PROGRAM STORED.png [FILE...]

PROGRAM gets the files as arguments, and writes PROGRAM.png, named after itself, into the current folder. Exits with 77,
as CTest skips tests, if a file is absent. Decoders of other versions may give other texels of a JPEG file, so
channels may differ by 2 codes; at most 1 pixel of 1000 may differ by more.
"""
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "support"))
from png import read_png  # noqa: E402

LARGEST, MOST = 2, 1 / 1000


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
