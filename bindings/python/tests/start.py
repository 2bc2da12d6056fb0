#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The time from the start of an interpreter to its first picture, which has a limit; the best of ten runs."""
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
RUNS, LIMIT = 10, 0.3


def main():
    if importlib.util.find_spec("numpy") is None:
        print(f"skipped: {sys.executable} has no NumPy (Debian: python3-numpy)")
        return 77
    environment = {**os.environ, "PYTHONPATH": str(HERE.parent)}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)  # an installed package has its bytecode
    with tempfile.TemporaryDirectory() as folder:
        environment["PYTHONPYCACHEPREFIX"] = folder
        times = []
        for command in (["-m", "shd", f"{folder}/picture.png"], ["-c", "import numpy"]):
            runs = []
            for _ in range(RUNS + 1):
                start = time.perf_counter()
                subprocess.run([sys.executable, *command], check=True, env=environment, stdout=subprocess.DEVNULL)
                runs.append(time.perf_counter() - start)
            times.append(min(runs[1:]))  # the first run writes bytecode
    print(f"first picture {times[0]:.3f} s, of which the interpreter and NumPy {times[1]:.3f} s; limit {LIMIT} s")
    return int(times[0] > LIMIT)


if __name__ == "__main__":
    sys.exit(main())
