# SPDX-License-Identifier: MIT
"""Golden tests: pictures are compared with stored references.

    difference = golden.compare(reference, picture)           arrays, or paths of PNG files
    difference.max_abs, difference.rms, difference.pixels, difference.max_flip, difference.flip
    golden.Store("golden").check(picture, "torus", max_flip=0.1)

pytest has the fixture `golden` (shd.pytest_plugin), and a shell `python -m shd compare A.png B.png`.
"""
from .difference import TOLERANCES, Difference, compare
from .flip import PIXELS_PER_DEGREE
from .picture import PictureError, as_picture, load, picture_hash, save
from .report import heat, side_by_side
from .store import GoldenError, Store

__all__ = ["TOLERANCES", "Difference", "compare", "PIXELS_PER_DEGREE", "PictureError", "as_picture", "load",
           "picture_hash", "save", "heat", "side_by_side", "GoldenError", "Store"]
