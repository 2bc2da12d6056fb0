#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The time from the start of an interpreter to its first picture, which has a limit; the best of ten runs.

Wall time counts, or the time of the processor where other programs delay this one.
"""
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
RUNS, LIMIT = 10, 0.3


def measure(command, environment):
    """Wall time and processor time of a command, each the best of several runs; the first run writes bytecode."""
    times = []
    for _ in range(RUNS + 1):
        start, before = time.perf_counter(), os.times()
        subprocess.run([sys.executable, *command], check=True, env=environment, stdout=subprocess.DEVNULL)
        after = os.times()
        times.append((time.perf_counter() - start, after.children_user + after.children_system -
                      before.children_user - before.children_system))
    return [min(column) for column in zip(*times[1:])]


def main():
    if importlib.util.find_spec("numpy") is None:
        print(f"skipped: {sys.executable} has no NumPy (Debian: python3-numpy)")
        return 77
    environment = {**os.environ, "PYTHONPATH": str(HERE.parent)}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)  # an installed package has its bytecode
    with tempfile.TemporaryDirectory() as folder:
        environment["PYTHONPYCACHEPREFIX"] = folder
        wall, processor = measure(["-m", "shd", f"{folder}/picture.png"], environment)
        base, _ = measure(["-c", "import numpy"], environment)
    print(f"first picture {wall:.3f} s, of which the interpreter and NumPy {base:.3f} s; processor {processor:.3f} s; "
          f"limit {LIMIT} s")
    return int(min(wall, processor) > LIMIT)


if __name__ == "__main__":
    sys.exit(main())
