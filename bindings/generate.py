#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the lower layers of the bindings from shd.json. They are not in git.

    generate.py [LANGUAGE...]      csharp, js, lua, python, rust; by default all of them

The build of the tests and the scripts that make packages run it. Whoever uses a binding from a clone runs it once.
"""
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
LANGUAGES = ["csharp", "js", "lua", "python", "rust"]


def main(languages):
    unknown = set(languages) - set(LANGUAGES)
    if unknown:
        print(__doc__)
        return 2
    for language in languages or LANGUAGES:
        subprocess.run([sys.executable, HERE / language / "generate.py"], check=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
