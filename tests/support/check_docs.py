#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What README.md and docs/ claim about the tree.

    check_docs.py [--root DIR] [--compiler cc]

- README has at most 150 lines, and its first program is a part of examples/hello.c, without its indentation.
- Every name shd_* or SHD_* is in the public headers, and every constant of shd_filter has a page.
- Every relative link and picture is there, and every heading that a link names.
- docs/index.md, docs/course.md, docs/filters.md or docs/tutorial.md links every page, and the menu of the site has it.
- The whole programs of the tutorial are the files of examples/ that their pages name, without the line of the licence.
- Every test that a page names in backticks is in CTest, and its source contains the case that follows the name.
- docs/build.md, CMakeLists.txt and CMakePresets.json name the same version of CMake.
- The packages of all languages, the newest part of CHANGELOG.md and the pages have the version of CMakeLists.txt.
- The C examples of the pages compile as C99, without warnings. An example without functions is the body of one, with the
  usual handles at hand.

Prints file:line and what is wrong, and exits 1 if anything is.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import textwrap

LINK = re.compile(r"\]\(([^)#\s]*)(?:#([^)\s]*))?\)")
HEADING = re.compile(r"^#+ (.*\S)\s*$", re.M)
CODE = re.compile(r"^```.*?^```$", re.S | re.M)
# Names of CMake options and of the environment, and of files and folders, are no names of the interface.
NAME = re.compile(r"(?<![\w./-])(?:shd_[a-z0-9_]+|SHD_[A-Z0-9_]+[A-Z0-9])(?![\w-]|\.\w)")
OTHER = re.compile(r"SHD_(?:WITH|BUILD|DOCS|BENCH)_\w+|SHD_(?:SIMD|UNITY|DEB|WERROR|SANITIZE|INSTALL|NO_INSTALL|LIBRARY|LIB_DIR|BUNDLE)|shd_(?:color|io)")

# A test, and a case of it up to a `*`.
TEST = re.compile(r"`((?:abi|api|consumer|fuzz|tool|unit)\.[\w.-]*\w)(?: ([^`]+))?`")
# Names of tests in CMake files; `${...}` in a name is any word.
CMAKE_TEST = re.compile(r"(?:add_test\(NAME|shd_script_test\(|shd_test\() *([\w.${}-]+)")
FUZZ_TEST = re.compile(r"shd_fuzz_target\((\w+) \d+[ )]")
EXAMPLE = re.compile(r"^```c\n(.*?)^```$", re.S | re.M)
# Headers, handles and a result for examples without functions.
HANDLES = """#include <shd/color.h>
#include <shd/io.h>
#include <shd/scene.h>
#include <shd/shd.h>
#include <shd/texture_file.h>
#include <shd/tile_file.h>
#include <shd/volume_file.h>
void example(shd_context *context, shd_texture *texture, shd_sampler *sampler, shd_material *material);
void example(shd_context *context, shd_texture *texture, shd_sampler *sampler, shd_material *material)
{
shd_result result = SHD_OK;
"""
WARNINGS = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wshadow", "-Werror"]


def pages(root):
    return [root / "README.md", root / ".github/SECURITY.md", root / "examples/course/README.md",
            *sorted((root / "docs").glob("*.md")), *sorted((root / "docs").glob("*.html"))]


def check_names(path, text, names):
    for number, line in enumerate(text.splitlines(), start=1):
        for name in NAME.findall(line):
            prefix = name.endswith("_") or f"{name}_..." in line
            known = any(n.startswith(name) for n in names) if prefix else name in names
            if not known and not OTHER.fullmatch(name):
                yield f"{path.name}:{number}: {name} is not in include/shd"


def headings(path):
    """The names that GitHub and the site give to the headings of a page."""
    text = CODE.sub("", path.read_text(encoding="utf-8"))
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in HEADING.findall(text)}


def check_links(root, path, text):
    for number, line in enumerate(text.splitlines(), start=1):
        for link, heading in LINK.findall(line):
            target = path.parent / link if link else path
            if "://" in link:
                continue
            if not target.exists():
                yield f"{path.relative_to(root)}:{number}: {link} is not there"
            elif heading and target.suffix == ".md" and heading not in headings(target):
                yield f"{path.relative_to(root)}:{number}: {link} has no heading {heading}"


def find_tests(root):
    """Sources by the names of their tests, and patterns for the names in CMake files; as tests/CMakeLists.txt."""
    sources = {}
    for path in sorted((root / "tests").glob("api/test_*.c*")):
        sources["api." + path.stem.removeprefix("test_")] = path
    for path in sorted((root / "tests").glob("unit/*/test_*.cpp")):
        sources[f"unit.{path.parent.name}.{path.stem.removeprefix('test_')}"] = path
    patterns = []
    for path in [*root.glob("tests/CMakeLists.txt"), *root.glob("tests/*/CMakeLists.txt")]:
        text = path.read_text(encoding="utf-8")
        names = [name for name in CMAKE_TEST.findall(text) if "${name}" not in name]  # in functions
        patterns += [re.escape(re.sub(r"\$\{\w+\}", "@", n)).replace("@", r"\w+") for n in names]
        patterns += [f"fuzz\\.{name}" for name in FUZZ_TEST.findall(text)]
    return sources, patterns


def is_case_of(root, case, source):
    """Whether a source may have this case: it or a header of tests/support has a string that begins with the name, with
    the part before a `*`, or with a part before or after a `/`."""
    text = source.read_text(encoding="utf-8")
    for header in re.findall(r'#include "(support/[^"]+)"', text):
        text += (root / "tests" / header).read_text(encoding="utf-8")
    parts = {case.rstrip("*"), case.split("*")[0].rstrip("/"), case.rsplit("/", 1)[0], case.rsplit("/", 1)[-1]}
    return any(part and f'"{part}' in text for part in parts)


def check_tests(root, tests, path, text):
    sources, patterns = tests
    for number, line in enumerate(text.splitlines(), start=1):
        for name, case in TEST.findall(line):
            if name not in sources and not any(re.fullmatch(pattern, name) for pattern in patterns):
                yield f"{path.name}:{number}: no test {name}"
            elif case and not (name in sources and is_case_of(root, case, sources[name])):
                yield f"{path.name}:{number}: test {name} has no case {case}"


def hello_contains(root, code):
    """Whether the lines are a part of examples/hello.c, which CTest compiles and runs."""
    return bool(code.strip()) and textwrap.indent(code, "    ") in (root / "examples/hello.c").read_text(encoding="utf-8")


def check_examples(root, compiler, path, text):
    for match in EXAMPLE.finditer(text):
        code = match.group(1)
        if hello_contains(root, code):
            continue
        if not re.search(r"^#include", code, re.M):
            code = f"{HANDLES}{code}(void)context, (void)texture, (void)sampler, (void)material, (void)result;\n}}\n"
        command = [compiler, *WARNINGS, "-fsyntax-only", f"-I{root / 'include'}", f"-I{path.parent}", "-x", "c", "-"]
        run = subprocess.run(command, input=code, capture_output=True, text=True, check=False)
        if run.returncode:
            line = text.count("\n", 0, match.start()) + 1
            yield f"{path.relative_to(root)}:{line}: the example does not compile\n{run.stderr}"


def check_cmake_version(root):
    """The version in CMakeLists.txt, which FILE_SET needs, and what else names one."""
    text = (root / "CMakeLists.txt").read_text(encoding="utf-8")
    version = re.search(r"cmake_minimum_required\(VERSION (\d+\.\d+)\)", text).group(1)
    presets = json.loads((root / "CMakePresets.json").read_text(encoding="utf-8"))["cmakeMinimumRequired"]
    page = (root / "docs/build.md").read_text(encoding="utf-8")
    if re.findall(r"CMake (\d+\.\d+)", page) != [version]:
        yield f"docs/build.md: CMake is not {version}"
    if f"{presets['major']}.{presets['minor']}" != version:
        yield f"CMakePresets.json: CMake is not {version}"


# Files with versions of shd, and how they write them.
VERSIONS = {
    "CHANGELOG.md": r"^## \[([\d.]+)\]",
    "bindings/csharp/Shd.csproj": r"<Version>([\d.]+)<",
    "bindings/js/package.json": r'"version": "([\d.]+)"',
    "bindings/js/README.md": r"shd-([\d.]+)\.tgz",
    "bindings/python/pyproject.toml": r'^version = "([\d.]+)"',
    "bindings/rust/Cargo.lock": r'name = "shd[-\w]*"\nversion = "([\d.]+)"',
    "bindings/rust/shd-sys/Cargo.toml": r'^version = "([\d.]+)"',
    "bindings/rust/shd/Cargo.toml": r'(?<!-)version = "([\d.]+)"',
    "docs/bindings.md": r"shd-([\d.]+)\.tgz",
    "src/packaging/vcpkg/shd/vcpkg.json": r'"version": "([\d.]+)"',
}


def check_version(root):
    text = (root / "CMakeLists.txt").read_text(encoding="utf-8")
    version = re.search(r"^project\(shd VERSION ([\d.]+)", text, re.M)[1]
    for name, pattern in VERSIONS.items():
        found = re.findall(pattern, (root / name).read_text(encoding="utf-8"), re.M)
        found = found[:1] if name == "CHANGELOG.md" else found
        if not found:
            yield f"{name}: no version of shd"
        yield from (f"{name}: {other} is not {version}, the version of CMakeLists.txt" for other in found if other != version)


def check(root, compiler):
    headers = "\n".join(p.read_text(encoding="utf-8") for p in sorted((root / "include/shd").glob("*.h")))
    names = set(re.findall(r"\b(?:shd|SHD)_\w+", headers))
    readme = (root / "README.md").read_text(encoding="utf-8")
    if readme.count("\n") > 150:
        yield "README.md: more than 150 lines"
    first = EXAMPLE.search(readme)
    if not first or not hello_contains(root, first.group(1)):
        yield "README.md: its first program is not a part of examples/hello.c"
    yield from check_cmake_version(root)
    yield from check_version(root)
    yield from check_lists(root)
    yield from check_tutorial(root)
    tests = find_tests(root)
    for path in pages(root):
        if not path.exists():
            continue
        text = path.read_text(encoding="utf-8")
        yield from check_names(path, text, names)
        yield from check_links(root, path, text)
        yield from check_tests(root, tests, path, text)
        yield from check_examples(root, compiler, path, text)
    for path in (root / "CHANGELOG.md", root / ".github/CONTRIBUTING.md"):  # old names, and names of the build
        yield from check_links(root, path, path.read_text(encoding="utf-8"))
    for filter_name in re.findall(r"SHD_FILTER_(\w+) = \d+,", headers):
        page = root / f"docs/filter-{filter_name.lower().replace('_', '-')}.md"
        if not page.exists():
            yield f"docs: SHD_FILTER_{filter_name} has no page"


def check_lists(root):
    """The pages with lists name every other page, and so does the menu of the site."""
    lists = "".join((root / "docs" / f"{name}.md").read_text(encoding="utf-8") for name in ("index", "course", "filters", "tutorial"))
    menu = (root / "docs/site/mkdocs.yml").read_text(encoding="utf-8")
    for page in sorted((root / "docs").glob("*.md")):
        if page.name != "index.md" and f"]({page.name})" not in lists:
            yield f"docs/index.md: {page.name} is not in its lists"
        if not re.search(rf"[:-] {re.escape(page.name)}$", menu, re.M):
            yield f"docs/site/mkdocs.yml: {page.name} is not in nav"


def check_tutorial(root):
    """Each page of the tutorial has its whole program, which CTest compiles and runs."""
    for page in sorted((root / "docs").glob("tutorial-*.md")):
        text = page.read_text(encoding="utf-8")
        names = re.findall(r"^`(examples/[\w/]+\.c)`:$", text, re.M)
        programs = [match.group(1) for match in EXAMPLE.finditer(text) if "int main(" in match.group(1)]
        files = [(root / name).read_text(encoding="utf-8").split("\n", 1)[1] for name in names]
        if not programs or programs != files:
            yield f"docs/{page.name}: its program is not {' '.join(names) or 'named'}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    parser.add_argument("--compiler", default="cc")
    arguments = parser.parse_args()
    problems = list(check(arguments.root, arguments.compiler))
    print("\n".join(problems) if problems else "style.docs: 0 problems")
    return 1 if problems else 0


sys.exit(main())
