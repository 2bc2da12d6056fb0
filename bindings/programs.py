#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the three programs of the bindings with the stored hashes and with each other's speed.

    programs.py check COMMAND...     the lines that a command prints are those of programs.txt
    programs.py speed LIST           a table of the times of every command of a list, with C first

A line of the list has the name of a binding, the mark for the cost of one call [ns] or "-" for none, and the command,
separated by tabs; the CMake build writes it. Each command prints its hashes, or its times with --speed (bindings/c/programs.c).
"""
import pathlib
import re
import shlex
import subprocess
import sys

STORED = pathlib.Path(__file__).resolve().parent / "programs.txt"
ROUNDS = 5
BATCH_MARK = 1.03


def check(command):
    run = subprocess.run(command, stdout=subprocess.PIPE, text=True)
    if run.returncode:
        print(f"exit code {run.returncode}")
        return 1
    stored, printed = STORED.read_text(encoding="utf-8").split("\n"), run.stdout.split("\n")
    for want, got in zip(stored, printed + [""] * len(stored)):
        if want:
            print(f"{want}   {'equal' if got == want else 'not ' + repr(got)}")
    return int(stored != printed)


def times(command):
    """Nanoseconds of a call and milliseconds of a batch."""
    run = subprocess.run([*command, "--speed"], stdout=subprocess.PIPE, text=True, check=True)
    return [float(re.search(rf"^{word} ([\d.]+)", run.stdout, re.M)[1]) for word in ("call", "batch")]


def speed(path):
    rows = [line.split("\t") for line in path.read_text(encoding="utf-8").splitlines()]
    rows.sort(key=lambda row: row[0] != "c")
    best = {name: [1e30, 1e30] for name, _, _ in rows}
    for _ in range(ROUNDS):  # the bindings take turns, so that all of them meet the machine's slow moments
        for name, _, command in rows:
            best[name] = [min(pair) for pair in zip(best[name], times(shlex.split(command)))]
    print(f"{'binding':12}{'call [ns]':>12}{'over C [ns]':>13}{'mark':>8}{'2^20 lookups [ms]':>20}{'of C':>8}{'mark':>7}")
    call, batch = best["c"]
    for name, mark, _ in rows:
        own_call, own_batch = best[name]
        print(f"{name:12}{own_call:12.1f}{own_call - call:13.1f}{mark:>8}{own_batch:20.3f}{own_batch / batch:8.3f}"
              f"{'-' if mark == '-' else BATCH_MARK:>7}")
    return 0


if __name__ == "__main__":
    if len(sys.argv) > 2 and sys.argv[1] == "check":
        sys.exit(check(sys.argv[2:]))
    if len(sys.argv) == 3 and sys.argv[1] == "speed":
        sys.exit(speed(pathlib.Path(sys.argv[2])))
    print(__doc__)
    sys.exit(2)
