#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""component.py color --build FOLDER --output FOLDER: writes the wheel shd-color.

Its files lie in the folder of the package shd, where the package searches components. Libraries that a component needs
are copied under a name of their own, of equal length: libexpat.so.1 becomes libexpat-1f2e, for the first digits of its
SHA-256. The component finds them by its RPATH, $ORIGIN, which also holds for libraries that it loads.
"""
import argparse
import base64
import hashlib
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]
import audit  # noqa: E402
from elf import Elf  # noqa: E402

# component: (files of the build, packages that are linked in, description)
COMPONENTS = {"color": (["libshd_color.so"], ["libhwy-dev"], "Displays and colour spaces for shd, by OpenColorIO")}


def stripped(path):
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "copy"
        subprocess.run(["strip", "--strip-unneeded", "-o", copy, path], check=True)
        return copy.read_bytes()


def own_name(name, data):
    """A name of equal length with digits of the hash instead of the ending .so.N."""
    stem, ending = re.fullmatch(r"(lib.*?)(\.so\.[\d.]+)", name).groups()
    return f"{stem}-{hashlib.sha256(data).hexdigest()[:len(ending) - 1]}"


def found_by_loader(path):
    """{name: path} of all libraries that a file needs, also indirectly."""
    run = subprocess.run(["ldd", path], check=True, stdout=subprocess.PIPE, text=True)
    return dict(re.findall(r"^\s*(\S+) => (/\S+)", run.stdout, re.M))


def collect(paths):
    """{name in the wheel: bytes} of the files of a component and of the libraries that they need, and the libraries."""
    places = {name: place for path in paths for name, place in found_by_loader(path).items()}
    files, queue, names = {}, list(paths), {}
    while queue:
        path = queue.pop()
        data = stripped(path)
        files[path] = data
        for name in Elf(data).needed:
            if audit.GLIBC.match(name) or name in audit.STDCXX or name.startswith("libshd"):
                continue
            if name not in names:
                library = pathlib.Path(places[name]).resolve()
                names[name] = own_name(name, library.read_bytes())
                queue.append(library)
    renamed = {pathlib.Path(places[old]).resolve(): new for old, new in names.items()}
    return {renamed.get(path, path.name): Elf(data).renamed(names) for path, data in files.items()}, list(renamed)


def packages_of(paths):
    """Names of the Debian packages of libraries."""
    for path in paths:
        # Either path, because /lib is a link to /usr/lib.
        run = subprocess.run(["dpkg", "-S", path, str(path).removeprefix("/usr")], stdout=subprocess.PIPE,
                             stderr=subprocess.DEVNULL, text=True)
        package = run.stdout.split(":")[0]
        if not package:
            raise FileNotFoundError(f"{path} is of no Debian package: its licence is not known")
        yield package


def project():
    """Version of the package."""
    return re.search(r'^version = "(.+)"', (HERE.parent / "pyproject.toml").read_text("utf-8"), re.M)[1]


def write_wheel(path, name, files, licences, version, summary, readme, tag):
    """A wheel after "Binary distribution format" of the Python Packaging User Guide. Equal files make equal bytes."""
    info = f"{name}-{version}.dist-info"
    metadata = (f"Metadata-Version: 2.1\nName: {name.replace('_', '-')}\nVersion: {version}\nSummary: {summary}\n"
                f"License: MIT\nRequires-Python: >=3.9\nRequires-Dist: shd (=={version})\n"
                f"Description-Content-Type: text/markdown\n\n{readme}")
    wheel = f"Wheel-Version: 1.0\nGenerator: shd component.py\nRoot-Is-Purelib: false\nTag: py3-none-{tag}\n"
    members = {**{f"shd/{n}": d for n, d in sorted(files.items())},
               **{f"{info}/licenses/{n}.txt": d for n, d in sorted(licences.items())},
               f"{info}/METADATA": metadata.encode(), f"{info}/WHEEL": wheel.encode()}
    record = []
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as out:
        for member, data in members.items():
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record.append(f"{member},sha256={digest},{len(data)}\n")
            put(out, member, data)
        put(out, f"{info}/RECORD", "".join([*record, f"{info}/RECORD,,\n"]).encode())


def put(out, member, data):
    entry = zipfile.ZipInfo(member)
    entry.external_attr = 0o100644 << 16
    entry.compress_type = zipfile.ZIP_DEFLATED
    out.writestr(entry, data)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("component", choices=COMPONENTS)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="folder of the built libraries")
    parser.add_argument("--output", type=pathlib.Path, required=True)
    options = parser.parse_args()
    names, packages, summary = COMPONENTS[options.component]
    files, copied = collect([(options.build / n).resolve() for n in names])
    files = {next((n for n in names if k.startswith(n)), k): d for k, d in files.items()}  # without .0.1.0
    with tempfile.TemporaryDirectory() as folder:
        paths = []
        for name, data in files.items():
            paths.append(pathlib.Path(folder) / name)
            paths[-1].write_bytes(data)
        tag = audit.tag(paths)
    path = options.output / f"shd_{options.component}-{project()}-py3-none-{tag}.whl"
    licences = {"shd": (HERE.parents[2] / "LICENSE").read_bytes()}
    for package in [*packages, *packages_of(copied)]:
        licences[package] = pathlib.Path(f"/usr/share/doc/{package}/copyright").read_bytes()
    readme = (HERE / f"{options.component}.md").read_text("utf-8")
    write_wheel(path, f"shd_{options.component}", files, licences, project(), summary, readme, tag)
    print(path)


if __name__ == "__main__":
    main()
