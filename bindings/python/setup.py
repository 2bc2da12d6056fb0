# SPDX-License-Identifier: MIT
"""Adds shd.json to the package, and libshd or its path.

    SHD_LIBRARY=libshd.so pip install ./bindings/python      records the path
    SHD_BUNDLE=libshd.so pip wheel ./bindings/python         copies the library, and those that it needs besides the
                                                             system's, into a wheel for this platform

SHD_BUNDLE may also have components, and the programs and modules that they open: paths with colons between them.

wheel.sh makes wheels for other systems: it sets SHD_PLATFORM to a tag that audit.py has checked.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:
    from wheel.bdist_wheel import bdist_wheel

HERE = pathlib.Path(__file__).resolve().parent
BUNDLE = [path for path in os.environ.get("SHD_BUNDLE", "").split(os.pathsep) if path]
# Libraries that every Linux system of manylinux has (PEP 600).
SYSTEM = re.compile(r"(?:ld-linux[\w-]*|linux-vdso|lib(?:c|m|dl|rt|pthread|stdc\+\+|gcc_s))\.so\.\d+$")


def needed(library):
    """Paths of the libraries that a library needs, without the system's, under the names that it has for them."""
    run = subprocess.run(["ldd", library], check=True, stdout=subprocess.PIPE, text=True)
    for name, path in re.findall(r"^\s*(\S+) => (\S+)", run.stdout, re.M):
        if path == "not":
            raise FileNotFoundError(f"{library} needs {name}, which was not found")
        if not SYSTEM.match(name) and not name.startswith("libshd"):
            yield name, path


def own_name(path):
    """The name of a file in the wheel: libshd.so.0.1.0 is libshd.so.0.1, as other libraries call it."""
    return re.sub(r"([.]so[.]\d+[.]\d+)[.]\d+$", r"\1", pathlib.Path(path).name)


class Build(build_py):
    def run(self):
        subprocess.run([sys.executable, HERE.parent / "generate.py", "python"], check=True)
        super().run()
        package = pathlib.Path(self.build_lib) / "shd"
        package.mkdir(parents=True, exist_ok=True)
        for old in [package / "_library.txt", package / "shd-io-worker", *package.glob("lib*.so*")]:  # earlier builds
            old.unlink(missing_ok=True)
        shutil.copyfile(HERE.parent / "shd.json", package / "shd.json")
        if BUNDLE:
            for name, path in [*((own_name(b), b) for b in BUNDLE), *(n for b in BUNDLE for n in needed(b))]:
                shutil.copy(path, package / name)
                if shutil.which("strip"):
                    subprocess.run(["strip", "--strip-unneeded", package / name], check=True)
        elif os.environ.get("SHD_LIBRARY"):
            path = pathlib.Path(os.environ["SHD_LIBRARY"]).resolve()
            (package / "_library.txt").write_text(str(path), encoding="utf-8")


class Wheel(bdist_wheel):
    def get_tag(self):
        return ("py3", "none", os.environ.get("SHD_PLATFORM") or super().get_tag()[2])


class Package(Distribution):
    def has_ext_modules(self):
        return bool(BUNDLE)


setup(cmdclass={"build_py": Build, "bdist_wheel": Wheel}, distclass=Package)
