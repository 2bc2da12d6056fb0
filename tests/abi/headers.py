#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compiles every public header alone, twice over in one unit, as C and C++ of several standards.

    headers.py --include include [--compiler gcc ...]

Absent compilers are named and skipped; at least one must be there.
"""
import argparse
import concurrent.futures
import itertools
import pathlib
import shutil
import subprocess
import sys

WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror"]
STANDARDS = [("c", "c99"), ("c", "c11"), ("c++", "c++11"), ("c++", "c++17")]
STRICT_C = ["-Wstrict-prototypes", "-Wmissing-prototypes"]


def compile_header(compiler, language, standard, include, header):
    # An unused result of a defaults function would warn, so each unit holds only the includes and one object.
    unit = f"#include <shd/{header}>\n#include <shd/{header}>\nextern int shd_unit;\nint shd_unit = 0;\n"
    command = [compiler, f"-std={standard}", "-x", language, "-fsyntax-only", "-I", str(include), *WARNINGS]
    if language == "c":
        command += STRICT_C
    run = subprocess.run([*command, "-"], input=unit, capture_output=True, text=True)
    return run.returncode, f"{compiler} -std={standard} shd/{header}\n{run.stderr}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--include", type=pathlib.Path, required=True)
    parser.add_argument("--compiler", nargs="+", default=["gcc", "clang"])
    arguments = parser.parse_args()
    present = [c for c in arguments.compiler if shutil.which(c)]
    for compiler in sorted(set(arguments.compiler) - set(present)):
        print(f"{compiler}: not installed, skipped")
    headers = sorted(p.name for p in (arguments.include / "shd").glob("*.h"))
    if not present or not headers:
        print("no compiler or no headers")
        return 1
    jobs = [(c, language, standard, arguments.include, h)
            for c, (language, standard), h in itertools.product(present, STANDARDS, headers)]
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        results = list(pool.map(lambda job: compile_header(*job), jobs))
    failures = [text for code, text in results if code]
    print("\n".join(failures))
    print(f"{len(headers)} headers, {len(present)} compilers, {len(STANDARDS)} standards: "
          f"{len(jobs) - len(failures)} of {len(jobs)} units compile")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
