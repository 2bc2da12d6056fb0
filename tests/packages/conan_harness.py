#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the recipe of Conan without Conan: the methods in Conan's order, with the modules of conan_stand_in/.

    conan_harness.py RECIPE --archive ARCHIVE --work FOLDER

First, recipes with bad options are refused with a message that names the option. Then a package is built from the
archive, with requirements from the system, and programs are compiled with what package_info() says of it: the harness
prints those options of the compiler on its last line. What this cannot show: packages of a Conan remote, profiles,
CMakeDeps.
"""
import argparse
import hashlib
import importlib.util
import pathlib
import subprocess
import sys
import tarfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "conan_stand_in"))
import conan
from conan.errors import ConanInvalidConfiguration

# Where a requirement is on this system: a name of pkg-config.
SYSTEM = {"highway::highway": "libhwy", "onetbb::onetbb": "tbb", "opencolorio::opencolorio": "OpenColorIO",
          "openimageio::openimageio": "OpenImageIO", "assimp::assimp": "assimp",
          "nlohmann_json::nlohmann_json": "nlohmann_json"}


def load(path):
    spec = importlib.util.spec_from_file_location("conanfile", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    (recipe,) = [value for value in vars(module).values()
                 if isinstance(value, type) and issubclass(value, conan.ConanFile) and value is not conan.ConanFile]
    return recipe


def settings(os="Linux", cppstd="17"):
    compiler = conan.Compiler(name="gcc", version="12", cppstd=cppstd, libcxx="libstdc++11")
    return conan.Settings(os=os, arch="x86_64", build_type="Release", compiler=compiler)


def validated(recipe, folder, options, data=None, version="0", **given):
    """A recipe after the methods that Conan calls before the sources are there."""
    conanfile = recipe(folder, version, options, settings(**given), data)
    if "auto_shared_fpic" in conanfile.implements and conanfile.options.shared:
        conanfile.options.rm_safe("fPIC")
    conanfile.layout()
    conanfile.requirements()
    conanfile.validate()
    return conanfile


def check_refusals(recipe, folder):
    for options, given, word in (({"with_scene": True}, {}, "with_scene"), ({}, {"os": "Windows"}, "os"),
                                 ({}, {"cppstd": "14"}, "14")):
        try:
            validated(recipe, folder, options, **given)
        except ConanInvalidConfiguration as error:
            if word not in str(error):
                raise SystemExit(f"the message does not name {word}: {error}")
            print(f"refused: {error}")
        else:
            raise SystemExit(f"{options} {given} was not refused")
    try:
        validated(recipe, folder, {"simd": "sse9"})
    except ValueError as error:
        print(f"refused: {error}")
    else:
        raise SystemExit("simd=sse9 was not refused")


def check_components(recipe, folder):
    """Each requirement is used by a component, and each component requires what is there."""
    options = {"with_color": True, "with_io": True, "with_scene": True}
    conanfile = validated(recipe, folder, options)
    conanfile.package_info()
    components = conanfile.cpp_info.components
    packages = {reference.partition("/")[0] for reference in conanfile.required}
    used = set()
    for name, component in components.items():
        for required in component.requires:
            package, separator, _ = required.partition("::")
            if separator and package not in packages or not separator and required not in components:
                raise SystemExit(f"component {name} requires {required}, which is not there")
            used |= {package} if separator else set()
    if used != packages:
        raise SystemExit(f"no component uses {packages - used}")
    print("components:", *components)


def create(recipe, folder, archive):
    with tarfile.open(archive) as files:
        version = files.next().name.partition("/")[0].rpartition("-")[2]
    data = {"sources": {version: {"url": archive.as_uri(), "sha256": hashlib.sha256(archive.read_bytes()).hexdigest()}}}
    conanfile = validated(recipe, folder, {"simd": "scalar"}, data, version)
    conanfile.source()
    conanfile.generate()
    conanfile.build()
    conanfile.package()
    conanfile.package_info()
    return conanfile


def check_package(conanfile):
    package = pathlib.Path(conanfile.package_folder)
    for name in ("licenses/LICENSE", "include/shd/shd.h", "include/shd.hpp"):
        if not (package / name).is_file():
            raise SystemExit(f"the package has no {name}")
    for name, component in conanfile.cpp_info.components.items():
        for library in component.libs:
            if not list((package / "lib").glob(f"lib{library}.*")):
                raise SystemExit(f"component {name}: no lib{library} in the package")
    if list(package.rglob("*.cmake")) or list(package.rglob("*.pc")):
        raise SystemExit("the package has files for CMake or pkg-config; Conan writes its own")


def flags(conanfile, name):
    """Options of the compiler for a component and all that it requires."""
    package, component = pathlib.Path(conanfile.package_folder), conanfile.cpp_info.components[name]
    own = [f"-I{package / folder}" for folder in component.includedirs]
    own += [f"-L{package / folder}" for folder in component.libdirs] + [f"-l{library}" for library in component.libs]
    for required in component.requires:
        if "::" in required:
            command = ["pkg-config", "--cflags", "--libs", SYSTEM[required]]
            own += subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout.split()
        else:
            own += flags(conanfile, required)
    return own + [f"-l{library}" for library in component.system_libs]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("recipe", type=pathlib.Path)
    parser.add_argument("--archive", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True)
    given = parser.parse_args()
    recipe = load(given.recipe)
    check_refusals(recipe, given.work)
    check_components(recipe, given.work)
    conanfile = create(recipe, given.work, given.archive.resolve())
    check_package(conanfile)
    print(*flags(conanfile, "shd"), flush=True)


if __name__ == "__main__":
    main()
