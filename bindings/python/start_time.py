#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the time from the start of an interpreter to its first picture, the best of ten runs.

    start_time.py [--installed]      of the package in this folder, or of the one that is installed
"""
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
RUNS, MARK = 10, 0.3


def measure(command, environment):
    """Seconds of a command, the best of several runs; the first run writes bytecode."""
    times = []
    for _ in range(RUNS + 1):
        start = time.perf_counter()
        subprocess.run([sys.executable, *command], check=True, env=environment, stdout=subprocess.DEVNULL)
        times.append(time.perf_counter() - start)
    return min(times[1:])


def main():
    if importlib.util.find_spec("numpy") is None:
        print(f"{sys.executable} has no NumPy (Debian: python3-numpy)")
        return 1
    environment = {**os.environ, **({} if "--installed" in sys.argv[1:] else {"PYTHONPATH": str(HERE)})}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)  # an installed package has its bytecode
    with tempfile.TemporaryDirectory() as folder:
        environment["PYTHONPYCACHEPREFIX"] = folder
        first = measure(["-m", "shd", f"{folder}/picture.png"], environment)
        base = measure(["-c", "import numpy"], environment)
    print(f"python: first picture {first:.3f} s, of which the interpreter and NumPy {base:.3f} s; mark {MARK} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
