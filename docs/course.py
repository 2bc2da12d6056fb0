#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs what the pages of the course print: course.py [--check] FOLDER, started by course.sh.

- Every code block of the language sh on a page docs/course*.md has commands. The commands of a page run in one empty
  folder, in their order, and each must succeed.
- Every picture pictures/....png of a page is a file that one of its commands writes. Without --check, pictures of
  pictures/course that have other pixels are replaced; pictures that no page shows are deleted.
- Pictures have the same pixels everywhere: those of shd-render in pictures/course exactly, others within 1 of 255,
  because displays and transforms of other versions round in other ways. Two agree in the mean: rays of --occlusion may
  come from Embree or from depth maps, and the lines of `polygon` move by a pixel where a solver rounds in another way.
- Each row of a table of docs/course-concepts.md names headers or functions that exist, a command that succeeds, and a
  page with its heading.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import struct
import sys
import time
import zlib

import numpy as np

import shd.io

DOCS = pathlib.Path(__file__).resolve().parent
ROOT = DOCS.parent
sys.path.insert(1, str(DOCS / "site"))
import pages  # noqa: E402

CONCEPTS = DOCS / "course-concepts.md"
OWN = "pictures/course/"
BLOCK = re.compile(r"^```sh\n(.*?)^```$", re.S | re.M)
HEADING = re.compile(r"^#+ (.*\S)\s*$", re.M)
PICTURE = re.compile(r"!\[[^\]]*\]\((pictures/[\w/.-]+\.png)\)")
ROW = re.compile(r"^\| (?!concept |---)(.*) \|$", re.M)
NAME = re.compile(r"shd/\w+\.h|(?:shd|SHD)_\w+")
LINK = re.compile(r"\]\((course-[\w-]+\.md)#([\w-]+)\)")
FEWEST_ROWS = 60
MEANS, LARGEST = {"occlusion=|--occlusion": 3.0, "^polygon$": 0.1}, 1  # differences of codes, by patterns of commands


def commands_of(text):
    for block in BLOCK.findall(text):
        yield from (line for line in re.sub(r"\\\n\s*", "", block).splitlines() if line.strip())


def run(command, folder):
    """None, or the problem of a command."""
    started = time.monotonic()
    done = subprocess.run(["bash", "-euc", command], cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode:
        return f"`{command}` exits with {done.returncode}: {done.stderr.strip()[-300:]}"
    if time.monotonic() - started > 20:
        return f"`{command}` takes more than 20 s"
    return None


def read(path):
    """An array [height][width][4] of codes."""
    return np.array(shd.io.load(shd.Context(), str(path), flags="in_process"))


def without_needless(pixels):
    """The first one, three or four channels, which have all that the picture has."""
    if not (pixels[..., 3] == 255).all():
        return pixels
    return pixels[..., :1 if (pixels[..., :3] == pixels[..., :1]).all() else 3]


def smallest_png(pixels):
    """A PNG file with that filter for all rows that makes it the smallest ("PNG Specification", 9.2)."""
    height, width, channels = pixels.shape
    left, up, corner = (np.zeros((height, width * channels), np.int16) for _ in range(3))
    row = pixels.reshape(height, -1).astype(np.int16)
    left[:, channels:], up[1:], corner[1:, channels:] = row[:, :-channels], row[:-1], row[:-1, :-channels]
    a, b, c = (np.abs(left + up - corner - near) for near in (left, up, corner))
    paeth = np.where((a <= b) & (a <= c), left, np.where(b <= c, up, corner))
    filtered = ((row - guess).astype(np.uint8) for guess in (np.zeros_like(row), left, up, (left + up) // 2, paeth))
    packed = (zlib.compress(np.insert(rows, 0, kind, axis=1).tobytes(), 9) for kind, rows in enumerate(filtered))
    header = struct.pack(">IIBBBBB", width, height, 8, {1: 0, 3: 2, 4: 6}[channels], 0, 0, 0)
    chunks = [(b"IHDR", header), (b"sRGB", b"\0"), (b"IDAT", min(packed, key=len)), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body)) for name, body in chunks)


def differences(path, other):
    """Largest and mean difference of the codes of two pictures, or None for pictures of other sizes."""
    pixels, others = read(path), read(other)
    if pixels.shape != others.shape:
        return None
    found = np.abs(pixels.astype(np.int16) - others)
    return int(found.max()), float(found.mean())


def is_same(command, link, found):
    if found is None:
        return False
    for pattern, mean in MEANS.items():
        if re.search(pattern, command):
            return found[1] <= mean
    is_exact = command.startswith("shd-render") and link.startswith(OWN)
    return found[0] <= (0 if is_exact else LARGEST)


def check_picture(page, link, written, check):
    name = link.rpartition("/")[2]
    if name not in written:
        yield f"{page.name}: no command writes {name}"
        return
    made, command = written[name]
    stored = DOCS / link
    found = differences(made, stored) if stored.exists() else None
    if is_same(command, link, found):
        return
    if check or not link.startswith(OWN):
        yield f"{page.name}: {made} is not {stored} (largest and mean difference: {found}); `{command}`"
    else:
        stored.parent.mkdir(exist_ok=True)
        stored.write_bytes(smallest_png(without_needless(read(made))))
        print(f"{link} replaced")


def check_page(page, folder, check):
    """Problems of a page."""
    text = page.read_text(encoding="utf-8")
    folder.mkdir(parents=True)
    problems, written = [], {}
    for command in commands_of(text):
        before = {path: path.stat().st_mtime_ns for path in folder.iterdir()}
        problem = run(command, folder)
        problems += [f"{page.name}: {problem}"] if problem else []
        for path in folder.iterdir():
            if before.get(path) != path.stat().st_mtime_ns:
                written[path.name] = path, command
    for link in dict.fromkeys(PICTURE.findall(text)):
        problems += check_picture(page, link, written, check)
    return problems


def headings(page):
    return {pages.slug(heading) for heading in HEADING.findall(page.read_text(encoding="utf-8"))} if page.exists() else set()


def check_row(row, headers, folder):
    """Problems of a row: a concept, its interface, a command, and a link to a page."""
    cells = [cell.strip() for cell in row.split(" | ")]
    if len(cells) != 4:
        return [f"{len(cells)} cells: {row}"]
    names = NAME.findall(cells[1])
    problems = [f"{name} is not in include/shd: {cells[0]}" for name in names if not re.search(rf"{name}\b", headers)]
    problems += [] if names else [f"no name: {cells[0]}"]
    link = LINK.search(cells[3])
    if not link or link[2] not in headings(DOCS / link[1]):
        problems.append(f"no page {cells[3]}: {cells[0]}")
    folder.mkdir(parents=True)
    problem = run(cells[2].strip("`"), folder)
    return problems + ([problem] if problem else [])


def rows_of_concepts():
    return ROW.findall(CONCEPTS.read_text(encoding="utf-8"))


def names_of_headers():
    folder = ROOT / "include"
    return "\n".join(f"{p.relative_to(folder)}\n{p.read_text(encoding='utf-8')}" for p in sorted(folder.glob("shd/*.h")))


def prefer_this_python(folder):
    """Scripts of the pages run in the interpreter that has NumPy."""
    (folder / "bin").mkdir(parents=True)
    script = folder / "bin/python3"
    script.write_text(f'#!/bin/sh\nexec "{sys.executable}" "$@"\n', encoding="utf-8")
    script.chmod(0o755)
    os.environ["PATH"] = f"{folder / 'bin'}:{os.environ['PATH']}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("folder", type=pathlib.Path)
    options = parser.parse_args()
    folder = options.folder.resolve()
    shutil.rmtree(folder, ignore_errors=True)
    prefer_this_python(folder)
    found, rows, headers = sorted(DOCS.glob("course*.md")), rows_of_concepts(), names_of_headers()
    with concurrent.futures.ThreadPoolExecutor(max(2, os.cpu_count() or 1)) as pool:
        tasks = [pool.submit(check_page, page, folder / page.stem, options.check) for page in found]
        tasks += [pool.submit(check_row, row, headers, folder / f"row{i}") for i, row in enumerate(rows)]
        problems = [problem for task in tasks for problem in task.result()]
    if len(rows) < FEWEST_ROWS:
        problems.append(f"{CONCEPTS.name}: {len(rows)} rows, not {FEWEST_ROWS}")
    shown = {link for page in found for link in PICTURE.findall(page.read_text(encoding="utf-8"))}
    for path in sorted((DOCS / OWN).glob("*.png")):
        if OWN + path.name not in shown:
            if options.check:
                problems.append(f"no page shows {OWN}{path.name}")
            else:
                path.unlink()
    print("\n".join(problems) if problems else f"docs.course: {len(shown)} pictures, {len(rows)} concepts")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
