#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""run.py [FOLDER]: runs the tests of the package, or of a subfolder. SHD_LIBRARY is the path of libshd. Exit code 77:
NumPy is absent."""
import importlib.util
import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent


def main():
    if importlib.util.find_spec("numpy") is None:
        print(f"skipped: {sys.executable} has no NumPy (Debian: python3-numpy)")
        return 77
    sys.dont_write_bytecode = True
    folder = HERE.joinpath(*sys.argv[1:2])
    sys.path[:0] = [str(HERE.parent), str(folder)]
    suite = unittest.defaultTestLoader.discover(str(folder))
    result = unittest.TextTestRunner(verbosity=1).run(suite)
    return 0 if result.wasSuccessful() and result.testsRun else 1


if __name__ == "__main__":
    sys.exit(main())
