# SPDX-License-Identifier: MIT
"""A folder of references: PNG files, and a file of hashes.

A check that fails writes NAME.result.png and NAME.difference.png, or a line of hashes.txt, to a second folder. update()
or an explicit option makes results the references; nothing else changes a reference.
"""
import os
import pathlib
import re

from .difference import Difference
from .flip import PIXELS_PER_DEGREE
from .picture import as_picture, coded, load, picture_hash, save, storable
from .report import side_by_side

NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.+-]*(?:/[A-Za-z0-9_][A-Za-z0-9_.+-]*)*")
HASHES = "hashes.txt"
RESULT, DIFFERENCE = ".result.png", ".difference.png"


class GoldenError(AssertionError):
    """A picture differs from its reference, or has none."""


def _checked(name):
    if not isinstance(name, str) or not NAME.fullmatch(name) or name.endswith((RESULT[:-4], DIFFERENCE[:-4])):
        raise ValueError(f"name: {name!r} is not made of letters, digits and _ . + - with / between folders")
    return name


def read_hashes(path):
    """{name: hash} of a file of lines "hash  name"."""
    hashes = {}
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    for number, line in enumerate(lines, start=1):
        match = re.fullmatch(r"([0-9a-f]{64})  (\S+)", line)
        if not match:
            raise ValueError(f"{path}:{number}: not a SHA-256, two spaces and a name")
        hashes[match[2]] = match[1]
    return hashes


def write_hashes(path, hashes):
    if not hashes:
        path.unlink(missing_ok=True)
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f"{path.name}.{os.getpid()}")
    temporary.write_text("".join(f"{value}  {name}\n" for name, value in sorted(hashes.items())), encoding="utf-8")
    os.replace(temporary, path)


class Store:
    """References in `folder`; results of failed checks go to `failed`, by default the folder failed/ in it."""

    def __init__(self, folder, failed=None, update=False):
        self.folder = pathlib.Path(folder)
        self.failed = pathlib.Path(failed) if failed else self.folder / "failed"
        self.update = update

    def _forget(self, name):
        for ending in (RESULT, DIFFERENCE):
            (self.failed / f"{name}{ending}").unlink(missing_ok=True)

    def check(self, picture, name, pixels_per_degree=PIXELS_PER_DEGREE, **tolerances):
        """Compares a picture with the reference NAME.png; see Difference.exceeded() for the tolerances. Floating-point
        numbers are in [0, 1] and stored with 16 bits. Returns the Difference, or None if the reference was written."""
        __tracebackhide__ = True  # pytest shows the line of the test
        array = as_picture(picture)
        kept, path = storable(array, "picture"), self.folder / f"{_checked(name)}.png"
        if self.update:
            save(path, kept)
            self._forget(name)
            return None
        if not path.exists():
            save(self.failed / f"{name}{RESULT}", kept)
            raise GoldenError(f"{name}: there is no reference {path}. The result is {self.failed / name}{RESULT}. "
                              + self._how())
        both = [load(path), kept]
        if array.dtype.kind == "f" and both[0].dtype == kept.dtype:
            both = [coded(p) for p in both]  # tolerances have the unit of the picture
        difference = Difference(*both, pixels_per_degree)
        problems = difference.exceeded(**tolerances)
        if not problems:
            self._forget(name)
            return difference
        save(self.failed / f"{name}{RESULT}", kept)
        save(self.failed / f"{name}{DIFFERENCE}", side_by_side(difference))
        raise GoldenError(f"{name}: " + "; ".join(problems) + f"\n{difference}\nreference, result and FLIP map: "
                          f"{self.failed / name}{DIFFERENCE}\n" + self._how())

    def check_hash(self, picture, name):
        """Compares the bits of a picture with the hash of a reference. Returns the hash."""
        __tracebackhide__ = True
        value, path = picture_hash(as_picture(picture)), self.folder / HASHES
        stored, waiting = read_hashes(path), read_hashes(self.failed / HASHES)
        want = stored.get(_checked(name))
        if self.update or want == value:
            if want != value:
                write_hashes(path, {**stored, name: value})
            if waiting.pop(name, None):
                write_hashes(self.failed / HASHES, waiting)
            return value
        write_hashes(self.failed / HASHES, {**waiting, name: value})
        text = f"the hash is {value}, and that of the reference is {want}" if want else f"there is no hash in {path}"
        raise GoldenError(f"{name}: {text}. " + self._how())

    def _how(self):
        return f"If the result is right: pytest --shd-update, or python -m shd golden --update {self.folder}"

    def waiting(self):
        """Names of pictures, and of hashes, whose results wait to become references."""
        pictures = sorted(str(p.relative_to(self.failed))[:-len(RESULT)] for p in self.failed.rglob(f"*{RESULT}"))
        return pictures, sorted(read_hashes(self.failed / HASHES))

    def accept(self):
        """Makes the waiting results the references. Returns their names."""
        pictures, hashes = self.waiting()
        for name in pictures:
            (self.folder / f"{name}.png").parent.mkdir(parents=True, exist_ok=True)
            os.replace(self.failed / f"{name}{RESULT}", self.folder / f"{name}.png")
            self._forget(name)
        if hashes:
            new = read_hashes(self.failed / HASHES)
            write_hashes(self.folder / HASHES, {**read_hashes(self.folder / HASHES), **new})
            (self.failed / HASHES).unlink()
        return pictures + hashes
