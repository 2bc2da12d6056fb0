# SPDX-License-Identifier: MIT
import os
import pathlib
import subprocess

from conan.errors import ConanException


def cmake_layout(conanfile, src_folder="."):
    """The folders of a package with one configuration."""
    build_type = conanfile.settings.build_type
    conanfile.source_folder = str(conanfile.base / src_folder)
    conanfile.build_folder = str(conanfile.base / "build" / build_type)
    conanfile.generators_folder = str(conanfile.base / "build" / build_type / "generators")


class CMakeToolchain:
    """Writes the cache variables as an initial cache, which CMake.configure() reads."""

    def __init__(self, conanfile):
        self.conanfile, self.cache_variables = conanfile, {}

    def generate(self):
        conanfile = self.conanfile
        values = {"CMAKE_BUILD_TYPE": conanfile.settings.build_type, "BUILD_SHARED_LIBS": conanfile.options.shared,
                  **self.cache_variables}
        if not conanfile.options.shared:
            values["CMAKE_POSITION_INDEPENDENT_CODE"] = conanfile.options.fPIC
        lines = []
        for name, value in values.items():
            kind, text = ("BOOL", "ON" if value else "OFF") if isinstance(value, bool) else ("STRING", value)
            lines.append(f'set({name} "{text}" CACHE {kind} "")\n')
        path = pathlib.Path(conanfile.generators_folder) / "conan_cache.cmake"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("".join(lines), encoding="utf-8")


class CMakeDeps:
    """Requirements come from the system, so that only the names of properties are checked."""
    NAMES = {"cmake_file_name", "cmake_target_name", "cmake_find_mode", "cmake_target_aliases"}

    def __init__(self, conanfile):
        self.conanfile = conanfile

    def set_property(self, dependency, name, value):
        if name not in self.NAMES:
            raise ConanException(f"no property {name}")
        if dependency.partition("::")[0] not in {reference.partition("/")[0] for reference in self.conanfile.required}:
            raise ConanException(f"{dependency} is not required")

    def generate(self):
        pass


class CMake:
    def __init__(self, conanfile):
        self.conanfile = conanfile

    @staticmethod
    def run(*command):
        subprocess.run([os.environ.get("CMAKE", "cmake"), *command], check=True)

    def configure(self):
        conanfile = self.conanfile
        self.run("-S", conanfile.source_folder, "-B", conanfile.build_folder, "-G", "Ninja",
                 "-C", f"{conanfile.generators_folder}/conan_cache.cmake",
                 f"-DCMAKE_INSTALL_PREFIX={conanfile.package_folder}", "-DCMAKE_INSTALL_LIBDIR=lib",
                 *os.environ.get("HARNESS_CMAKE_OPTIONS", "").split())

    def build(self):
        self.run("--build", self.conanfile.build_folder, "-j", os.environ.get("JOBS", "1"))

    def install(self):
        self.run("--install", self.conanfile.build_folder)
