# SPDX-License-Identifier: MIT
"""The commands `compare` and `golden` of python -m shd."""
import argparse
import pathlib
import sys

EQUAL, DIFFERENT, FAILED = 0, 1, 2


def compare(arguments):
    """Compares two PNG files. Exit codes: 0 within the tolerances, 1 different, 2 error."""
    from .golden import PIXELS_PER_DEGREE, TOLERANCES, Difference, save, side_by_side
    parser = argparse.ArgumentParser(prog="python -m shd compare", description=compare.__doc__,
                                     epilog="Without a tolerance, the pictures must be equal.")
    parser.add_argument("reference", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("-o", dest="map", type=pathlib.Path, metavar="MAP.png",
                        help="write reference, picture and FLIP map side by side")
    parser.add_argument("--pixels-per-degree", type=float, default=PIXELS_PER_DEGREE,
                        help="of the eye; default %(default).2f")
    for name, (_, text) in TOLERANCES.items():
        parser.add_argument(f"--{name.replace('_', '-')}", type=float, metavar="X", help=text)
    options = parser.parse_args(arguments)
    try:
        difference = Difference(options.reference, options.picture, options.pixels_per_degree)
        problems = difference.exceeded(**{name: getattr(options, name) for name in TOLERANCES})
        if options.map:
            save(options.map, side_by_side(difference))
        print(difference)
    except (ValueError, OSError) as problem:
        print(f"shd: {problem}", file=sys.stderr)
        return FAILED
    for problem in problems:
        print(problem)
    return DIFFERENT if problems else EQUAL


def golden(arguments):
    """Lists results of failed golden tests. Exit codes: 0 none waits, 1 some wait, 2 error."""
    from .golden import Store
    parser = argparse.ArgumentParser(prog="python -m shd golden", description=golden.__doc__)
    parser.add_argument("folder", nargs="?", default="golden", type=pathlib.Path, help="folder of the references")
    parser.add_argument("--failed", type=pathlib.Path, metavar="FOLDER", help="folder of the results, default failed/")
    parser.add_argument("--update", action="store_true", help="make the results the references")
    options = parser.parse_args(arguments)
    store = Store(options.folder, options.failed)
    try:
        if not options.folder.is_dir() and not store.failed.is_dir():
            raise ValueError(f"{options.folder}: no such folder")
        if options.update:
            for name in store.accept():
                print(f"{name}: updated")
            return EQUAL
        pictures, hashes = store.waiting()
    except (ValueError, OSError) as problem:
        print(f"shd: {problem}", file=sys.stderr)
        return FAILED
    for name in pictures + hashes:
        print(f"{name}: differs from the reference, or has none")
    return DIFFERENT if pictures or hashes else EQUAL
