#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs `mypy --strict` on the stubs and on programs: good ones pass, and each marked line of bad.py fails. Compares the
stubs with the module by mypy's stubtest.

    check_types.py [PROGRAM...]      also checks these programs

Exit code 77: mypy is absent.
"""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
PACKAGE = HERE.parent.parent


# Differences that stubs may have: parts of the implementation that users do not call, attributes that are computed, and
# the plugin of pytest where that is absent.
MEANT = re.compile(r"shd\.(?:\w+\.)*_|is not present in stub|differs from runtime type shd\.pyrender\._checked\.Checked|"
                   r"is read-only at runtime|(?:Item|Model)\.__init__ is inconsistent, stub does not have argument|"
                   r"Difference\.flip |shd\.pytest_plugin failed to import, .*'pytest'")


def run_tool(folder, tool, *arguments):
    """Lines that a tool of mypy prints. It writes its cache into the folder."""
    paths = {"MYPYPATH": str(PACKAGE), "PYTHONPATH": str(PACKAGE), "PYTHONDONTWRITEBYTECODE": "1"}
    run = subprocess.run([sys.executable, "-m", tool, *map(str, arguments)], env={**os.environ, **paths}, cwd=folder,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if run.returncode > 1:
        sys.exit(f"{tool} failed:\n{run.stdout}")
    return run.stdout.splitlines()


def mypy(folder, *paths):
    return run_tool(folder, "mypy", "--config-file", HERE / "mypy.ini", "--strict", "--no-error-summary", *paths)


def differences(folder):
    """Differences between the stubs and the module."""
    config = ("--mypy-config-file", HERE / "stubtest.ini")
    return [line for line in run_tool(folder, "mypy.stubtest", "shd", "--concise", *config) if not MEANT.search(line)]


def missing_errors(path, lines):
    """Texts about marked lines without their error, and about errors on other lines."""
    found = {}
    for line in lines:
        place = re.match(r".*bad\.py:(\d+): error: (.*)", line)
        if place:
            found.setdefault(int(place[1]), []).append(place[2])
    for number, text in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        mark = re.search(r"  # (.+)$", text)
        messages = found.pop(number, [])
        if mark and not any(mark[1] in message for message in messages):
            yield f"bad.py:{number}: no error with {mark[1]!r}, but {messages}"
        elif messages and not mark:
            yield f"bad.py:{number}: {messages}"


def main():
    if importlib.util.find_spec("mypy") is None or importlib.util.find_spec("numpy") is None:
        print(f"skipped: {sys.executable} has no mypy or no NumPy (Debian: mypy python3-numpy)")
        return 77
    more = [pathlib.Path(name).resolve() for name in sys.argv[1:]]
    good = [HERE / "good.py", *sorted((PACKAGE / "examples").glob("*.py")), *more]
    stubs = sorted(PACKAGE.glob("shd/**/*.pyi"))
    if len(stubs) < 8:
        sys.exit(f"{len(stubs)} stubs are in {PACKAGE / 'shd'}: run bindings/generate.py python")
    bad = HERE / "bad.py"
    with tempfile.TemporaryDirectory() as folder:
        problems = mypy(folder, *good, *stubs) + list(missing_errors(bad, mypy(folder, bad))) + differences(folder)
    for problem in problems:
        print(problem)
    marks = len(re.findall(r"  # ", bad.read_text(encoding="utf-8")))
    print(f"mypy --strict: {len(good)} programs and {len(stubs)} stubs, {marks} mistakes, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
