# SPDX-License-Identifier: MIT
"""Adds shd.json to the package, and the path of libshd if SHD_LIBRARY has it."""
import os
import pathlib
import shutil

from setuptools import setup
from setuptools.command.build_py import build_py

HERE = pathlib.Path(__file__).resolve().parent


class Build(build_py):
    def run(self):
        super().run()
        package = pathlib.Path(self.build_lib) / "shd"
        package.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(HERE.parent / "shd.json", package / "shd.json")
        library = os.environ.get("SHD_LIBRARY")
        if library:
            (package / "_library.txt").write_text(str(pathlib.Path(library).resolve()), encoding="utf-8")


setup(cmdclass={"build_py": Build})
