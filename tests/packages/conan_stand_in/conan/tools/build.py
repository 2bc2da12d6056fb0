# SPDX-License-Identifier: MIT
from conan.errors import ConanInvalidConfiguration


def check_min_cppstd(conanfile, least):
    given = str(conanfile.settings.compiler.cppstd).replace("gnu", "")
    if int(given) < int(least):
        raise ConanInvalidConfiguration(f"C++ {given} is older than the required C++ {least}")


def stdcpp_library(conanfile):
    """The C++ library that a program in C links, by the setting compiler.libcxx."""
    names = {"libstdc++": "stdc++", "libstdc++11": "stdc++", "libc++": "c++"}
    return names.get(conanfile.settings.compiler.get_safe("libcxx"))
