#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""House rules that a compiler does not see, over the tracked sources of the tree.

    check_style.py includes|third_party|arithmetic|spdx|prose [--root DIR]

Each check prints file:line and what is wrong, and exits 1 if anything is.
"""
import argparse
import pathlib
import re
import sys

sys.dont_write_bytecode = True
import prose

# The data flow. An include may point to the same stage or to one before it; abi may include all.
STAGES = ["core", "data", "simd", "image", "texture", "geometry", "raster", "material", "light", "shade", "film",
          "frame", "extension", "color", "io", "abi"]
SOURCE_SUFFIXES = {".c", ".cpp", ".h", ".hpp", ".inc", ".py", ".sh", ".cmake"}
SOURCE_FOLDERS = ["include", "src", "tests", "bench", "docs", "examples", "bindings"]
DATA_FOLDERS = {"golden", "corpus"}
INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]')
THIRD_PARTY = {
    "OpenColorIO/": {"src/color/ocio.cpp"},
    "OpenImageIO/": {"src/io/oiio.cpp"},
}
FORBIDDEN_CALLS = re.compile(
    r"\b(MulAdd|MulSub|NegMulAdd|NegMulSub|MulAddSub|ApproximateReciprocal\w*|fma|fmaf|ffast-math)\b")


def sources(root, folders, suffixes):
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            relative = path.relative_to(root)
            if path.is_file() and path.suffix in suffixes and not DATA_FOLDERS & set(relative.parts):
                yield relative


def numbered_lines(root, path):
    return enumerate((root / path).read_text(encoding="utf-8").splitlines(), start=1)


def check_includes(root):
    """Includes in src/ name a stage, and point upward in the list of stages."""
    for path in sources(root, ["src"], {".cpp", ".h"}):
        if path.parts[1] not in STAGES:
            yield f"{path}: folder is not a stage"
            continue
        own = STAGES.index(path.parts[1])
        for number, line in numbered_lines(root, path):
            match = INCLUDE.match(line)
            if not match or match.group(1) == "<":
                continue
            stage = match.group(2).split("/")[0]
            if stage not in STAGES:
                yield f"{path}:{number}: \"{match.group(2)}\" does not begin with a stage"
            elif STAGES.index(stage) > own:
                yield f"{path}:{number}: {path.parts[1]} includes {stage}, a later stage"


def check_third_party(root):
    """Headers of OpenColorIO and OpenImageIO stay in one file each; the benchmarks' peers have their own folder."""
    for path in sources(root, ["src", "include"], {".cpp", ".h"}):
        for number, line in numbered_lines(root, path):
            match = INCLUDE.match(line)
            if not match:
                continue
            for prefix, allowed in THIRD_PARTY.items():
                if match.group(2).startswith(prefix) and str(path) not in allowed:
                    yield f"{path}:{number}: {match.group(2)} belongs in {', '.join(sorted(allowed))}"


def check_arithmetic(root):
    """No fused or approximate operation in src/: they change the bits between targets."""
    for path in sources(root, ["src"], {".cpp", ".h"}):
        for number, line in numbered_lines(root, path):
            code = line.split("//")[0]
            match = FORBIDDEN_CALLS.search(code)
            if match:
                yield f"{path}:{number}: {match.group(1)} rounds differently on different targets"


def check_spdx(root):
    """Every source says its licence in the first three lines."""
    lists = [p.relative_to(root) for p in root.rglob("CMakeLists.txt") if "build" not in p.relative_to(root).parts[0]]
    for path in [*sources(root, SOURCE_FOLDERS, SOURCE_SUFFIXES), *sorted(lists)]:
        head = [line for _, line in numbered_lines(root, path)][:3]
        if not any("SPDX-License-Identifier: MIT" in line for line in head):
            yield f"{path}: no SPDX-License-Identifier in the first three lines"


CHECKS = {
    "includes": check_includes,
    "third_party": check_third_party,
    "arithmetic": check_arithmetic,
    "spdx": check_spdx,
    "prose": prose.check,
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("check", choices=sorted(CHECKS))
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    arguments = parser.parse_args()
    problems = list(CHECKS[arguments.check](arguments.root))
    for problem in problems:
        print(problem)
    print(f"style.{arguments.check}: {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
