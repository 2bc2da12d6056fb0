#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that a wheel runs on every system of its platform tag, after PEP 600.

    audit.py WHEEL...             exit code 1 if a library needs what the tag does not promise
    audit.py --tag FILE...        prints the tag that ELF files allow, such as manylinux_2_28_x86_64
    --libstdc++                   allows libstdc++.so.6 and libgcc_s.so.1, in versions that the tag promises

A library may need libraries of glibc and of the wheel itself, and symbols up to the version of glibc in the tag. It may
search the wheel's own folders only. Bundled libraries have a name of their own, because the loader takes the first
library of a name that is in the process.
"""
import argparse
import pathlib
import posixpath
import re
import sys
import zipfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "wheel"))
from elf import Elf  # noqa: E402

GLIBC = re.compile(r"(?:lib(?:c|m|dl|pthread|rt)\.so\.\d|ld-linux-[\w-]+\.so\.\d)$")
STDCXX = {"libstdc++.so.6", "libgcc_s.so.1"}
# glibc -> newest versions of libstdc++ and libgcc in all systems with it, from the releases of gcc that they ship
COMPILERS = {28: ((3, 4, 25), (1, 3, 11)), 31: ((3, 4, 28), (1, 3, 12)), 34: ((3, 4, 29), (1, 3, 13)),
             36: ((3, 4, 30), (1, 3, 13))}
OLDEST = (2, 28)  # nothing older is tested


def numbers(text):
    return tuple(int(n) for n in re.findall(r"\d+", text))


def glibc_of(file):
    """The newest version of glibc among the symbols of a file: ((major, minor), names of libraries)."""
    found = [numbers(version) for _, version in file.versions if version.startswith("GLIBC_2")]
    return max(found, default=(0, 0))[:2]


def compiler_problems(file, glibc):
    """Versions of libstdc++ that systems with this glibc may not have."""
    limits = [limit for minor, limit in COMPILERS.items() if glibc >= (2, minor)]
    newest = limits[-1] if limits else COMPILERS[28]
    for library, version in sorted(file.versions):
        for prefix, limit in zip(("GLIBCXX_", "CXXABI_"), newest):
            if version.startswith(prefix) and numbers(version) > limit:
                yield f"needs {version} of {library}, newer than {prefix}{'.'.join(map(str, limit))}"


def problems(name, file, glibc, machine, bundled, options):
    """Texts about one library `name` of a wheel with the given tag."""
    yield from file.problems
    if file.machine != machine:
        yield f"is for {file.machine}, and the tag names {machine}"
    for needed in file.needed:
        allowed = bool(GLIBC.match(needed)) or needed in bundled
        if not allowed and not (needed in STDCXX and options.libstdcxx):
            yield f"needs {needed}, which is neither of glibc nor in the wheel"
    for library, version in sorted(file.versions):
        if version.startswith("GLIBC_") and not re.fullmatch(r"GLIBC_2[\d.]+", version):
            yield f"needs {version} of {library}, which is private"
        elif version.startswith("GLIBC_") and numbers(version)[:2] > glibc:
            yield f"needs {version} of {library}, newer than glibc {glibc[0]}.{glibc[1]}"
    yield from compiler_problems(file, glibc)
    for folder in file.rpath:
        inside = posixpath.normpath(posixpath.join(posixpath.dirname(name) or ".", folder.replace("$ORIGIN", ".", 1)))
        if not re.match(r"\$ORIGIN(?:/|$)", folder) or inside.startswith(".."):
            yield f"searches {folder!r}, which is not a folder of the wheel"
    # The loader takes a library that is already in the process for one of equal name.
    if file.soname and re.match(r"lib.*\.so\.\d", file.soname) and not file.soname.startswith("libshd"):
        yield f"has the name {file.soname}, which a library of the system may have, too"


def audit(path, options):
    """(texts about a wheel, what its libraries need)."""
    match = re.fullmatch(r"[\w.]+-[\w.]+-\w+-\w+-(manylinux_(\d+)_(\d+)|linux)_(\w+)\.whl", path.name)
    if not match:
        return [f"{path.name}: the name has no tag manylinux_2_N_MACHINE or linux_MACHINE"], ""
    if match[1] == "linux":
        glibc = (99, 99)
    else:
        glibc = int(match[2]), int(match[3])
    found, files, names = [], {}, []
    with zipfile.ZipFile(path) as wheel:
        for name in wheel.namelist():
            data = wheel.read(name)
            names.append(posixpath.basename(name))
            if data.startswith(b"\x7fELF"):
                files[name] = Elf(data)
    bundled = {f.soname for f in files.values()} | set(names) | set(options.beside)
    if not files:
        found.append("the wheel has no library")
    for name, file in files.items():
        found += [f"{name}: {text}" for text in problems(name, file, glibc, match[4], bundled, options)]
    newest = max(map(glibc_of, files.values()), default=(0, 0))
    others = sorted({n for f in files.values() for n in f.needed if not GLIBC.match(n)})
    return found, (f"{path.name}: {path.stat().st_size / 1e6:.2f} MB, {len(files)} libraries, glibc "
                   f"{newest[0]}.{newest[1]}; needs besides glibc: {', '.join(others) or 'nothing'}")


def tag(paths):
    """The tag that the symbols of files allow."""
    files = [Elf(path.read_bytes()) for path in paths]
    newest = max([OLDEST, *map(glibc_of, files)])
    while any(True for f in files for _ in compiler_problems(f, newest)) and newest < (2, max(COMPILERS)):
        newest = (2, newest[1] + 1)
    return f"manylinux_{newest[0]}_{newest[1]}_{files[0].machine}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    parser.add_argument("--tag", action="store_true")
    parser.add_argument("--libstdc++", dest="libstdcxx", action="store_true")
    parser.add_argument("--beside", action="append", default=[], metavar="NAME", help="a library in another wheel")
    options = parser.parse_args()
    try:
        if options.tag:
            print(tag(options.files))
            return 0
        failed = False
        for path in options.files:
            found, summary = audit(path, options)
            print(*filter(None, [summary, *found]), sep="\n")
            failed |= bool(found)
        return int(failed)
    except (ValueError, OSError, zipfile.BadZipFile) as problem:
        print(f"audit: {problem}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
